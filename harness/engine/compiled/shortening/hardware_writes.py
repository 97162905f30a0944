"""Writing several outputs straight to the hardware, by one call instead of one for each.

As with inputs (`hardware_reads`), only the controller knows whether something can happen between
the accesses. The values are worked out before it is asked, and once more if it refuses; so between
the writes may stand only what can be done twice: values for temporary variables that nothing has
read before.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from fbgen.lang.checked import (
    AddressRef,
    Assignment,
    Statement,
    Variable,
    VariableKind,
    VariableRef,
)
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.hardware_reads import (
    bytes_of,
    calculates_in_memory,
    hardware_place,
    places_text,
)
from harness.engine.compiled.walk import every_node


class SeveralWrites(NamedTuple):
    """Statements with writes of outputs; `places` has byte and count of each."""

    statements: Sequence[Statement]
    places: str


def several_writes(
    procedure: Procedure, body: Sequence[Statement], start: int
) -> SeveralWrites | None:
    """The writes that begin with the statement at `start`, or None if there are not several."""
    if procedure.context.probe is not None or _written(body[start]) is None:
        return None
    writes: list[AddressRef] = []
    taken: set[int] = set()
    read: set[Variable] = set()
    filled: set[Variable] = set()
    end = start
    for at in range(start, len(body)):
        statement = body[at]
        if not isinstance(statement, Assignment):
            break
        nodes = list(every_node((statement.value,)))
        if not calculates_in_memory(nodes, procedure.context.block):
            break
        used = {node.variable for node in nodes if isinstance(node, VariableRef)}
        read |= used - filled
        written = _written(statement)
        if written is not None:
            if not taken.isdisjoint(bytes_of(written)):
                break
            taken.update(bytes_of(written))
            writes.append(written)
            end = at + 1
            continue
        target = statement.target
        if not isinstance(target, VariableRef) or not _is_own(procedure, target.variable):
            break
        if target.variable in read or target.variable in filled:
            break
        filled.add(target.variable)
    if len(writes) < 2:
        return None
    return SeveralWrites(body[start:end], places_text(writes))


def write_several_writes(
    procedure: Procedure,
    found: SeveralWrites,
    write: Callable[[Procedure, Sequence[Statement]], None],
) -> None:
    """The statements, with all values written at once or, if that may not be, as they are."""
    listing = procedure.listing
    values: list[str] = []
    procedure.gathered = values
    write(procedure, found.statements)
    procedure.gathered = None
    listing.span = found.statements[0].span
    procedure.forget_sites()
    call = f"_environment.write_several({found.places!r}, ({', '.join(values)}))"
    procedure.line(f"if not {call}:")
    listing.indent += 4
    write(procedure, found.statements)
    listing.indent -= 4


def _written(statement: Statement) -> AddressRef | None:
    """The output that an assignment writes straight to the hardware."""
    return hardware_place(statement.target, "Q") if isinstance(statement, Assignment) else None


def _is_own(procedure: Procedure, variable: Variable) -> bool:
    """True for a temporary single value that only these statements can see."""
    return (
        variable.kind is VariableKind.TEMP
        and is_scalar(variable.type)
        and variable.address is None
        and not procedure.has_cell(variable)
    )
