"""The syntax tree: what was written, in every dialect, with the place of each piece.

Nodes are never changed after they were built; type checkers enforce it (`frozen_default`), while
at run time the classes are plain, because building frozen ones costs three times as much and the
parser builds millions. Nodes compare and hash by identity, so they can be keys of side tables.

Comments, blank lines and pragmas between the lines are `Trivia` and hang on the statement,
declaration or block that follows (`leading`), on the one before in the same line (`trailing`), or
on the end of a list (`closing`), so that printing gives them back.

Names are kept as written, without quotes and without `#`; `quoted` and `local` say how they stood.
PLC names do not depend on case: compare `name.casefold()`.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING, TypeAlias, TypeVar, dataclass_transform

from fbgen.source import Source, Span

_C = TypeVar("_C", bound=type)

if TYPE_CHECKING:

    @dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
    def node(cls: _C) -> _C: ...
else:
    node: Callable[[type], type] = dataclass(slots=True, eq=False)


class TriviaKind(Enum):
    """What stands between the tokens and is kept."""

    LINE_COMMENT = "// comment"
    BLOCK_COMMENT = "(* comment *)"
    PRAGMA = "{ pragma }"
    BLANK_LINE = "blank line"


@node
class Trivia:
    """A comment with its delimiters, a pragma with its braces, or one blank line (no text)."""

    span: Span
    kind: TriviaKind
    text: str


TriviaList: TypeAlias = tuple[Trivia, ...]


# --- expressions ------------------------------------------------------------------------------


class LiteralKind(Enum):
    """How a literal was written; its type may follow from where it stands."""

    BOOL = "BOOL"
    INTEGER = "integer"
    REAL = "real"
    DURATION = "duration"
    DATE = "date"
    TIME_OF_DAY = "time of day"
    DATE_AND_TIME = "date and time"
    STRING = "string"
    WSTRING = "wide string"


@node
class Literal:
    """A constant as written in `text`, with its `value`.

    `value`: bool, int, float or str (without quotes, escapes resolved); durations in nanoseconds;
    dates in days since 1990-01-01, times of day in nanoseconds since midnight, date and time in
    nanoseconds since 1970-01-01. `type_name` is the prefix of `WORD#16#FF` or `T#5s` as a
    canonical type name ("WORD", "TIME"), else "". `base` is 2, 8, 10 or 16.
    """

    span: Span
    kind: LiteralKind
    value: bool | int | float | str
    text: str
    type_name: str = ""
    base: int = 10


@node
class Name:
    """A name: `x`, `#x` (`local`), `"x"` (`quoted`), `#"x"` (both)."""

    span: Span
    name: str
    quoted: bool = False
    local: bool = False


@node
class Member:
    """`base.name`."""

    span: Span
    base: "Expression"
    name: str
    quoted: bool = False


@node
class Index:
    """`base[i]` or `base[i, j]`."""

    span: Span
    base: "Expression"
    indices: tuple["Expression", ...]


@node
class Slice:
    """`base.%X0`, `.%B1`, `.%W0`, `.%D0`; `size` is "X", "B", "W" or "D". IEC `w.3`: "X"."""

    span: Span
    base: "Expression"
    size: str
    index: int


@node
class DirectAddress:
    """`%IB256`, `%QW4:P`, `%MX0.3`, `%DB100.DW4`: an absolute address.

    `area` is "I", "Q", "M" or "DB"; `size` is "X", "B", "W", "D" or "L"; `bit` only with "X";
    `db` only with area "DB"; `peripheral` for `:P` and for the classic PIB/PQB spelling.
    """

    span: Span
    area: str
    size: str
    byte: int
    bit: int = 0
    db: int = 0
    peripheral: bool = False


class ArgumentKind(Enum):
    """How an argument was written."""

    POSITIONAL = ""
    INPUT = ":="
    OUTPUT = "=>"


@node
class Argument:
    """One argument of a call; `name` is "" for a positional one, `value` None for `name =>`."""

    span: Span
    kind: ArgumentKind
    name: str
    value: "Expression | None"
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Call:
    """`f(a, b)`, `"FB_DB"(x := 1, y => z)`, `#inst(...)`: a call of whatever it is."""

    span: Span
    callee: "Expression"
    arguments: tuple[Argument, ...]


@node
class Unary:
    """`NOT x`, `-x`, `+x`; `operator` is upper case."""

    span: Span
    operator: str
    operand: "Expression"


@node
class Binary:
    """Two operands; `operator` is upper case: OR XOR AND = <> < > <= >= + - * / MOD DIV **.

    `&` is read as AND.
    """

    span: Span
    operator: str
    left: "Expression"
    right: "Expression"


@node
class Parenthesized:
    """`(x)`: kept, so that text comes back as it was written."""

    span: Span
    inner: "Expression"


@node
class ArrayLiteral:
    """`[1, 2, 3(0)]`: initial values of an array."""

    span: Span
    items: tuple["Repeated | Expression", ...]


@node
class Repeated:
    """`3(0)` inside an array literal; `value` None for empty brackets, `count` a constant."""

    span: Span
    count: "Expression"
    value: "Expression | None"


@node
class StructLiteral:
    """`(a := 1, b := 2)`: initial values of a structure or an instance."""

    span: Span
    fields: tuple[Argument, ...]


Expression: TypeAlias = (
    Literal
    | Name
    | Member
    | Index
    | Slice
    | DirectAddress
    | Call
    | Unary
    | Binary
    | Parenthesized
    | ArrayLiteral
    | Repeated
    | StructLiteral
)


# --- statements -------------------------------------------------------------------------------


@node
class Assignment:
    """`target := value;` `operator` is ":=", "+=", "-=", "*=" or "/="."""

    span: Span
    target: Expression
    operator: str
    value: Expression
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class CallStatement:
    """A call that stands alone."""

    span: Span
    call: Call
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Branch:
    """A condition with its statements: IF ... THEN or ELSIF ... THEN."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()


@node
class ElseBranch:
    """The statements behind ELSE, of IF or CASE."""

    span: Span
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()


@node
class If:
    """IF with its ELSIFs; `trailing` is behind END_IF."""

    span: Span
    branches: tuple[Branch, ...]
    otherwise: ElseBranch | None
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class LabelRange:
    """`1..5` as a CASE label."""

    span: Span
    first: Expression
    last: Expression


@node
class CaseArm:
    """`1, 3..5: statements`."""

    span: Span
    labels: tuple[Expression | LabelRange, ...]
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None
    closing: TriviaList = ()


@node
class Case:
    """CASE ... END_CASE; `opening` is behind OF."""

    span: Span
    selector: Expression
    arms: tuple[CaseArm, ...]
    otherwise: ElseBranch | None
    leading: TriviaList = ()
    trailing: Trivia | None = None
    opening: Trivia | None = None


@node
class For:
    """FOR variable := first TO last BY step DO body END_FOR."""

    span: Span
    variable: Expression
    first: Expression
    last: Expression
    step: Expression | None
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    opening: Trivia | None = None
    closing: TriviaList = ()
    trailing: Trivia | None = None


@node
class While:
    """WHILE condition DO body END_WHILE."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]
    leading: TriviaList = ()
    opening: Trivia | None = None
    closing: TriviaList = ()
    trailing: Trivia | None = None


@node
class Repeat:
    """REPEAT body UNTIL condition END_REPEAT."""

    span: Span
    body: tuple["Statement", ...]
    condition: Expression
    leading: TriviaList = ()
    opening: Trivia | None = None
    closing: TriviaList = ()
    trailing: Trivia | None = None


@node
class Region:
    """REGION title ... END_REGION; both lines are free text to their end (TIA only)."""

    span: Span
    title: str
    body: tuple["Statement", ...]
    end_text: str = ""
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Jump:
    """EXIT, CONTINUE or RETURN; `keyword` is upper case."""

    span: Span
    keyword: str
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Goto:
    """GOTO label."""

    span: Span
    label: str
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Label:
    """`label:` in front of a statement."""

    span: Span
    name: str
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Empty:
    """A lone semicolon."""

    span: Span
    leading: TriviaList = ()
    trailing: Trivia | None = None


Statement: TypeAlias = (
    Assignment
    | CallStatement
    | If
    | Case
    | For
    | While
    | Repeat
    | Region
    | Jump
    | Goto
    | Label
    | Empty
)


# --- types and declarations -------------------------------------------------------------------


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


# --- blocks -----------------------------------------------------------------------------------


@node
class HeaderItem:
    """A line of the block header: TITLE, AUTHOR, FAMILY, NAME, VERSION or attributes.

    `keyword` is upper case, "{}" for attributes; `text` is the raw text behind the keyword
    (without `=` or `:`), for attributes the text with its braces.
    """

    span: Span
    keyword: str
    text: str


class BlockKind(Enum):
    """What kind of block it is, by its keyword."""

    FUNCTION_BLOCK = "FUNCTION_BLOCK"
    FUNCTION = "FUNCTION"
    ORGANIZATION_BLOCK = "ORGANIZATION_BLOCK"
    PROGRAM = "PROGRAM"


@node
class Block:
    """A block with code. `return_type` only for a FUNCTION; NamedType "Void" without result."""

    span: Span
    kind: BlockKind
    name: Name
    return_type: TypeSpec | None
    header: tuple[HeaderItem, ...]
    sections: tuple[VarSection, ...]
    body: tuple[Statement, ...]
    leading: TriviaList = ()
    header_comments: TriviaList = ()
    body_comments: TriviaList = ()
    closing: TriviaList = ()


@node
class DataBlock:
    """DATA_BLOCK: either its own structure (`struct` or `sections`) or of a type (`type`)."""

    span: Span
    name: Name
    header: tuple[HeaderItem, ...]
    type: NamedType | None
    struct: StructSpec | None
    sections: tuple[VarSection, ...]
    assignments: tuple[Assignment, ...]
    leading: TriviaList = ()
    header_comments: TriviaList = ()
    closing: TriviaList = ()


@node
class TypeDeclaration:
    """TYPE name : spec; END_TYPE, one per type. `initial` as in `TYPE t : INT := 5; END_TYPE`."""

    span: Span
    name: Name
    header: tuple[HeaderItem, ...]
    type: TypeSpec
    initial: Expression | None = None
    leading: TriviaList = ()
    header_comments: TriviaList = ()
    closing: TriviaList = ()


@node
class Task:
    """TASK name(INTERVAL := T#10ms, PRIORITY := 0);"""

    span: Span
    name: str
    properties: tuple[Argument, ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class ProgramInstance:
    """PROGRAM name WITH task : type;  `task` "" without WITH."""

    span: Span
    name: str
    task: str
    type: NamedType
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Resource:
    """RESOURCE name ON type ... END_RESOURCE."""

    span: Span
    name: str
    on: str
    sections: tuple[VarSection, ...]
    tasks: tuple[Task, ...]
    programs: tuple[ProgramInstance, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Configuration:
    """CONFIGURATION name ... END_CONFIGURATION."""

    span: Span
    name: str
    sections: tuple[VarSection, ...]
    resources: tuple[Resource, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Globals:
    """A VAR_GLOBAL section outside of a configuration."""

    span: Span
    section: VarSection


Unit: TypeAlias = Block | DataBlock | TypeDeclaration | Configuration | Globals


@node
class File:
    """Everything that one source holds, in its order."""

    source: Source
    dialect: str
    units: tuple[Unit, ...]
    closing: TriviaList = ()
