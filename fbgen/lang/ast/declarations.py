"""Types and declarations."""

from typing import TypeAlias

from fbgen.lang.ast.expressions import DirectAddress, Expression, Name
from fbgen.lang.ast.node import Trivia, TriviaList, node
from fbgen.source import Span


@node
class NamedType:
    """An elementary type, a UDT, a function block: whatever the name means."""

    span: Span
    name: str
    quoted: bool = False


@node
class StringSpec:
    """STRING, STRING[80], WSTRING(40); `length` None if not given."""

    span: Span
    wide: bool
    length: Expression | None


@node
class Bounds:
    """`first..last` of one dimension; both None for `*`."""

    span: Span
    first: Expression | None
    last: Expression | None


@node
class ArraySpec:
    """ARRAY [bounds] OF element."""

    span: Span
    bounds: tuple[Bounds, ...]
    element: "TypeSpec"


@node
class StructSpec:
    """STRUCT ... END_STRUCT."""

    span: Span
    fields: tuple["Declaration", ...]
    closing: TriviaList = ()
    opening: Trivia | None = None


TypeSpec: TypeAlias = NamedType | StringSpec | ArraySpec | StructSpec


@node
class DeclaredName:
    """A declared name with its own attributes `{...}` (raw text with braces, or "")."""

    span: Span
    name: str
    quoted: bool = False
    attributes: str = ""


@node
class Declaration:
    """`a, b AT %IB0 : INT := 5;` `at` is a direct address or the name of an overlaid variable."""

    span: Span
    names: tuple[DeclaredName, ...]
    type: TypeSpec
    initial: Expression | None
    at: DirectAddress | Name | None = None
    type_attributes: str = ""
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class VarSection:
    """VAR_INPUT ... END_VAR. `keyword` upper case: VAR, VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT,
    VAR_TEMP, VAR_GLOBAL, VAR_EXTERNAL, CONST. `qualifiers` upper case: CONSTANT, RETAIN, ...
    """

    span: Span
    keyword: str
    qualifiers: tuple[str, ...]
    declarations: tuple[Declaration, ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()
    opening: Trivia | None = None
