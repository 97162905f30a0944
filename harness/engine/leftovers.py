"""What temporary variables hold before a block has written them, if nobody clears them.

An S7 has the local data of a call where other calls had theirs, and leaves there what it finds: an
S7-300 or S7-400 always, an S7-1200 or S7-1500 in blocks with standard access. A program that reads
them unwritten may run well for years. Here all blocks of S7 find bytes that are drawn by a seed
from the names of block and variable and the instant of the call: the same in every run and in both
engines, others in each cycle. Elsewhere temporary variables begin with their initial values
(IEC 61131-3, VAR_TEMP).
Source: CPU 31xC and CPU 31x, technical data, 4.1 "Local data" (to be initialized before the first
read access).
"""

from collections.abc import Sequence
from hashlib import shake_128

from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Variable, VariableKind
from fbgen.lang.layout import holds_blocks, holds_values
from fbgen.lang.start_information import start_places
from harness.engine.environment import Environment
from harness.engine.interface import Value
from harness.engine.layout import S7

_S7_DIALECTS = ("tia", "step7")


def left_over(block: Block, dialect: str) -> tuple[Variable, ...]:
    """The variables of a block that hold anything at the start of a call, where nobody clears them.

    What has an initial value of its own has that one, and what an organization block is told by the
    operating system is not left over.
    """
    if dialect not in _S7_DIALECTS:
        return ()
    kinds: tuple[VariableKind, ...] = (VariableKind.TEMP, VariableKind.RESULT)
    if block.kind is BlockKind.FUNCTION:
        kinds = (*kinds, VariableKind.OUTPUT)
    told = {variable for variable, _ in start_places(block)}
    return tuple(
        variable
        for variable in block.variables
        if variable.kind in kinds and _is_left(variable) and variable not in told
    )


def _is_left(variable: Variable) -> bool:
    kind = variable.type
    if variable.initial is not None or variable.overlay is not None:
        return False
    return variable.address is None and holds_values(kind) and not holds_blocks(kind)


def values_left(
    block: Block, variables: Sequence[Variable], environment: Environment
) -> list[Value]:
    """What these variables hold at the start of a call at this instant."""
    seed, now_ns = environment.services.leftovers, environment.now_ns
    values = []
    for variable in variables:
        name = f"{seed} {now_ns} {block.name} {variable.name}".casefold().encode()
        data = shake_128(name).digest(S7.size_bytes(variable.type))
        values.append(S7.decode(variable.type, data))
    return values
