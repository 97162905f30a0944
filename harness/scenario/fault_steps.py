"""Steps that inject and clear faults: which fault, on what, with which settings."""

from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.source import Span
from harness.faults import FAULTS, Fault
from harness.installation import Installation
from harness.scenario.actions import FaultAction
from harness.scenario.fault_making import FaultMaking
from harness.scenario.model import ClearStep, InjectStep


class FaultSteps:
    """Makes the faults of one run, step by step; `found` has everything that is wrong."""

    def __init__(self, plant: Installation, found: list[Diagnostic]) -> None:
        self._making = FaultMaking(plant, found)
        self._found = found
        self._faults: dict[tuple[str, str], Fault | None] = {}

    def _report(self, code: str, message: str, place: Span | None, advice: str) -> None:
        self._found.append(Diagnostic(code, message, place, advice))

    def inject(self, step: InjectStep) -> Iterator[FaultAction]:
        """The beginning of a fault; nothing if something is wrong with it."""
        on = step.on or ""
        if (step.inject, on) in self._faults:
            self._report(
                "FB8005",
                f"the fault '{step.inject}' is still there" + (f" on '{on}'" if on else ""),
                step.span_of("inject"),
                "clear it before it is injected again",
            )
            return
        fault = self._making.fault(step)
        if step.inject in FAULTS:
            self._faults[step.inject, on] = fault
        if fault is not None:
            yield FaultAction(step.span_of("inject"), fault.inject)

    def clear(self, step: ClearStep) -> Iterator[FaultAction]:
        """The end of a fault that a step before has begun."""
        key = (step.clear, step.on or "")
        if self._making.kind(step.clear, step.span_of("clear")) is None:
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
