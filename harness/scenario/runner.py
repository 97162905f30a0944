"""Runs one scenario: builds its plant, carries its steps out, checks what comes of them.

Expectations are looked at every virtual millisecond while they wait. The first one that does not
hold ends the scenario, with the telegrams that went before.
"""

from collections.abc import Mapping

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note, error
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.faults import FAULTS, Fault, Target
from harness.faults.settings import fault_settings
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.report.telegrams import TelegramRecorder, one_line
from harness.scenario.model import (
    ClearStep,
    Expectation,
    ExpectedTelegram,
    ExpectStep,
    InjectStep,
    Scenario,
    SetStep,
    Step,
    TelegramsStep,
    WaitStep,
)
from harness.scenario.paths import Getter, Paths
from harness.scenario.values import bytes_match, decoded, demanded, describe, holds

_RESOLUTION_NS = NS_PER_MS
_TELEGRAMS_SHOWN = 3


class ScenarioRun:
    """One scenario on one plant. `checks` counts what was demanded and held."""

    def __init__(self, scenario: Scenario, plant: Installation, catalog: Catalog) -> None:
        self.checks = 0
        self.installation = plant
        self._plant = plant
        self._catalog = catalog
        self._paths = Paths(plant, catalog)
        self._steps = scenario.steps
        self._faults: dict[tuple[str, str], Fault] = {}
        self.recorders: Mapping[str, TelegramRecorder] = plant.record_telegrams()
        self._seen = dict.fromkeys(self.recorders, 0)

    def run(self) -> None:
        """All steps. Raises DiagnosticError FB8001, FB8003 to FB8006."""
        self._plant.start()
        for step in self._steps:
            self._carry_out(step)

    def _carry_out(self, step: Step) -> None:
        if isinstance(step, SetStep):
            for path, value in step.set.items():
                self._paths.set(path, value, _value_span(step, "set", path))
        elif isinstance(step, WaitStep):
            self._plant.run_for(step.wait)
        elif isinstance(step, ExpectStep):
            self._expect(step)
        elif isinstance(step, InjectStep):
            self._inject(step)
        elif isinstance(step, ClearStep):
            self._clear(step)
        else:
            self._compare_telegrams(step)

    # --- expectations -----------------------------------------------------------------------

    def _expect(self, step: ExpectStep) -> None:
        checks = [
            (path, expected, self._paths.getter(path, _value_span(step, "expect", path)))
            for path, expected in step.expect.items()
        ]
        deadline_ns = self._plant.kernel.now_ns + (step.within or 0)
        while failing := self._failing(checks):
            if self._plant.kernel.now_ns >= deadline_ns:
                raise DiagnosticError(
                    self._failure(step, path, expected, getter, step.within)
                    for path, expected, getter in failing
                )
            self._plant.run_for(_RESOLUTION_NS)
        end_ns = self._plant.kernel.now_ns + (step.stays_for or 0)
        while self._plant.kernel.now_ns < end_ns:
            self._plant.run_for(_RESOLUTION_NS)
            if failing := self._failing(checks):
                raise DiagnosticError(
                    self._failure(step, path, expected, getter, None)
                    for path, expected, getter in failing
                )
        self.checks += len(checks)

    def _failing(
        self, checks: list[tuple[str, Expectation, Getter]]
    ) -> list[tuple[str, Expectation, Getter]]:
        return [check for check in checks if not holds(check[1], check[2](), self._catalog)]

    def _failure(
        self,
        step: ExpectStep,
        path: str,
        expected: Expectation,
        getter: Getter,
        within_ns: int | None,
    ) -> Diagnostic:
        found = getter()
        waited = f" after {_seconds(within_ns)}" if within_ns else ""
        message = f"{path} is {describe(found)}{waited}, expected {demanded(expected)}"
        notes = [Note(f"at {_seconds(self._plant.kernel.now_ns)} of the plant's time")]
        if bits := decoded(expected, found, self._catalog):
            notes.append(Note(f"bits: {bits}"))
        return Diagnostic(
            "FB8001",
            message,
            _value_span(step, "expect", path),
            notes=(*notes, *self._last_telegrams(), *self._cpu_notes()),
        )

    def _last_telegrams(self) -> list[Note]:
        return [
            Note(f"telegram at {name}: {one_line(record)}")
            for name, recorder in self.recorders.items()
            for record in recorder.records[-_TELEGRAMS_SHOWN:]
        ]

    def _cpu_notes(self) -> list[Note]:
        return [
            Note(f"the CPU went to STOP: {found.message}", found.span)
            for found in self._plant.cpu.diagnostics
        ]

    # --- faults -----------------------------------------------------------------------------

    def _inject(self, step: InjectStep) -> None:
        kind = FAULTS.get(step.inject)
        if kind is None:
            raise _unknown("fault", step.inject, FAULTS, step.span_of("inject"))
        on = step.on or ""
        places: Mapping[str, object] = {}
        if kind.target is Target.GATEWAY:
            places = self._plant.gateways
        elif kind.target is Target.DRIVE:
            places = self._plant.drives
        if kind.target is Target.WHOLE and on:
            raise error(
                "FB8004",
                f"the fault '{kind.name}' happens to {kind.target.value} and takes no place",
                step.span_of("on"),
                "leave out on:",
            )
        if kind.target is not Target.WHOLE and on not in places:
            raise _unknown(kind.target.value, on, places, step.span_of("on"))
        if (kind.name, on) in self._faults:
            raise error(
                "FB8005",
                f"the fault '{kind.name}' is already there",
                step.span_of("inject"),
                "clear it before it is injected again",
            )
        fault = kind.make(self._plant, on, fault_settings(kind, step.settings, step.span))
        self._faults[kind.name, on] = fault
        fault.inject()

    def _clear(self, step: ClearStep) -> None:
        fault = self._faults.pop((step.clear, step.on or ""), None)
        if fault is None:
            there = ", ".join(f"{name} on {on}" if on else name for name, on in self._faults)
            raise error(
                "FB8005",
                f"there is no fault '{step.clear}' to clear here",
                step.span_of("clear"),
                f"injected are: {there or 'none'}",
            )
        fault.clear()

    # --- telegrams --------------------------------------------------------------------------

    def _compare_telegrams(self, step: TelegramsStep) -> None:
        if step.gateway not in self.recorders:
            raise _unknown("gateway", step.gateway, self.recorders, step.span_of("gateway"))
        records = self.recorders[step.gateway].records[self._seen[step.gateway] :]
        self._seen[step.gateway] += len(records)
        wanted: list[ExpectedTelegram] = list(step.telegrams or ())
        if step.of_sequence is not None:
            sequence = self._catalog.sequence(step.of_sequence)
            wanted = [
                ExpectedTelegram(output=item.output, input=item.input)
                for item in sequence.telegrams
            ]
        found: list[Diagnostic] = []
        if len(records) != len(wanted):
            found.append(
                Diagnostic(
                    "FB8006",
                    f"{len(records)} telegrams went out, expected {len(wanted)}",
                    step.span,
                    notes=tuple(Note(one_line(record)) for record in records),
                )
            )
        for number, (record, expected) in enumerate(zip(records, wanted, strict=False), start=1):
            for what, pattern, data in (
                ("output", expected.output, record.output),
                ("input", expected.input, record.input),
            ):
                if pattern is not None and not bytes_match(pattern, data):
                    shown = data.hex(" ").upper() if data is not None else "nothing"
                    message = f"the {what} of telegram {number} is {shown}, expected {pattern}"
                    found.append(Diagnostic("FB8006", message, expected.span or step.span))
        if found:
            raise DiagnosticError(found)
        self.checks += len(wanted)


def _value_span(step: SetStep | ExpectStep, field: str, path: str) -> Span | None:
    """Where a path stands inside of the mapping of a step."""
    span = step.span_of(field)
    if span is None:
        return None
    offset = span.text.find(path)
    start = span.start + max(offset, 0)
    return Span(span.source, start, start + len(path)) if offset >= 0 else span


def _unknown(
    what: str, name: str, known: Mapping[str, object], span: Span | None
) -> DiagnosticError:
    return error("FB8004", f"there is no {what} '{name}' here", span, nearest(name, known))


def _seconds(time_ns: int) -> str:
    return f"{time_ns / NS_PER_S:.3f} s"
