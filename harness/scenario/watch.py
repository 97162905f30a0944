"""Lets time pass while the properties of a scenario are watched; without any it costs nothing."""

from collections.abc import Sequence

from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.kernel import NS_PER_MS
from harness.scenario.failures import Failures
from harness.scenario.monitors import Monitor
from harness.scenario.stage import Stage

_RESOLUTION_NS = NS_PER_MS


class Watch:
    """All properties of a run. `count` is how many there are."""

    def __init__(self, monitors: Sequence[Monitor], stage: Stage, failures: Failures) -> None:
        self.count = len(monitors)
        self._monitors = list(monitors)
        self._stage = stage
        self._failures = failures
        self._found: list[Diagnostic] = []

    def begin(self) -> None:
        """The run begins now. Raises DiagnosticError FB8020."""
        if self._monitors:
            self._stage.after_scan.append(self._look)
        self.look_on()

    def look_on(self) -> None:
        """Look at this instant. Raises DiagnosticError FB8020 for what is violated up to now."""
        self._look()
        if self._found:
            raise DiagnosticError(self._failures.with_past(self._found))

    def pass_time(self, duration_ns: int) -> None:
        """Let time pass. Raises DiagnosticError FB8020."""
        if not self._monitors:
            self._stage.run_for(duration_ns)
            return
        kernel = self._stage.kernel
        end_ns = kernel.now_ns + duration_ns
        while kernel.now_ns < end_ns:
            next_ns = (kernel.now_ns // _RESOLUTION_NS + 1) * _RESOLUTION_NS
            self._stage.run_for(min(next_ns, end_ns) - kernel.now_ns)
            self.look_on()

    def end(self) -> tuple[Diagnostic, ...]:
        """The run is over: warnings FB8021 for what had nothing to decide.

        Raises DiagnosticError FB8020 for what should have come and did not.
        """
        now_ns = self._stage.kernel.now_ns
        for monitor in self._monitors:
            violation = monitor.end(now_ns)
            if violation is not None:
                self._found.append(self._failures.violated(monitor, violation))
        if self._found:
            raise DiagnosticError(self._failures.with_past(self._found))
        return tuple(
            self._failures.decided_nothing(monitor)
            for monitor in self._monitors
            if monitor.never_counted and not monitor.counted
        )

    def _look(self) -> None:
        """Note what is violated: inside of a scan nothing may be raised."""
        now_ns = self._stage.kernel.now_ns
        for monitor in list(self._monitors):
            violation = monitor.look(now_ns)
            if violation is not None:
                self._found.append(self._failures.violated(monitor, violation))
                self._monitors.remove(monitor)
