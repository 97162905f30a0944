"""The trace of a scenario: its plant recorded from before the start, with steps, checks, faults."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from harness.engine.compiled import ProbeMaker, writers_probe
from harness.results import ScenarioResult
from harness.scenario.block_stage import BlockStage
from harness.scenario.cases import ScenarioCase
from harness.scenario.events import StepEvent, StepMoment
from harness.scenario.expectations import Expectation, Range
from harness.scenario.fault_plans import ClockFault
from harness.scenario.model import (
    CallStep,
    ClearStep,
    ExpectStep,
    InjectStep,
    Scenario,
    SequenceStep,
    SetStep,
    Step,
    WaitStep,
    WaitUntilStep,
)
from harness.scenario.places import key_span
from harness.scenario.runner import ScenarioRun
from harness.scenario.scalars import Scalar
from harness.trace import Mark, Place, Recorder, Trace, Verdict
from harness.trace.blocks import BlockRecorder
from harness.trace.places import place_of

_PLC = "plc."
_NS = {1_000_000_000: "s", 1_000_000: "ms", 1_000: "us", 1: "ns"}


class TraceObserver:
    """Leaves the `Trace` of one run. Variables that its steps name are recorded as well."""

    def __init__(self, case: ScenarioCase) -> None:
        self._scenario = case.scenario
        self._compiled = case.scenario.engine == "compiled"
        self._recorder: Recorder | BlockRecorder | None = None
        self._step = 0
        self._checks: list[int] = []
        self._faults: dict[tuple[str, str], int] = {}
        self._clock_faults: Sequence[ClockFault] = ()

    @property
    def probes(self) -> tuple[ProbeMaker, ...]:
        """Who wrote what, which the compiled engine can tell."""
        return (writers_probe,) if self._compiled else ()

    def attach(self, run: ScenarioRun) -> None:
        """Record from now on: a plant, or a block on its own."""
        run.on_step.append(self._told)
        if isinstance(run.stage, BlockStage):
            self._recorder = run.stage.record()
            return
        variables = [path.removeprefix(_PLC) for path in _paths(self._scenario)]
        self._clock_faults = run.clock_faults
        self._recorder = run.installation.record(variables)

    def finish(self, result: ScenarioResult) -> Trace | None:
        """The trace; the checks whose places the failures name have failed."""
        if self._recorder is None:
            return None
        self._mark_clock_faults(self._recorder)
        trace = self._recorder.finish(result.name, result.file)
        wrong = {place_of(found.span) for found in result.failures if found.span is not None}
        marks = tuple(_judged(mark, trace, wrong) for mark in trace.marks)
        return replace(trace, marks=marks)

    def _mark_clock_faults(self, recorder: Recorder | BlockRecorder) -> None:
        """Those that have come until now: they are known from the start, so nobody has to look."""
        start_ns, now_ns = recorder.begin_ns, recorder.now_ns
        for event, _, place in self._clock_faults:
            at_ns = start_ns + event.at_ns
            if at_ns <= now_ns:
                end_ns = None if event.lasts_ns is None else start_ns + event.end_ns
                end_ns = end_ns if end_ns is not None and end_ns <= now_ns else None
                recorder.marks.add_fault(event.name, event.on, place, at_ns, end_ns)

    def _told(self, event: StepEvent) -> None:
        assert self._recorder is not None, "only a run that it is attached to tells of its steps"
        if event.moment is StepMoment.BEGUN:
            self._begin(self._recorder, event.step)
            return
        verdict: Verdict = "passed" if event.moment is StepMoment.DONE else "failed"
        for number in (self._step, *self._checks):
            self._recorder.marks.end(number, verdict)
        if isinstance(event.step, SetStep):
            step = event.step
            places = {path: key_span(step, "set", path) for path in step.set}
            self._recorder.variables_written(places)

    def _begin(self, recorder: Recorder | BlockRecorder, step: Step) -> None:
        marks = recorder.marks
        self._step = marks.begin("step", _title(step), step.span)
        self._checks = []
        match step:
            case ExpectStep():
                for path, expected in step.expect.items():
                    title = f"{path}: {_wanted(expected)}{_when(step)}"
                    place = key_span(step, "expect", path)
                    self._checks.append(marks.begin("check", title, place, path))
            case InjectStep():
                place = step.span_of("inject")
                fault = marks.begin("fault", step.inject, place, step.on or "")
                self._faults[step.inject, step.on or ""] = fault
            case ClearStep():
                marks.end(self._faults.pop((step.clear, step.on or "")))


def _judged(mark: Mark, trace: Trace, wrong: set[Place]) -> Mark:
    """A check of a step that failed has passed itself unless a failure stands at its place."""
    if mark.kind != "check" or mark.verdict != "failed" or mark.place is None:
        return mark
    if not wrong or trace.places[mark.place] in wrong:
        return mark
    return replace(mark, verdict="passed")


def _paths(scenario: Scenario) -> list[str]:
    """The variables of the PLC that steps and properties name, in their order."""
    named = [path for step in scenario.steps for path in _named(step)]
    named += [path for item in scenario.properties for path in item.paths()]
    return [path for path in dict.fromkeys(named) if path.startswith(_PLC)]


def _named(step: Step) -> Iterable[str]:
    match step:
        case SetStep():
            return step.set
        case ExpectStep():
            return step.expect
        case WaitUntilStep():
            return step.wait_until
    return ()


# --- in words -----------------------------------------------------------------------------------


def _title(step: Step) -> str:
    match step:
        case SetStep():
            return "set " + ", ".join(f"{path} = {_shown(v)}" for path, v in step.set.items())
        case WaitStep():
            return f"wait {_time(step.wait)}"
        case ExpectStep():
            wanted = (f"{path}: {_wanted(item)}" for path, item in step.expect.items())
            return f"expect {', '.join(wanted)}{_when(step)}"
        case WaitUntilStep():
            wanted = (f"{path}: {_wanted(item)}" for path, item in step.wait_until.items())
            return f"wait until {', '.join(wanted)} within {_time(step.within)}"
        case CallStep():
            return f"call {step.call}"
        case InjectStep():
            return f"inject {step.inject}" + (f" on {step.on}" if step.on else "")
        case ClearStep():
            return f"clear {step.clear}" + (f" on {step.on}" if step.on else "")
        case SequenceStep():
            return f"telegrams of {step.of_sequence} on {step.gateway}"
    count = len(step.telegrams)
    return f"{count} telegram{'s' if count != 1 else ''} on {step.gateway}"


def _wanted(expected: Expectation) -> str:
    if not isinstance(expected, Range):
        return _shown(expected)
    parts = [
        f"{name} {_shown(value)}"
        for name in ("equals", "tolerance", "min", "max", "differs_from")
        if (value := getattr(expected, name)) is not None and (value or name != "tolerance")
    ]
    parts += [f"{name}={_shown(value)}" for name, value in (expected.bits or {}).items()]
    return ", ".join(parts)


def _when(step: ExpectStep) -> str:
    within = f" within {_time(step.within)}" if step.within else ""
    return within + (f", stays for {_time(step.stays_for)}" if step.stays_for else "")


def _shown(value: Scalar) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else str(value)


def _time(time_ns: int) -> str:
    unit = next(unit for unit in _NS if time_ns % unit == 0 and time_ns >= unit)
    return f"{time_ns // unit} {_NS[unit]}"
