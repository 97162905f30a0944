"""Steps of a scenario, ready to be carried out: names resolved, values read, faults made.

Everything that can be wrong in a step is found here, before the plant starts, and all of it at
once. What is left for the run are the devices' own refusals and the expectations themselves.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias, TypeVar

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.faults import FAULTS, Fault, FaultType, Target
from harness.faults.settings import fault_settings
from harness.installation import Installation
from harness.scenario.kinds import Found, WrongValueError
from harness.scenario.model import (
    ClearStep,
    ExpectedTelegram,
    ExpectStep,
    InjectStep,
    SequenceStep,
    SetStep,
    Step,
    TelegramsStep,
    WaitStep,
)
from harness.scenario.paths import Paths, Readable, Writable
from harness.scenario.places import at, key_span, value_span
from harness.scenario.telegram_patterns import pattern_problems
from harness.scenario.values import Demand, demand, wrong_value


@dataclass(frozen=True, slots=True)
class Write:
    """One value to be written."""

    place: Span | None
    target: Writable
    value: Found


@dataclass(frozen=True, slots=True)
class SetAction:
    """Values to be written one after the other."""

    writes: tuple[Write, ...]


@dataclass(frozen=True, slots=True)
class WaitAction:
    """Time to pass, in ns."""

    time_ns: int


@dataclass(frozen=True, slots=True)
class Check:
    """One path with what is demanded of it; `place` is the path in the file."""

    path: str
    place: Span | None
    source: Readable
    demand: Demand


@dataclass(frozen=True, slots=True)
class ExpectAction:
    """What must hold, at the latest after `within_ns` and from then on for `stays_for_ns`."""

    checks: tuple[Check, ...]
    within_ns: int
    stays_for_ns: int


@dataclass(frozen=True, slots=True)
class FaultAction:
    """A fault to begin or to end."""

    place: Span | None
    act: Callable[[], None]


@dataclass(frozen=True, slots=True)
class CompareAction:
    """The telegrams that a gateway must have had since the last such action."""

    place: Span | None
    gateway: str
    telegrams: tuple[ExpectedTelegram, ...]


Action: TypeAlias = SetAction | WaitAction | ExpectAction | FaultAction | CompareAction


@dataclass(frozen=True, slots=True)
class PreparedStep:
    """A step of the file with what it does."""

    step: Step
    action: Action


Result = TypeVar("Result")


def prepare_steps(
    steps: Sequence[Step], plant: Installation, catalog: Catalog
) -> tuple[PreparedStep, ...]:
    """The steps of a scenario with their actions on a plant.

    Raises DiagnosticError FB8002 to FB8005, FB8009, FB8010, FB8013 with everything that is wrong.
    """
    preparing = _Preparing(plant, catalog)
    prepared = [PreparedStep(step, action) for step in steps for action in preparing.step(step)]
    if preparing.found:
        raise DiagnosticError(preparing.found)
    return tuple(prepared)


class _Preparing:
    def __init__(self, plant: Installation, catalog: Catalog) -> None:
        self.found: list[Diagnostic] = []
        self._plant = plant
        self._catalog = catalog
        self._paths = Paths(plant, catalog)
        self._faults: dict[tuple[str, str], Fault | None] = {}

    def step(self, step: Step) -> Iterable[Action]:
        """The step as an action; nothing if something is wrong with it."""
        if isinstance(step, SetStep):
            yield SetAction(tuple(self._writes(step)))
        elif isinstance(step, WaitStep):
            yield WaitAction(step.wait)
        elif isinstance(step, ExpectStep):
            yield ExpectAction(tuple(self._checks(step)), step.within, step.stays_for)
        elif isinstance(step, InjectStep):
            yield from self._inject(step)
        elif isinstance(step, ClearStep):
            yield from self._clear(step)
        else:
            yield from self._compare(step)

    def _try(self, action: Callable[[], Result]) -> Result | None:
        try:
            return action()
        except DiagnosticError as wrong:
            self.found += wrong.diagnostics
            return None

    def _report(self, code: str, message: str, place: Span | None, advice: str) -> None:
        self.found.append(Diagnostic(code, message, place, advice))

    # --- values -----------------------------------------------------------------------------

    def _writes(self, step: SetStep) -> Iterable[Write]:
        for path, value in step.set.items():
            place = key_span(step, "set", path)
            try:
                target = self._paths.writable(path, place)
                yield Write(value_span(step, "set", path), target, target.kind.read(value))
            except DiagnosticError as wrong:
                self.found += wrong.diagnostics
            except WrongValueError as wrong:
                there = value_span(step, "set", path)
                self.found.append(wrong_value(path, target.kind, value, there, wrong))

    def _checks(self, step: ExpectStep) -> Iterable[Check]:
        for path, expected in step.expect.items():
            place = key_span(step, "expect", path)
            there = value_span(step, "expect", path)
            try:
                source = self._paths.readable(path, place)
                wanted = demand(path, expected, source.kind, there, self._catalog)
                yield Check(path, place, source, wanted)
            except DiagnosticError as wrong:
                self.found += wrong.diagnostics

    # --- faults -----------------------------------------------------------------------------

    def _inject(self, step: InjectStep) -> Iterable[Action]:
        kind = self._fault_type(step.inject, step.span_of("inject"))
        if kind is None:
            return
        on = step.on or ""
        is_there = self._is_there(kind, step)
        if (kind.name, on) in self._faults:
            self._report(
                "FB8005",
                f"the fault '{kind.name}' is still there" + (f" on '{on}'" if on else ""),
                step.span_of("inject"),
                "clear it before it is injected again",
            )
            return
        places = {name: value_span(step, "settings", name) for name in step.settings}
        settings = self._try(lambda: fault_settings(kind, step.settings, places))
        self._faults[kind.name, on] = None
        if settings is None or not is_there:
            return
        try:
            fault = kind.make(self._plant, on, settings)
        except DiagnosticError as wrong:
            self.found += at(step.span_of("settings"), wrong.diagnostics)
            return
        self._faults[kind.name, on] = fault
        yield FaultAction(step.span_of("inject"), fault.inject)

    def _fault_type(self, name: str, place: Span | None) -> FaultType | None:
        if name not in FAULTS:
            self._report("FB8004", f"there is no fault '{name}'", place, nearest(name, FAULTS))
        return FAULTS.get(name)

    def _is_there(self, kind: FaultType, step: InjectStep) -> bool:
        places = kind.target.places(self._plant)
        what = kind.target.value
        if kind.target is Target.WHOLE:
            if step.on is not None:
                message = f"the fault '{kind.name}' happens to the whole plant"
                self._report("FB8004", message, step.span_of("on"), "leave out on:")
            return step.on is None
        if step.on is None:
            message = f"the fault '{kind.name}' happens to one {what}"
            advice = f"say to which one, such as on: {next(iter(places), 'its name')}"
            self._report("FB8004", message, step.span_of("inject"), advice)
        elif step.on not in places:
            message = f"the fault '{kind.name}' needs a {what}, and there is no {what} '{step.on}'"
            self._report("FB8004", message, step.span_of("on"), nearest(step.on, places))
        return step.on in places

    def _clear(self, step: ClearStep) -> Iterable[Action]:
        key = (step.clear, step.on or "")
        if self._fault_type(step.clear, step.span_of("clear")) is None:
            return
        if key not in self._faults:
            there = ", ".join(
                f"{name} on {on}" if on else name
                for (name, on), fault in self._faults.items()
                if fault is not None
            )
            self._report(
                "FB8005",
                f"there is no fault '{step.clear}'"
                + (f" on '{step.on}'" if step.on else "")
                + " to clear here",
                step.span_of("clear"),
                f"at this step there is: {there or 'no fault'}",
            )
            return
        fault = self._faults.pop(key)
        if fault is not None:
            yield FaultAction(step.span_of("clear"), fault.clear)

    # --- telegrams --------------------------------------------------------------------------

    def _compare(self, step: TelegramsStep | SequenceStep) -> Iterable[Action]:
        gateways = self._plant.gateways
        if step.gateway not in gateways:
            message = f"there is no gateway '{step.gateway}'"
            self._report(
                "FB8004", message, step.span_of("gateway"), nearest(step.gateway, gateways)
            )
        if isinstance(step, TelegramsStep):
            telegrams = step.telegrams
            self.found += [item for each in telegrams for item in pattern_problems(each)]
        else:
            known = {name: item for name, item in self._catalog.sequences.items() if item.telegrams}
            if step.of_sequence not in known:
                message = f"there is no sequence '{step.of_sequence}' with telegrams"
                advice = nearest(step.of_sequence, known)
                self._report("FB8004", message, step.span_of("of_sequence"), advice)
                return
            telegrams = tuple(
                ExpectedTelegram(output=item.output, input=item.input)
                for item in known[step.of_sequence].telegrams
            )
        if step.gateway in gateways:
            yield CompareAction(step.span, step.gateway, telegrams)
