"""Variables and the blocks that they belong to."""

from enum import Enum
from typing import TYPE_CHECKING, TypeAlias

from fbgen.lang.ast import BlockKind, node
from fbgen.lang.types import Initial, Type
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang import ast


class VariableKind(Enum):
    """Where a variable lives and who may write it."""

    INPUT = "input"
    OUTPUT = "output"
    IN_OUT = "in-out"
    KEPT = "kept in-out"
    STATIC = "static"
    TEMP = "temporary"
    RESULT = "result"
    GLOBAL = "global"
    THIS = "instance"


IN_OUTS = (VariableKind.IN_OUT, VariableKind.KEPT)
"""Both kinds of in-outs: references to a variable of the caller, and copies of one."""

RECEIVER = "THIS"
"""The name of the variable through which a method has its instance."""

IN_GLOBALS = ""
"""The name of what starts the instances among the global variables."""

LIVING = (VariableKind.INPUT, VariableKind.OUTPUT, VariableKind.KEPT, VariableKind.STATIC)
"""The variables that an instance of a block keeps from call to call."""


_SIZES = {1: "X", 8: "B", 16: "W", 32: "D", 64: "L"}


@node
class Address:
    """An absolute address. `area` is "I", "Q", "M" or "DB"; `bits` is 1, 8, 16, 32 or 64."""

    area: str
    bits: int
    byte: int
    bit: int = 0
    db: int = 0
    peripheral: bool = False

    @property
    def spelled(self) -> str:
        """As it is written."""
        size = _SIZES[self.bits]
        place = f"{self.byte}.{self.bit}" if self.bits == 1 else f"{self.byte}"
        if self.area == "DB":
            return f"%DB{self.db}.DB{size}{place}"
        return f"%{self.area}{size}{place}"


@node
class Variable:
    """A variable. `initial` None is the default of the type; `address` only for located ones.

    An IN_OUT is the variable of the caller itself. KEPT is an in-out for which the instance has a
    variable of its own, as those of elementary types in function blocks of S7: a call that gives it
    copies the caller's variable in and, behind the block, out again; any other call uses what the
    instance has.

    GLOBAL covers the data blocks of S7 and VAR_GLOBAL: a data block is one global variable whose
    type is its structure, or the function block of which it is the instance. `remanent` is RETAIN.
    TEMP and RESULT start anew with each call, the others keep their value. THIS is the instance in
    whose body the name stands; it is in the `variables` of no block.

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
