"""Names of the catalogue and the plant that meet in the PLC program.

Each of them is sound by itself. Here stands what only shows when they come together: a sequence's
parameter that is called like a variable of its block, two units with one name, a reserved word.
PLC names do not depend on case, and neither do file names on Windows.
"""

from collections.abc import Iterable, Iterator

from fbgen.catalog import Parameter, Result, Sequence
from fbgen.diagnostics import Diagnostic, Note
from fbgen.lang.dialects import DIALECTS
from fbgen.lang.dialects.words import STANDARD_NAMES
from fbgen.plant import Plant
from fbgen.source import Span

_OF_SEQUENCE_BLOCK = frozenset(
    (
        *("execute", "abort", "invno", "slot", "maxfrequency", "channel"),
        *("done", "busy", "error", "active", "status", "stepnumber", "failedstep"),
        *("instdelay", "statdelaying", "statdelay", "statexecute"),
        *("instlimit", "statwaiting", "statlimit"),
        *("tempstart", "tempsend", "tempreleased", "tempnext", "tempstatus"),
        *("deviations", "deviant"),
    )
)
"""What templates/blocks/TOS_Seq.scl.jinja and templates/types/typeTosSeq.udt.jinja declare."""

_OF_SEQUENCE_STEPS = ("stat_", "statcount_", "expected_", "found_")
"""How the names begin that the steps of a sequence bring with them."""

_OF_GATEWAY = frozenset({"line"})
"""What templates/types/typeTosGateway.udt.jinja declares beside the drives."""

_OF_PLANT = frozenset({"inputshash"})
"""What templates/data/TOS_Plant.db.jinja declares beside the gateways."""

_OF_DRIVE_TYPE = frozenset({"control", "state", "polled", "alarms"})
"""What templates/types/typeTosDrive.udt.jinja declares beside the sequences."""


def name_conflicts(plant: Plant, sequences: Iterable[Sequence]) -> Iterator[Diagnostic]:
    """FB5007: names that cannot stand beside each other in the generated blocks."""
    known = tuple(sequences)
    for sequence in known:
        yield from _sequence(sequence)
    yield from _drives(plant)
    yield from _units(plant)


def _sequence(sequence: Sequence) -> Iterator[Diagnostic]:
    place = sequence.span_of("id")
    if sequence.id in _OF_DRIVE_TYPE:
        yield _taken(f"the sequence is called '{sequence.id}' like a member of typeTosDrive", place)
    elif _is_reserved(sequence.id):
        yield _taken(f"the sequence's id '{sequence.id}' is a reserved word", place)
    interface: tuple[Parameter | Result, ...] = (*sequence.parameters, *sequence.results)
    for item in interface:
        if item.name in _OF_SEQUENCE_BLOCK or item.name.startswith(_OF_SEQUENCE_STEPS):
            message = f"'{item.name}' is called like a variable of the block itself"
            yield _taken(message, item.span_of("name"))
        elif _is_reserved(item.name):
            yield _taken(f"'{item.name}' is a reserved word", item.span_of("name"))


def _drives(plant: Plant) -> Iterator[Diagnostic]:
    for drive in plant.drives:
        if drive.name.lower() in _OF_GATEWAY:
            message = f"the drive is called '{drive.name}' like a variable of its gateway's block"
            yield Diagnostic("FB5007", message, drive.span_of("name"), "call the drive otherwise")


def _units(plant: Plant) -> Iterator[Diagnostic]:
    """A gateway x has the block TOS_Gateway_x and the data block TOS_Gateway_x_DB."""
    for unit in plant.units:
        if unit.name.lower() in _OF_PLANT:
            what = "gateway" if unit in plant.gateways else "line"
            if unit in plant.devicenet:
                what = "network"
            message = f"the {what} is called '{unit.name}' like a variable of TOS_Plant"
            place = unit.span_of("name")
            yield Diagnostic("FB5007", message, place, f"call the {what} otherwise")
    seen = {gateway.name.casefold(): gateway for gateway in plant.gateways}
    for gateway in plant.gateways:
        other = seen.get(f"{gateway.name}_db".casefold())
        if other is not None:
            yield Diagnostic(
                "FB5007",
                f"the data block of gateway '{gateway.name}' and the block of gateway "
                f"'{other.name}' have one name, TOS_Gateway_{other.name}",
                other.span_of("name"),
                "call one of the gateways otherwise",
                (Note("the other gateway", gateway.span_of("name")),),
            )


def _taken(message: str, place: Span | None) -> Diagnostic:
    return Diagnostic("FB5007", message, place, "choose another name in the catalogue entry")


def _is_reserved(name: str) -> bool:
    words = (STANDARD_NAMES, *(dialect.reserved for dialect in DIALECTS.values()))
    return any(name.upper() in known for known in words)
