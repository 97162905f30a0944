"""Runs one scenario on its plant: carries its steps out, checks what comes of them.

Expectations are looked at every virtual millisecond while they wait. The first step that is not
fulfilled ends the scenario.
"""

from collections.abc import Callable, Mapping

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.scenario.actions import (
    Action,
    Check,
    CompareAction,
    ExpectAction,
    FaultAction,
    SetAction,
    WaitAction,
    prepare_steps,
)
from harness.scenario.events import StepEvent, StepMoment
from harness.scenario.failures import Failures
from harness.scenario.model import ExpectStep, Scenario, Step
from harness.scenario.places import at
from harness.scenario.telegram_patterns import bytes_match
from harness.trace.telegrams import TelegramRecorder

_RESOLUTION_NS = NS_PER_MS


class ScenarioRun:
    """One scenario on one plant. `checks` counts what was demanded and held.

    The functions in `on_step` are told when a step begins, is done, or has failed.
    """

    def __init__(self, scenario: Scenario, plant: Installation, catalog: Catalog) -> None:
        """Raises DiagnosticError with everything in the steps that the plant does not allow."""
        self.checks = 0
        self.on_step: list[Callable[[StepEvent], None]] = []
        self.installation = plant
        self.recorders: Mapping[str, TelegramRecorder] = plant.record_telegrams()
        self._plant = plant
        self._steps = prepare_steps(scenario.steps, plant, catalog)
        self._failures = Failures(plant, catalog, self.recorders)
        self._seen = dict.fromkeys(self.recorders, 0)
        self._watches_the_cpu = any(
            isinstance(step, ExpectStep) and "cpu.mode" in step.expect for step in scenario.steps
        )

    def run(self) -> None:
        """All steps. Raises DiagnosticError FB8001, FB8006, FB8012, or what a device refuses."""
        self._plant.start()
        for prepared in self._steps:
            self._tell(prepared.step, StepMoment.BEGUN)
            try:
                self._carry_out(prepared.action)
            except DiagnosticError:
                self._tell(prepared.step, StepMoment.FAILED)
                raise
            self._tell(prepared.step, StepMoment.DONE)
        if self._plant.cpu.diagnostics and not self._watches_the_cpu:
            raise DiagnosticError([self._failures.stopped()])

    def _tell(self, step: Step, moment: StepMoment) -> None:
        for told in self.on_step:
            told(StepEvent(self._plant.kernel.now_ns, step, moment))

    def _carry_out(self, action: Action) -> None:
        if isinstance(action, SetAction):
            self._set(action)
        elif isinstance(action, WaitAction):
            self._plant.run_for(action.time_ns)
        elif isinstance(action, ExpectAction):
            self._expect(action)
        elif isinstance(action, FaultAction):
            try:
                action.act()
            except DiagnosticError as wrong:
                raise DiagnosticError(at(action.place, wrong.diagnostics)) from None
        else:
            self._compare(action)

    def _set(self, action: SetAction) -> None:
        for write in action.writes:
            try:
                write.target.set(write.value)
            except DiagnosticError as wrong:
                raise DiagnosticError(at(write.place, wrong.diagnostics)) from None

    # --- expectations -----------------------------------------------------------------------

    def _expect(self, action: ExpectAction) -> None:
        kernel = self._plant.kernel
        begin_ns = kernel.now_ns
        while not _all_hold(action.checks):
            left_ns = begin_ns + action.within_ns - kernel.now_ns
            if left_ns <= 0:
                waited = self._failures.waited(action.within_ns)
                raise DiagnosticError(self._failures.unmet(action.checks, waited))
            self._plant.run_for(min(_RESOLUTION_NS, left_ns))
        held_ns = kernel.now_ns
        while (left_ns := held_ns + action.stays_for_ns - kernel.now_ns) > 0:
            self._plant.run_for(min(_RESOLUTION_NS, left_ns))
            if not _all_hold(action.checks):
                held = self._failures.held(kernel.now_ns - held_ns, action.stays_for_ns)
                raise DiagnosticError(self._failures.unmet(action.checks, held))
        self.checks += len(action.checks)

    # --- telegrams --------------------------------------------------------------------------

    def _compare(self, action: CompareAction) -> None:
        records = self.recorders[action.gateway].records[self._seen[action.gateway] :]
        self._seen[action.gateway] += len(records)
        found: list[Diagnostic] = []
        if len(records) != len(action.telegrams):
            message = (
                f"{len(records)} telegrams went out on {action.gateway}, "
                f"expected {len(action.telegrams)}"
            )
            notes = tuple(self._failures.telegram(action.gateway, record) for record in records)
            found.append(Diagnostic("FB8006", message, action.place, notes=notes))
        for number, (record, expected) in enumerate(
            zip(records, action.telegrams, strict=False), start=1
        ):
            for what, pattern, data in (
                ("output", expected.output, record.output),
                ("input", expected.input, record.input),
            ):
                if pattern is not None and not bytes_match(pattern, data):
                    shown = data.hex(" ").upper() if data is not None else "missing: no reply came"
                    notes = (self._failures.telegram(action.gateway, record),)
                    found.append(
                        Diagnostic(
                            "FB8006",
                            f"the {what} of telegram {number} is {shown}, expected {pattern}",
                            expected.span_of(what) or action.place,
                            notes=notes,
                        )
                    )
        if found:
            last = found[-1]
            notes = (*last.notes, *self._failures.cpu_notes())
            found[-1] = Diagnostic(last.code, last.message, last.span, last.help, notes)
            raise DiagnosticError(found)
        self.checks += max(len(action.telegrams), 1)


def _all_hold(checks: tuple[Check, ...]) -> bool:
    return all(check.demand.holds(check.source.get()) for check in checks)
