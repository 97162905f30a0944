"""Places, which can be read and written, and expressions."""

from typing import TypeAlias

from fbgen.lang.ast import node
from fbgen.lang.checked.variables import Address, Block, Variable
from fbgen.lang.types import Elementary, ReferenceType, Scalar, Type
from fbgen.source import Span


@node
class VariableRef:
    """A variable of the block itself, or a global one."""

    span: Span
    variable: Variable
    type: Type


@node
class FieldRef:
    """A part of a structure, or a parameter or static of an instance; `name` as declared."""

    span: Span
    base: "Place"
    name: str
    type: Type


@node
class IndexRef:
    """An element of an array; the base has an `ArrayType` with as many bounds as `indices`.

    With an `OpenArrayType` the bounds are those of the argument.
    """

    span: Span
    base: "Place"
    indices: tuple["Expression", ...]
    type: Type


@node
class SliceRef:
    """Part `index` (0 = least significant) of a bit string or integer; `type` says how wide."""

    span: Span
    base: "Place"
    index: int
    type: Elementary


@node
class AddressRef:
    """An absolute address that is read or written directly."""

    span: Span
    address: Address
    type: Elementary


@node
class MemoryRef:
    """An absolute address that is worked out when the program runs.

    `area` is a code as PEEK takes it: 16#81 inputs, 16#82 outputs, 16#83 bit memory, 16#84 the data
    block with the number `db`, 1 the hardware's inputs, 2 its outputs. `bit` only for BOOL. All are
    whole numbers of any type, evaluated in the order area, db, byte, bit. The type is elementary,
    or that of a whole area which an instruction gets (`P#DB1.DBX0.0 BYTE 10`).
    """

    span: Span
    area: "Expression"
    db: "Expression | None"
    byte: "Expression"
    bit: "Expression | None"
    type: Type


@node
class BoundOf:
    """The first or (`upper`) the last index of a dimension, from 0, of an ARRAY[*]."""

    span: Span
    base: "Place"
    dimension: int
    upper: bool
    type: Elementary


@node
class Dereference:
    """What the reference at `base` refers to; the program stops where that is nothing.

    With a VARIANT as base, which has been asked for its type, `type` is that type; it is VARIANT
    for a whole area which an instruction gets.
    """

    span: Span
    base: "Place"
    type: Type


Place: TypeAlias = (
    VariableRef | FieldRef | IndexRef | SliceRef | AddressRef | MemoryRef | Dereference
)


@node
class Constant:
    """A value known before the program runs."""

    span: Span
    value: Scalar
    type: Type


@node
class Unary:
    """NOT or - on an operand of the same type."""

    span: Span
    operator: str
    operand: "Expression"
    type: Type


@node
class Binary:
    """Two operands and an operator: OR XOR AND OR_ELSE AND_THEN + - * / MOD ** = <> < > <= >=.

    OR_ELSE and AND_THEN take BOOL and leave their right side out where the left one decides.
    Both operands have the same type, except: TIME * and / take a number on the right; ** takes any
    number on the right. Comparisons give BOOL, everything else the type of its left operand.
    DIV is "/" on integers. Integer division cuts towards zero, MOD has the sign of the dividend.
    """

    span: Span
    operator: str
    left: "Expression"
    right: "Expression"
    type: Type


@node
class Convert:
    """A change of type. `implicit` if nobody wrote it. See `conversions` for what each pair does.

    `rounding` is "nearest" (ties to even) or "truncate"; it matters from REAL to whole numbers.
    """

    span: Span
    operand: "Expression"
    type: Type
    implicit: bool = False
    rounding: str = "nearest"


@node
class StandardCall:
    """A standard function without side effects, such as SHL, LIMIT, MAX, ABS, SEL, LEN.

    `name` is the canonical IEC name in upper case; arguments are positional, converted and complete
    (defaults filled in).
    """

    span: Span
    name: str
    arguments: tuple["Expression", ...]
    type: Type


@node
class ReferenceTo:
    """A new reference to a place, as REF and ADR make it; `place` None is NULL.

    A VARIANT refers to a place of any type, also to one that is gone after the call.
    """

    span: Span
    place: Place | None
    type: ReferenceType


@node
class SameReference:
    """BOOL: two references refer to the same variable, or both to nothing."""

    span: Span
    left: "Expression"
    right: "Expression"
    type: Elementary


@node
class TypeTest:
    """BOOL: what a VARIANT refers to has a type (`types.is_of_type`); FALSE for NULL.

    With `of_elements` it is an array, and its elements have the type.
    """

    span: Span
    variant: "Expression"
    of_elements: bool
    wanted: Type
    type: Elementary


@node
class SameTypes:
    """BOOL: what two VARIANTs refer to has the same type; FALSE if one of them is NULL.

    `of_elements` says for each side whether the elements of an array are meant.
    """

    span: Span
    left: "Expression"
    right: "Expression"
    of_elements: tuple[bool, bool]
    type: Elementary


@node
class ElementCount:
    """How many elements the array has that a VARIANT refers to; 0 for what is no array."""

    span: Span
    variant: "Expression"
    type: Elementary


@node
class FunctionCall:
    """A call of a FUNCTION of the user. Every input has a value, every in-out a place.

    A method is a FUNCTION with the instance as first in-out, called THIS. Where derived blocks
    override it, `overrides` has all that can be meant, by the name of the instance's block, and the
    type of the instance decides while the program runs. Their parameters have the same names, types
    and order.
    """

    span: Span
    function: Block
    inputs: tuple[tuple[Variable, "Expression"], ...]
    in_outs: tuple[tuple[Variable, Place], ...]
    outputs: tuple[tuple[Variable, Place], ...]
    type: Type
    overrides: tuple[tuple[str, Block], ...] = ()


@node
class SystemCall:
    """A call of an instruction of the controller that works on hardware or memory (DPRD_DAT ...).

    `arguments` has every parameter by its canonical upper-case name: an expression for inputs, a
    place for outputs and for areas (ANY, VARIANT). The result is the instruction's RET_VAL.
    """

    span: Span
    name: str
    arguments: tuple[tuple[str, "Expression"], ...]
    type: Type


@node
class Attempt:
    """The value of `operand`; `flag`, a BOOL, becomes FALSE if that does not work.

    It does not work if a whole number does not fit into the type of the result (of + - *, of a
    changed sign, of a conversion): the value is then wrapped around as ever. And if it would stop
    the program: by a division by zero, a number out of range, a text or BCD pattern that is no
    number, a MUX selector without input; the value is then zero or the empty text. `flag` stays as
    it is where it does work. Only what `operand` itself does counts, not what is inside of it,
    unless that would stop the program.
    """

    span: Span
    operand: "Unary | Binary | Convert | StandardCall"
    flag: VariableRef
    type: Type


@node
class Substituted:
    """The value of a place; zero or empty where the place cannot be reached.

    That is noted in `memory`, a DWORD, unless that has noted something already. What goes wrong in
    a block that is called on the way to the place stops the program as ever.
    """

    span: Span
    place: Place
    memory: VariableRef
    type: Type


@node
class TakenError:
    """The ERROR_ID that is noted in `memory`, which is then empty; 0 if there is none."""

    span: Span
    memory: VariableRef
    type: Elementary


WORKS = "ENO"
"""The output of a `RoutineCall` that says whether it works."""


@node
class RoutineCall:
    """A call of an instruction that takes values and gives values, several at once.

    Inputs are evaluated in their order, the instruction runs, then the outputs are found and
    written in theirs. An in-out stands in both. `RET_VAL` as an output is the result itself, and
    `WORKS` is ENO.
    `type` is VOID where there is no result. `instance` is the instance of a block that the harness
    has no model for; then the call is what the user's stub makes of it. RESET_TIMER and
    PRESET_TIMER have the timer there.
    """

    span: Span
    name: str
    inputs: tuple[tuple[str, "Expression"], ...]
    outputs: tuple[tuple[str, Place], ...]
    type: Type
    instance: Place | None = None


Expression: TypeAlias = (
    Constant
    | Place
    | Unary
    | Binary
    | Convert
    | StandardCall
    | BoundOf
    | ReferenceTo
    | SameReference
    | TypeTest
    | SameTypes
    | ElementCount
    | FunctionCall
    | SystemCall
    | RoutineCall
    | Attempt
    | Substituted
    | TakenError
)
