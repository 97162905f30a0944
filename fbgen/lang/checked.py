"""The checked program: what the text means. Every name is resolved, every type is known.

The checker makes it from syntax trees; the engines run it. Conversions that the language leaves
out are written out (`Convert`), constants are folded into `Constant`, named constants are gone,
overloaded functions are settled, so an engine never has to guess. Nodes are as in `ast`: never
changed, compared by identity, each with the span of what was written. Long chains of operands are
left-deep trees: walk them with a loop down the left side, not by recursion.

Evaluation: operands from left to right, both sides of AND and OR always (an engine may leave the
right side out where that cannot be noticed), of AND_THEN and OR_ELSE only as needed; the arguments
of a call before the call. `Binary` and `Unary` wrap around in the width of their type; REAL results
are rounded to 32 bit.
"""

from collections.abc import Mapping
from dataclasses import field
from enum import Enum
from typing import TYPE_CHECKING, TypeAlias

from fbgen.lang.ast import BlockKind, node
from fbgen.lang.types import Elementary, Initial, Scalar, StructType, Type
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang import ast


class VariableKind(Enum):
    """Where a variable lives and who may write it."""

    INPUT = "input"
    OUTPUT = "output"
    IN_OUT = "in-out"
    STATIC = "static"
    TEMP = "temporary"
    RESULT = "result"
    GLOBAL = "global"


@node
class Address:
    """An absolute address. `area` is "I", "Q", "M" or "DB"; `bits` is 1, 8, 16, 32 or 64."""

    area: str
    bits: int
    byte: int
    bit: int = 0
    db: int = 0
    peripheral: bool = False


@node
class Variable:
    """A variable. `initial` None is the default of the type; `address` only for located ones.

    GLOBAL covers the data blocks of S7 and VAR_GLOBAL: a data block is one global variable whose
    type is its structure, or the function block of which it is the instance. `remanent` is RETAIN.
    TEMP and RESULT start anew with each call, the others keep their value.

    `overlay`: the variable lies in the memory of that one (AT), which is no overlay itself; an
    overlay of a parameter is STATIC or TEMP.
    """

    span: Span
    name: str
    kind: VariableKind
    type: Type
    initial: Initial | None = None
    remanent: bool = False
    address: Address | None = None
    overlay: "Variable | None" = None


@node
class StandardBlock:
    """A function block that comes with the controller (TON, R_TRIG, CTU ...).

    `name` is the canonical IEC name. `variables` are its inputs and outputs in their order; each
    engine brings the behaviour.
    """

    name: str
    variables: tuple[Variable, ...]


@node
class Block:
    """A block with code, as checked.

    `variables` holds everything declared in it, parameters in their order; a FUNCTION with a result
    has `result`, which is also in `variables`. The body of a block is filled in after all
    interfaces are known, through `Program.bodies`.
    """

    span: Span
    name: str
    kind: BlockKind
    variables: tuple[Variable, ...]
    result: Variable | None
    syntax: "ast.Block"


AnyBlock: TypeAlias = Block | StandardBlock


# --- places: what can be read and written ------------------------------------------------------


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
    """An element of an array; the base has an `ArrayType` with as many bounds as `indices`."""

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


Place: TypeAlias = VariableRef | FieldRef | IndexRef | SliceRef | AddressRef | MemoryRef


# --- expressions ------------------------------------------------------------------------------


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
class FunctionCall:
    """A call of a FUNCTION of the user. Every input has a value, every in-out a place."""

    span: Span
    function: Block
    inputs: tuple[tuple[Variable, "Expression"], ...]
    in_outs: tuple[tuple[Variable, Place], ...]
    outputs: tuple[tuple[Variable, Place], ...]
    type: Type


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


Expression: TypeAlias = (
    Constant | Place | Unary | Binary | Convert | StandardCall | FunctionCall | SystemCall | Attempt
)


# --- statements -------------------------------------------------------------------------------


@node
class Assignment:
    """`target := value`. Structures and arrays are copied. Types are equal.

    An assignment whose target is an output of a call has been moved into the call.
    """

    span: Span
    target: Place
    value: Expression


@node
class Evaluate:
    """A function called for its side effects; the result is dropped."""

    span: Span
    call: FunctionCall | SystemCall


@node
class InstanceCall:
    """A call of a function block instance. Inputs that are not given keep their value."""

    span: Span
    instance: Place
    block: AnyBlock
    inputs: tuple[tuple[Variable, Expression], ...]
    in_outs: tuple[tuple[Variable, Place], ...]
    outputs: tuple[tuple[Variable, Place], ...]


@node
class Branch:
    """A condition and what is done when it holds."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]


@node
class If:
    """The first branch whose condition holds, else `otherwise`."""

    span: Span
    branches: tuple[Branch, ...]
    otherwise: tuple["Statement", ...]


@node
class CaseArm:
    """Statements for the values in any of the inclusive ranges."""

    span: Span
    ranges: tuple[tuple[int, int], ...]
    body: tuple["Statement", ...]


@node
class Case:
    """The first arm that has the selector's value, else `otherwise`."""

    span: Span
    selector: Expression
    arms: tuple[CaseArm, ...]
    otherwise: tuple["Statement", ...]


@node
class For:
    """Counts `variable` from `first` to `last`, both converted to its type, inclusive.

    `last` and `step` are evaluated once. After the last pass the variable is one step further
    (FOR i := 0 TO 7 leaves 8) unless EXIT ended it; if that step leaves the range of the type the
    loop ends and the variable wraps around.
    """

    span: Span
    variable: Place
    first: Expression
    last: Expression
    step: Expression
    body: tuple["Statement", ...]


@node
class While:
    """As long as the condition holds."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]


@node
class Repeat:
    """At least once, until the condition holds."""

    span: Span
    body: tuple["Statement", ...]
    condition: Expression


@node
class Exit:
    """Leave the innermost loop."""

    span: Span


@node
class Continue:
    """Go on with the next pass of the innermost loop."""

    span: Span


@node
class Return:
    """Leave the block."""

    span: Span


@node
class Label:
    """A place in a list of statements that `Goto` can go on at; `name` is casefolded."""

    span: Span
    name: str


@node
class Goto:
    """Go on behind the `Label` with that name.

    The label stands in the same block, in the lists around the jump or inside of an IF or CASE in
    one of them, but never inside of a loop that the jump is not in. `backward`: the label stands
    before the jump in the text; such a jump counts as a pass of a loop.
    """

    span: Span
    label: str
    backward: bool


Statement: TypeAlias = (
    Assignment
    | Evaluate
    | InstanceCall
    | If
    | Case
    | For
    | While
    | Repeat
    | Exit
    | Continue
    | Return
    | Label
    | Goto
)


# --- the program ------------------------------------------------------------------------------


@node
class Task:
    """A task of a configuration: period in nanoseconds (None: free running), lower is earlier."""

    name: str
    interval_ns: int | None
    priority: int
    programs: tuple[tuple[str, Block], ...]


@node
class Program:
    """All blocks, types and global variables of a set of files.

    The mappings are keyed by the casefolded name. `bodies` has the statements of every block.
    `dialect` chooses between the rules of S7 and IEC where they differ.

    `byte_memory` has what is reached besides its name and lies in bytes as `fbgen.lang.layout`
    says: overlays and what is under them, addressed data blocks, the variables of their function
    blocks. `data_blocks` are those with a number.
    """

    dialect: str
    blocks: Mapping[str, Block]
    bodies: Mapping[Block, tuple[Statement, ...]]
    structures: Mapping[str, StructType]
    globals: Mapping[str, Variable]
    standard_blocks: Mapping[str, StandardBlock]
    tasks: tuple[Task, ...] = field(default=())
    byte_memory: frozenset[Variable] = field(default=frozenset())
    data_blocks: Mapping[int, Variable] = field(default_factory=dict)

    def block_of(self, type_name: str) -> AnyBlock:
        """The function block of that name, the user's before the standard one."""
        key = type_name.casefold()
        return self.blocks[key] if key in self.blocks else self.standard_blocks[key]
