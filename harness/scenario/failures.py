"""The text of a scenario that failed: what was found, what it means, and what went before."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.source import Span
from harness.kernel import NS_PER_S
from harness.scenario.actions import Write
from harness.scenario.conditions import Check
from harness.scenario.kinds import Found
from harness.scenario.monitors import Monitor, Violation
from harness.scenario.stage import Stage


class Failures:
    """Makes the findings of one run."""

    def __init__(self, stage: Stage) -> None:
        self._stage = stage
        self._set: dict[object, tuple[Span | None, object]] = {}

    def was_set(self, write: Write) -> None:
        """A step has set something: that is the last write until the PLC writes it."""
        last = write.target.writer() if write.target.writer is not None else None
        if last is not None:
            self._set[last.where] = (write.place, last.entry)

    def _last_write(self, check: Check) -> Iterator[Note]:
        """Who wrote a value last, where that is known."""
        last = check.source.writer() if check.source.writer is not None else None
        if last is None:
            return
        place, entry = self._set.get(last.where, (None, None))
        if place is not None and entry is last.entry:
            yield Note("it was last set here", place)
        elif last.span is not None:
            by = f", by {last.instance}" if last.instance else ""
            yield Note(f"it was last written here{by}", last.span)
        else:
            yield Note("the PLC has not written it since it started")

    def unmet(self, checks: Sequence[Check], when: str) -> list[Diagnostic]:
        """FB8001 for each path that is not as demanded; what went before stands with the last."""
        now_ns = self._stage.kernel.now_ns
        found = []
        for check in checks:
            value = check.source.get()
            if not check.demand.holds(value):
                shown = f"{check.path} is {check.show(value)}{when}"
                message = f"{shown}, expected {check.demand.describe()}"
                notes = (_instant(now_ns), *_decoded(check, value), *self._last_write(check))
                found.append(Diagnostic("FB8001", message, check.place, notes=notes))
        return self.with_past(found)

    def violated(self, monitor: Monitor, violation: Violation) -> Diagnostic:
        """FB8020: a property of the scenario is violated."""
        notes = [_instant(violation.time_ns)]
        for check, value in violation.seen:
            notes += [*_decoded(check, value), *self._last_write(check)]
        item = monitor.property
        message = f"{item.name}: {violation.message}" if item.name else violation.message
        return Diagnostic("FB8020", message, violation.seen[0][0].place, notes=tuple(notes))

    def decided_nothing(self, monitor: Monitor) -> Diagnostic:
        """FB8021, a warning: a property had nothing to decide in this run."""
        name = f" '{monitor.property.name}'" if monitor.property.name else ""
        return Diagnostic(
            "FB8021",
            f"the property{name} shows nothing: {monitor.never_counted}",
            monitor.property.span,
            "let the steps bring it about, or leave the property out here",
            severity=Severity.WARNING,
        )

    def with_past(self, found: Sequence[Diagnostic]) -> list[Diagnostic]:
        """Findings, the last of them with the last telegrams and why the CPU is in STOP."""
        last = found[-1]
        notes = (*last.notes, *self._stage.past())
        return [*found[:-1], replace(last, notes=notes)]

    def waited(self, within_ns: int) -> str:
        """How long it was waited, for a message."""
        return f" after {seconds(within_ns)}" if within_ns else ""

    def held(self, held_ns: int, wanted_ns: int) -> str:
        """How long it held, for a message."""
        return f" {seconds(held_ns)} after it was right, of {seconds(wanted_ns)} to stay so"


def _instant(time_ns: int) -> Note:
    return Note(f"at {seconds(time_ns)} of the plant's time")


def _decoded(check: Check, value: Found) -> Iterator[Note]:
    """The bits of a word by name, as found and as demanded."""
    wanted = check.demand.equals
    for word in (value, wanted) if wanted is not None else (value,):
        if fields := check.demand.decoded(word):
            yield Note(f"{check.show(word)} means: {fields}")


def seconds(time_ns: int) -> str:
    """A time for a message."""
    return f"{time_ns / NS_PER_S:.3f} s"
