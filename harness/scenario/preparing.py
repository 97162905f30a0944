"""Makes a scenario ready for its stage: names resolved, values read, faults made.

Everything that can be wrong in a step or a property is found here, before anything runs, and all
of it at once. What is left for the run are the devices' own refusals and the expectations.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.scenario.actions import (
    Action,
    CallAction,
    CompareAction,
    ExpectAction,
    PreparedStep,
    SetAction,
    WaitAction,
    WaitUntilAction,
    Write,
)
from harness.scenario.conditions import Conditions
from harness.scenario.fault_steps import FaultSteps
from harness.scenario.kinds import WrongValueError
from harness.scenario.model import (
    CallStep,
    ClearStep,
    ExpectedTelegram,
    ExpectStep,
    InjectStep,
    Scenario,
    SequenceStep,
    SetStep,
    Step,
    TelegramsStep,
    WaitStep,
    WaitUntilStep,
)
from harness.scenario.monitors import Monitor, monitor_of
from harness.scenario.places import key_span, value_span
from harness.scenario.plant_stage import PlantStage
from harness.scenario.stage import Stage
from harness.scenario.telegram_checks import TelegramCheck
from harness.scenario.telegram_patterns import pattern_problems
from harness.scenario.values import wrong_value


@dataclass(frozen=True, slots=True)
class Prepared:
    """A scenario with all its names resolved for one stage."""

    steps: tuple[PreparedStep, ...]
    monitors: tuple[Monitor, ...]


def prepare_scenario(scenario: Scenario, stage: Stage) -> Prepared:
    """Steps and properties of a scenario, ready to run.

    Raises DiagnosticError FB8002 to FB8005, FB8009, FB8010, FB8013, FB8018 with everything that is
    wrong.
    """
    found: list[Diagnostic] = []
    conditions = Conditions(stage, found)
    preparing: _AnySteps = (
        _PlantSteps(stage, conditions, found)
        if isinstance(stage, PlantStage)
        else _BlockSteps(stage, conditions, found)
    )
    steps = [
        PreparedStep(step, action) for step in scenario.steps for action in preparing.actions(step)
    ]
    monitors = [monitor_of(item, conditions) for item in scenario.properties]
    if found:
        raise DiagnosticError(found)
    return Prepared(tuple(steps), tuple(monitors))


class _AnySteps(ABC):
    """The steps that there are on every stage."""

    def __init__(self, stage: Stage, conditions: Conditions, found: list[Diagnostic]) -> None:
        self._stage = stage
        self._conditions = conditions
        self._found = found

    def actions(self, step: Step) -> Iterable[Action]:
        """The step as an action; nothing if something is wrong with it."""
        match step:
            case SetStep():
                yield SetAction(tuple(self._writes(step)))
            case WaitStep():
                yield WaitAction(step.wait)
            case WaitUntilStep():
                yield WaitUntilAction(self._conditions.checks(step, "wait_until"), step.within)
            case ExpectStep():
                checks = self._conditions.checks(step, "expect")
                yield ExpectAction(checks, step.within, step.stays_for)
            case _:
                yield from self._own(step)

    @abstractmethod
    def _own(
        self, step: CallStep | InjectStep | ClearStep | TelegramsStep | SequenceStep
    ) -> Iterable[Action]:
        """A step that there is only on a stage of this kind, or that is refused there."""

    def _report(self, code: str, message: str, place: Span | None, advice: str) -> None:
        self._found.append(Diagnostic(code, message, place, advice))

    def _writes(self, step: SetStep) -> Iterable[Write]:
        for path, value in step.set.items():
            place = key_span(step, "set", path)
            try:
                target = self._stage.paths.writable(path, place)
                yield Write(value_span(step, "set", path), target, target.kind.read(value))
            except DiagnosticError as wrong:
                self._found += wrong.diagnostics
            except WrongValueError as wrong:
                there = value_span(step, "set", path)
                self._found.append(wrong_value(path, target.kind, value, there, wrong))


class _BlockSteps(_AnySteps):
    """Steps of a block on its own."""

    def _own(
        self, step: CallStep | InjectStep | ClearStep | TelegramsStep | SequenceStep
    ) -> Iterable[Action]:
        if isinstance(step, CallStep):
            yield CallAction(step.call)
            return
        message = "a block on its own has no devices around it"
        advice = "leave the step out, or leave out block: and test it in its plant"
        self._report("FB8018", message, step.span, advice)


class _PlantSteps(_AnySteps):
    """Steps of a whole plant."""

    def __init__(self, stage: PlantStage, conditions: Conditions, found: list[Diagnostic]) -> None:
        super().__init__(stage, conditions, found)
        self._plant_stage = stage
        self._faults = FaultSteps(stage.installation, found)

    def _own(
        self, step: CallStep | InjectStep | ClearStep | TelegramsStep | SequenceStep
    ) -> Iterable[Action]:
        match step:
            case InjectStep():
                yield from self._faults.inject(step)
            case ClearStep():
                yield from self._faults.clear(step)
            case CallStep():
                message = "the CPU of a plant calls its program by itself"
                advice = "wait: for some cycles, or name a block: to be called"
                self._report("FB8018", message, step.span_of("call"), advice)
            case _:
                yield from self._compare(step)

    def _compare(self, step: TelegramsStep | SequenceStep) -> Iterable[Action]:
        gateways = self._plant_stage.installation.gateways
        if step.gateway not in gateways:
            message = f"there is no gateway '{step.gateway}'"
            self._report(
                "FB8004", message, step.span_of("gateway"), nearest(step.gateway, gateways)
            )
        if isinstance(step, TelegramsStep):
            telegrams = step.telegrams
            self._found += [item for each in telegrams for item in pattern_problems(each)]
        else:
            known = {
                name: item for name, item in self._stage.catalog.sequences.items() if item.telegrams
            }
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
            yield CompareAction(
                TelegramCheck(self._plant_stage, step.span, step.gateway, tuple(telegrams))
            )
