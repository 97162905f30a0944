"""Steps that inject and clear faults: which fault, on what, with which settings."""

from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.faults import FAULTS, Fault, FaultType, Target
from harness.faults.settings import fault_settings
from harness.installation import Installation
from harness.scenario.actions import FaultAction
from harness.scenario.model import ClearStep, InjectStep
from harness.scenario.places import at, value_span


class FaultSteps:
    """Makes the faults of one run, step by step; `found` has everything that is wrong."""

    def __init__(self, plant: Installation, found: list[Diagnostic]) -> None:
        self._plant = plant
        self._found = found
        self._faults: dict[tuple[str, str], Fault | None] = {}

    def _report(self, code: str, message: str, place: Span | None, advice: str) -> None:
        self._found.append(Diagnostic(code, message, place, advice))

    def inject(self, step: InjectStep) -> Iterator[FaultAction]:
        """The beginning of a fault; nothing if something is wrong with it."""
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
        self._faults[kind.name, on] = None
        try:
            settings = fault_settings(kind, step.settings, places)
        except DiagnosticError as wrong:
            self._found += wrong.diagnostics
            return
        if not is_there:
            return
        try:
            fault = kind.make(self._plant, on, settings)
        except DiagnosticError as wrong:
            self._found += at(step.span_of("settings"), wrong.diagnostics)
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

    def clear(self, step: ClearStep) -> Iterator[FaultAction]:
        """The end of a fault that a step before has begun."""
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
