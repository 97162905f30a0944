"""Types and declarations."""

from typing import TypeAlias

from fbgen.lang.ast.expressions import Argument, DirectAddress, Expression, Name
from fbgen.lang.ast.node import Trivia, TriviaList, node
from fbgen.source import Span


@node
class NamedType:
    """An elementary type, a UDT, a function block: whatever the name means.

    A name in a namespace has its dots: `Motors.Axis`; one with values for VAR_GENERIC has these:
    `Buffer<6, true>`.
    """

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


@node
class UnionSpec:
    """UNION ... END_UNION: all fields begin at the same byte."""

    span: Span
    fields: tuple["Declaration", ...]
    closing: TriviaList = ()
    opening: Trivia | None = None


@node
class Enumerator:
    """One name of an enumeration, with its value if one is given."""

    span: Span
    name: str
    value: Expression | None
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class EnumSpec:
    """`(red, green := 5)`; `base` as in `INT (red, green)` or `(red, green) INT`."""

    span: Span
    enumerators: tuple[Enumerator, ...]
    base: NamedType | None
    closing: TriviaList = ()


@node
class SubrangeSpec:
    """`INT (0..100)`."""

    span: Span
    base: NamedType
    first: Expression
    last: Expression


@node
class ReferenceSpec:
    """`REF_TO t`, `REFERENCE TO t`, `POINTER TO t`: `keyword` has these words in upper case."""

    span: Span
    keyword: str
    target: "TypeSpec"


TypeSpec: TypeAlias = (
    NamedType
    | StringSpec
    | ArraySpec
    | StructSpec
    | UnionSpec
    | EnumSpec
    | SubrangeSpec
    | ReferenceSpec
)


@node
class DeclaredName:
    """A declared name with its own attributes `{...}` (raw text with braces, or "")."""

    span: Span
    name: str
    quoted: bool = False
    attributes: str = ""


@node
class Declaration:
    """`a, b AT %IB0 : INT := 5;` `at` is a direct address or the name of an overlaid variable.

    `arguments` are those that CODESYS hands to FB_init: `pump : Pump(11, speed := 50.0);`, or one
    list in brackets with those of each element: `pumps : ARRAY[1..2] OF Pump[(11), (12)];`
    `edge` is "R_EDGE" or "F_EDGE" behind the type of an input; `operator` is ":=", or "REF=" where
    a reference is bound: `r : REFERENCE TO INT REF= x;`
    """

    span: Span
    names: tuple[DeclaredName, ...]
    type: TypeSpec
    initial: Expression | None
    at: DirectAddress | Name | None = None
    type_attributes: str = ""
    leading: TriviaList = ()
    trailing: Trivia | None = None
    arguments: tuple[Argument, ...] = ()
    edge: str = ""
    operator: str = ":="


@node
class VarSection:
    """VAR_INPUT ... END_VAR. `keyword` upper case: VAR, VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT,
    VAR_TEMP, VAR_STAT, VAR_INST, VAR_GLOBAL, VAR_EXTERNAL, VAR_GENERIC, VAR_CONFIG, whose names
    have dots: `Main.pump.speed`. `qualifiers` upper case: CONSTANT, RETAIN, PUBLIC, ... A CONST
    section of STEP 7 is a VAR section with the qualifier CONSTANT; its constants have the type of
    their value, which is `NamedType` with the name "".
    """

    span: Span
    keyword: str
    qualifiers: tuple[str, ...]
    declarations: tuple[Declaration, ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()
    opening: Trivia | None = None


@node
class LabelSection:
    """LABEL a, b; END_LABEL: the jump labels that a block of STEP 7 declares."""

    span: Span
    names: tuple[Name, ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()
