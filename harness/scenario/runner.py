"""Runs one scenario: carries its steps out, checks what comes of them, watches its properties.

Expectations are looked at every virtual millisecond while they wait. The first step that is not
fulfilled ends the scenario, and so does the first property that is violated.
"""

from collections.abc import Callable, Mapping, Sequence

from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.faults.schedule import FaultEvent, arm
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.scenario.actions import (
    Action,
    CallAction,
    CompareAction,
    ExpectAction,
    FaultAction,
    SetAction,
    WaitAction,
    WaitUntilAction,
)
from harness.scenario.clockwork import clockwork
from harness.scenario.conditions import Check, all_hold
from harness.scenario.events import StepEvent, StepMoment
from harness.scenario.failures import Failures
from harness.scenario.model import ExpectStep, Scenario, Step
from harness.scenario.places import at
from harness.scenario.plant_stage import PlantStage
from harness.scenario.preparing import prepare_scenario
from harness.scenario.stage import Stage
from harness.scenario.watch import Watch
from harness.trace.telegrams import TelegramRecorder

_RESOLUTION_NS = NS_PER_MS


class ScenarioRun:
    """One scenario on its stage. `checks` counts what was demanded and held.

    The functions in `on_step` are told when a step begins, is done, or has failed. `warnings` are
    there when the run has ended well. `clock_faults` come by the clock, in their order.
    """

    def __init__(self, scenario: Scenario, stage: Stage) -> None:
        """Raises DiagnosticError with everything in the scenario that the stage does not allow."""
        self.checks = 0
        self.warnings: tuple[Diagnostic, ...] = ()
        self.on_step: list[Callable[[StepEvent], None]] = []
        self.stage = stage
        prepared = prepare_scenario(scenario, stage)
        self._steps = prepared.steps
        self._failures = Failures(stage)
        self._watch = Watch(prepared.monitors, stage, self._failures)
        self.clock_faults, self._rules = clockwork(scenario, stage)
        self._watches_the_cpu = any(
            isinstance(step, ExpectStep) and "cpu.mode" in step.expect for step in scenario.steps
        )

    @property
    def installation(self) -> Installation:
        """The plant. Not for a block on its own: `stage.installation` is None there."""
        assert self.stage.installation is not None, "a block has no plant"
        return self.stage.installation

    @property
    def faults(self) -> Sequence[FaultEvent]:
        """What comes by the clock, in its order."""
        return tuple(one.event for one in self.clock_faults)

    @property
    def recorders(self) -> Mapping[str, TelegramRecorder]:
        """Who has noted the telegrams, by gateway."""
        return self.stage.recorders if isinstance(self.stage, PlantStage) else {}

    def run(self) -> None:
        """All steps.

        Raises DiagnosticError FB8001, FB8006, FB8012, FB8020, or what a device or block refuses.
        """
        self.stage.start()
        if self.stage.installation is not None:
            faults = ((one.event, one.fault) for one in self.clock_faults)
            arm(self.stage.installation, faults)
        self._watch.begin()
        for prepared in self._steps:
            self._tell(prepared.step, StepMoment.BEGUN)
            try:
                self._carry_out(prepared.action)
                self._watch.look_on()
                self._rules.check()
            except DiagnosticError:
                self._tell(prepared.step, StepMoment.FAILED)
                raise
            self._tell(prepared.step, StepMoment.DONE)
        stopped = self.stage.stopped()
        if stopped is not None and not self._watches_the_cpu:
            raise DiagnosticError([stopped])
        self.warnings = self._watch.end()
        self.checks += self._watch.count

    def _tell(self, step: Step, moment: StepMoment) -> None:
        for told in self.on_step:
            told(StepEvent(self.stage.kernel.now_ns, step, moment))

    def _carry_out(self, action: Action) -> None:
        match action:
            case SetAction():
                self._set(action)
            case WaitAction():
                self._watch.pass_time(action.time_ns)
            case CallAction():
                self.stage.call(action.cycles)
            case WaitUntilAction():
                self._reach(action.checks, action.within_ns)
            case ExpectAction():
                self._reach(action.checks, action.within_ns)
                self._stay(action.checks, action.stays_for_ns)
                self.checks += len(action.checks)
            case FaultAction():
                try:
                    action.act()
                except DiagnosticError as wrong:
                    raise DiagnosticError(at(action.place, wrong.diagnostics)) from None
            case CompareAction():
                self.checks += action.telegrams.check()

    def _set(self, action: SetAction) -> None:
        for write in action.writes:
            try:
                write.target.set(write.value)
                self._failures.was_set(write)
            except DiagnosticError as wrong:
                raise DiagnosticError(at(write.place, wrong.diagnostics)) from None

    def _reach(self, checks: tuple[Check, ...], within_ns: int) -> None:
        """Let time pass until all of it holds."""
        kernel = self.stage.kernel
        begin_ns = kernel.now_ns
        while not all_hold(checks):
            left_ns = begin_ns + within_ns - kernel.now_ns
            if left_ns <= 0:
                waited = self._failures.waited(within_ns)
                raise DiagnosticError(self._failures.unmet(checks, waited))
            self._watch.pass_time(min(_RESOLUTION_NS, left_ns))

    def _stay(self, checks: tuple[Check, ...], time_ns: int) -> None:
        """All of it must go on holding."""
        kernel = self.stage.kernel
        begin_ns = kernel.now_ns
        while (left_ns := begin_ns + time_ns - kernel.now_ns) > 0:
            self._watch.pass_time(min(_RESOLUTION_NS, left_ns))
            if not all_hold(checks):
                held = self._failures.held(kernel.now_ns - begin_ns, time_ns)
                raise DiagnosticError(self._failures.unmet(checks, held))
