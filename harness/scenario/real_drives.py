"""Scenarios with real inverters: what cannot be done with them is refused before anything moves.

The simulated inverter of the same name is taken away: it has no state that could be looked at, and
none of its faults can be injected. What the PLC knows of the real one is all there is.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from fbgen.catalog import Located
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.plant import PlantGateway, SerialLine
from fbgen.source import Span
from harness.drives import Inverter
from harness.engine.compiled.watching.probes import ProbeMaker
from harness.faults import FAULTS, Target
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.results import ScenarioResult
from harness.scenario.fault_model import RandomFaults
from harness.scenario.model import (
    ExpectStep,
    InjectStep,
    Scenario,
    SetStep,
    WaitUntilStep,
)
from harness.scenario.places import key_span
from harness.serial import RealDrives, RealTime
from harness.serial.ports import SettablePort
from harness.serial.real_drives import BEHIND_A_GATEWAY, SpokenTo, on_line, stop_drives

if TYPE_CHECKING:
    from harness.scenario.cases import ScenarioCase
    from harness.scenario.runner import ScenarioRun

LATE_NS = 20 * NS_PER_MS
"""A plant that is further behind has no times that could be trusted."""
_KNOWN_BY_PLC = "look at what the PLC knows of it, plc.TOS_Plant.<gateway>.<drive>..."


@dataclass(frozen=True, slots=True)
class KeptTime:
    """What is left of a run: how it kept real time, and which inverters could not be stopped."""

    time: RealTime
    not_stopped: tuple[str, ...]


class RealDrivesObserver:
    """Puts the port in the place of simulated inverters before a run, and stops them behind it."""

    def __init__(self, scenario: Scenario, names: tuple[str, ...], port: SettablePort) -> None:
        self._scenario = scenario
        self._names = names
        self._port = port
        self._drives: tuple[Inverter, ...] = ()
        self._served = BEHIND_A_GATEWAY
        self._real: RealDrives | None = None

    @property
    def probes(self) -> Sequence[ProbeMaker]:
        """It looks at no statement."""
        return ()

    def attach(self, run: "ScenarioRun") -> None:
        """Raises DiagnosticError FB8080 with everything that real inverters do not allow."""
        plant = run.stage.installation
        if plant is None:
            raise DiagnosticError([_refused("a block on its own has no inverters", None, "")])
        found = list(_misfits(self._scenario, plant, self._names))
        if found:
            raise DiagnosticError(found)
        unit = _unit_of(plant, self._names[0])
        assert unit is not None, "checked with what does not fit"
        self._drives = tuple(plant.drives[name] for name in self._names)
        self._served = _spoken_to(unit)
        self._real = RealDrives(
            *(plant, unit.name, self._served, self._names, self._port), late_ns=LATE_NS
        )

    def finish(self, result: ScenarioResult) -> KeptTime | None:
        """Stop the inverters."""
        if self._real is None:
            return None
        return KeptTime(self._real.kept, self.stop())

    def stop(self) -> tuple[str, ...]:
        """Tell the inverters to stop; the names of those that do not answer."""
        return stop_drives(self._drives, self._served, self._port)


class RealDrivesMaker:
    """Makes the observer of each run. `stop` ends what a run that was broken off has left."""

    def __init__(self, names: tuple[str, ...], port: SettablePort) -> None:
        self._names = names
        self._port = port
        self._last: RealDrivesObserver | None = None

    def __call__(self, case: "ScenarioCase") -> RealDrivesObserver:
        """As `ObserverMaker`."""
        self._last = RealDrivesObserver(case.scenario, self._names, self._port)
        return self._last

    def stop(self) -> tuple[str, ...]:
        """Tell the inverters of the last run to stop; the names of those that do not answer."""
        return () if self._last is None else self._last.stop()


def _unit_of(plant: Installation, drive: str) -> PlantGateway | SerialLine | None:
    """Gateway or line of a drive; None for one on DeviceNet."""
    units: tuple[PlantGateway | SerialLine, ...] = (*plant.plan.gateways, *plant.plan.serial)
    return next((unit for unit in units if drive in {item.name for item in unit.drives}), None)


def _spoken_to(unit: PlantGateway | SerialLine) -> SpokenTo:
    return on_line(unit) if isinstance(unit, SerialLine) else BEHIND_A_GATEWAY


def _misfits(
    scenario: Scenario, plant: Installation, names: tuple[str, ...]
) -> Iterator[Diagnostic]:
    unknown = [name for name in names if name not in plant.drives]
    for name in unknown:
        yield _refused(f"there is no drive '{name}'", None, nearest(name, plant.drives))
    if unknown:
        return
    places = {name: _unit_of(plant, name) for name in names}
    units = {unit.name for unit in places.values() if unit is not None}
    if len(units) > 1:
        help_ = "one port is one line: choose drives behind one gateway, or on one serial line"
        yield _refused(f"{' and '.join(names)} are on different lines", None, help_)
    way_out = "choose drives behind a gateway for telegrams, or on a serial line"
    for name, unit in places.items():
        if unit is None:
            yield _refused(f"'{name}' is on DeviceNet, not on a line", None, way_out)
    for unit_name in sorted(units):
        if unit_name not in plant.lines:
            message = f"the drives at '{unit_name}' have a cable of their own, not a line"
            yield _refused(message, None, way_out)
    yield from _of_steps(scenario, names)
    for name in names:
        if name in scenario.drives:
            message = f"'{name}' is real: it cannot be set before the start"
            place = scenario.item_span_of("drives", name)
            yield _refused(message, place, "set it by fbgen talk, or at its panel")
    if scenario.rules:
        message = "rules look into every drive of the plant, and real ones cannot be looked into"
        yield _refused(message, scenario.span_of("rules"), "leave out rules:")
    for item in scenario.properties:
        yield from _of_property(item, names)
    for fault in scenario.faults:
        if isinstance(fault, RandomFaults):
            message = "faults by chance may happen to any drive, and real ones cannot have them"
            yield _refused(message, fault.span, "inject faults of gateways and lines by name")
        else:
            yield from _of_fault(fault.inject, fault.on, fault.span_of("on"), names)


def _of_steps(scenario: Scenario, names: tuple[str, ...]) -> Iterator[Diagnostic]:
    for step in scenario.steps:
        match step:
            case SetStep():
                yield from _of_paths(step, "set", step.set, names)
            case ExpectStep():
                yield from _of_paths(step, "expect", step.expect, names)
            case WaitUntilStep():
                yield from _of_paths(step, "wait_until", step.wait_until, names)
            case InjectStep():
                yield from _of_fault(step.inject, step.on, step.span_of("on"), names)
            case _:
                continue


def _of_property(item: Located, names: tuple[str, ...]) -> Iterator[Diagnostic]:
    for field in type(item).model_fields:
        value = getattr(item, field)
        if isinstance(value, dict):
            yield from _of_paths(item, field, value, names)


def _of_paths(
    item: Located, field: str, paths: Iterable[str], names: tuple[str, ...]
) -> Iterator[Diagnostic]:
    for path in paths:
        root, _, rest = path.partition(".")
        name = rest.partition(".")[0]
        if root == "drive" and name in names:
            message = f"'{name}' is real: nobody can look into it or set it by '{path}'"
            yield _refused(message, key_span(item, field, path), _KNOWN_BY_PLC)


def _of_fault(
    kind: str, on: str | None, place: Span | None, names: tuple[str, ...]
) -> Iterator[Diagnostic]:
    known = FAULTS.get(kind)
    if known is not None and known.target is Target.DRIVE and on in names:
        message = f"'{on}' is real: the fault '{kind}' cannot be injected"
        yield _refused(message, place, "faults of gateways and lines can be")


def _refused(message: str, place: Span | None, help_: str) -> Diagnostic:
    return Diagnostic("FB8080", message, place, help_)
