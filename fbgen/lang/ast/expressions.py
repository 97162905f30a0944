"""Expressions: literals, names, operations, calls, initial values."""

from enum import Enum
from typing import TypeAlias

from fbgen.lang.ast.node import Trivia, TriviaList, node
from fbgen.source import Span


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
    ENUMERATOR = "enumerator"
    POINTER = "pointer"


@node
class Literal:
    """A constant as written in `text`, with its `value`.

    `value`: bool, int, float or str (without quotes, escapes resolved); durations in nanoseconds;
    dates, and dates with a time, in nanoseconds since 1970-01-01, times of day in nanoseconds since
    midnight. `type_name` is the prefix of `WORD#16#FF` or `T#5s` as a
    canonical type name ("WORD", "TIME"), else "". `base` is 2, 8, 10 or 16. For `Colour#red` the
    value is "red" and the type name "Colour", both as written. A pointer (`P#M0.0`, type name
    "POINTER") or area (`P#DB1.DBX0.0 BYTE 10`, "ANY") has its text behind `P#`, in upper case with
    single blanks, as value.
    """

    span: Span
    kind: LiteralKind
    value: bool | int | float | str
    text: str
    type_name: str = ""
    base: int = 10


@node
class Name:
    """A name: `x`, `#x` (`local`), `"x"` (`quoted`), `#"x"` (both).

    `outer`: `.x` of CODESYS, the global variable even where a local one has the same name.
    """

    span: Span
    name: str
    quoted: bool = False
    local: bool = False
    outer: bool = False


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

    `area` is "I", "Q", "M", "DB", "T" (timer) or "C" (counter); `size` is "X", "B", "W", "D", "L",
    or "" for timers and counters, which have their number in `byte`; `bit` only with "X"; `db` only
    with area "DB"; `peripheral` for `:P` and for the classic PIB/PQB spelling. `%I*`, `%QW*`: an
    address that is still to be given, with `byte` -1; `size` may be "" then. `german`: written with
    E, A, Z for I, Q, C.
    """

    span: Span
    area: str
    size: str
    byte: int
    bit: int = 0
    db: int = 0
    peripheral: bool = False
    german: bool = False


@node
class IndexedAddress:
    """An absolute address that is worked out at run time.

    `PEB[i]`, `MW[i]`, `M[i, j]` (`base` None), `DB100.DW[i]`, `"values".DX[i, j]`,
    `WORD_TO_BLOCK_DB(w).DW[i]` (`base` says which data block); TIA spells them `%MW(i)`,
    `%DB100.DW(i)`, `EB(1):P`. Area and size as in `DirectAddress`, area "DB" with a base; the
    second index is the bit. `#block.%DBX4.1` of TIA, whose base is of type DB_ANY, has literals as
    indices and is `marked`.
    """

    span: Span
    base: "Expression | None"
    area: str
    size: str
    indices: tuple["Expression", ...]
    peripheral: bool = False
    german: bool = False
    marked: bool = False


@node
class Peripheral:
    """`"tag":P`: a tag of the input or output area, past the process image."""

    span: Span
    base: "Expression"


@node
class Dereference:
    """`base^`: what a reference or pointer points to; also `THIS^` and `SUPER^`."""

    span: Span
    base: "Expression"


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
    quoted: bool = False


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
    """Two operands; `operator` is upper case: OR XOR AND = <> < > <= >= + - * / MOD DIV **,
    OR_ELSE and AND_THEN. `&` is read as AND.
    """

    span: Span
    operator: str
    left: "Expression"
    right: "Expression"


@node
class Chained:
    """The rest of `a := b := c` behind the first `:=`: it assigns, and has the assigned value.

    Stands only as value of an `Assignment` or of another `Chained`; operators as in `Assignment`.
    """

    span: Span
    target: "Expression"
    operator: str
    value: "Expression"


@node
class Parenthesized:
    """`(x)`: kept, so that text comes back as it was written."""

    span: Span
    inner: "Expression"


@node
class ArrayLiteral:
    """`[1, 2, 3(0)]`: initial values of an array; `bare`: without brackets, as in STEP 7."""

    span: Span
    items: tuple["Repeated | Expression", ...]
    bare: bool = False


@node
class Repeated:
    """`3(0)` inside an array literal; `value` None for empty brackets, `count` a constant.

    Of several values, `2(0, 1)`, `value` is a bare array literal.
    """

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
    | IndexedAddress
    | Peripheral
    | Dereference
    | Call
    | Unary
    | Binary
    | Chained
    | Parenthesized
    | ArrayLiteral
    | Repeated
    | StructLiteral
)
