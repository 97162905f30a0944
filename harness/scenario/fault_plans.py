"""From the `faults` of a scenario to a list of events, each with the fault that then comes."""

from collections.abc import Sequence
from random import Random
from typing import NamedTuple

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.source import Span
from harness.faults import FAULTS, Fault
from harness.faults.fault import Target
from harness.faults.schedule import FaultEvent
from harness.faults.settings import fault_settings
from harness.installation import Installation
from harness.scenario.fault_making import FaultMaking
from harness.scenario.fault_model import RandomFaults, ScenarioFault


class ClockFault(NamedTuple):
    """A fault that comes by the clock, and the place of its entry in the file."""

    event: FaultEvent
    fault: Fault
    place: Span | None


def prepare_faults(entries: Sequence[ScenarioFault], plant: Installation) -> list[ClockFault]:
    """The events of all entries in the order of their instants. What is drawn depends on the seed
    of the plant and the place of its entry in the list, on nothing else.

    Raises DiagnosticError with everything that the plant does not allow.
    """
    found: list[Diagnostic] = []
    making = FaultMaking(plant, found)
    armed: list[ClockFault] = []
    for number, entry in enumerate(entries):
        if isinstance(entry, RandomFaults):
            for name in entry.kinds:
                making.kind(name, entry.span_of("kinds"))
            random = Random(f"{plant.kernel.seed} {number}")
            places = possible_places(plant)
            events = entry.events(random, places)
        else:
            events = entry.events() if making.fault(entry) is not None else []
        armed += [ClockFault(event, _made(event, plant), entry.span) for event in events]
    if found:
        raise DiagnosticError(found)
    return sorted(armed, key=lambda item: item.event.at_ns)


def possible_places(plant: Installation) -> dict[str, tuple[str, ...]]:
    """Where each fault can be in this plant, as it is without settings."""
    places: dict[str, tuple[str, ...]] = {}
    for name, kind in FAULTS.items():
        settings = kind.settings()
        fitting = []
        for on in ("",) if kind.target is Target.WHOLE else kind.target.places(plant):
            try:
                kind.make(plant, on, settings)
            except DiagnosticError:
                continue
            fitting.append(on)
        places[name] = tuple(fitting)
    return places


def _made(event: FaultEvent, plant: Installation) -> Fault:
    kind = FAULTS[event.name]
    return kind.make(plant, event.on, fault_settings(kind, dict(event.settings), {}))
