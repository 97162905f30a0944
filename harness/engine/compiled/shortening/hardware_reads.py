"""Reading several inputs straight from the hardware, by one call instead of one for each.

Every access to the hardware has an instant of its own, and what happens up to it happens first. As
long as nothing does, several reads give the same as one; only the controller knows, and says so by
giving no values. Then the statements run as they are written. Between the reads may stand what
neither reaches the hardware nor stops.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from fbgen.lang.checked import (
    AddressRef,
    Assignment,
    Block,
    Expression,
    Statement,
    VariableKind,
    VariableRef,
)
from fbgen.lang.types import StructType
from harness.engine.compiled.data.model import is_scalar, may_be_unconnected
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.caching import only_calculates
from harness.engine.compiled.walk import Node, every_node

WIDTHS = (8, 16, 32, 64)
"""Bits of what one access moves whole."""


class SeveralReads(NamedTuple):
    """Statements with reads of inputs; `places` has byte and count of each."""

    statements: Sequence[Statement]
    reads: list[AddressRef]
    places: str


def several_reads(body: Sequence[Statement], start: int, block: Block) -> SeveralReads | None:
    """The reads that begin with the statement at `start`, or None if there are not several."""
    if _read(body[start]) is None:
        return None
    reads: list[AddressRef] = []
    taken: set[int] = set()
    end = start
    for at in range(start, len(body)):
        statement = body[at]
        if not isinstance(statement, Assignment) or not _stays_inside(statement, block):
            break
        read = _read(statement)
        if read is not None:
            if not taken.isdisjoint(bytes_of(read)):
                break
            taken.update(bytes_of(read))
            reads.append(read)
            end = at + 1
    if len(reads) < 2:
        return None
    return SeveralReads(body[start:end], reads, places_text(reads))


def hardware_place(expression: Expression, area: str) -> AddressRef | None:
    """An expression that is a place of the peripheral area, moved whole by one access."""
    if not isinstance(expression, AddressRef):
        return None
    address = expression.address
    reached = address.peripheral and address.area == area and address.bits in WIDTHS
    return expression if reached else None


def bytes_of(access: AddressRef) -> range:
    """The bytes of the area that an access reaches."""
    byte = access.address.byte
    return range(byte, byte + access.address.bits // 8)


def places_text(accesses: Iterable[AddressRef]) -> str:
    """Byte and count of each access, as the environment takes them."""
    return " ".join(f"{one.address.byte}:{one.address.bits // 8}" for one in accesses)


def write_several_reads(
    procedure: Procedure,
    found: SeveralReads,
    write: Callable[[Procedure, Sequence[Statement]], None],
) -> None:
    """The statements, once with all values read before and once as they are."""
    listing = procedure.listing
    listing.span = found.statements[0].span
    procedure.forget_sites()
    values = procedure.temporary()
    names = [procedure.temporary() for _ in found.reads]
    procedure.line(f"if {values} := _environment.read_several({found.places!r}):")
    listing.indent += 4
    procedure.line(f"{', '.join(names)} = {values}")
    procedure.at_hand = {id(read): name for read, name in zip(found.reads, names, strict=True)}
    write(procedure, found.statements)
    procedure.at_hand = {}
    listing.indent -= 4
    procedure.line("else:")
    listing.indent += 4
    write(procedure, found.statements)
    listing.indent -= 4


def _read(statement: Statement) -> AddressRef | None:
    """The input that an assignment reads from the hardware and does nothing else with."""
    return hardware_place(statement.value, "I") if isinstance(statement, Assignment) else None


def _stays_inside(statement: Assignment, block: Block) -> bool:
    """True if an assignment, apart from the read, reaches no hardware and cannot stop."""
    parts = [statement.target] if _read(statement) is not None else [statement]
    return is_scalar(statement.target.type) and calculates_in_memory(every_node(parts), block)


def calculates_in_memory(nodes: Iterable[Node], block: Block) -> bool:
    """True if these nodes reach variables of the program only, cannot stop and call nothing."""
    return all(
        _is_memory(node, block) if isinstance(node, VariableRef) else only_calculates(node)
        for node in nodes
    )


def _is_memory(node: VariableRef, block: Block) -> bool:
    """True for a variable of the program; a single value that an in-out is may lie anywhere."""
    variable = node.variable
    if variable.kind is VariableKind.IN_OUT:
        return isinstance(variable.type, StructType) and not may_be_unconnected(variable, block)
    return variable.address is None
