"""The virtual clock after the wall clock: what is due happens when it is due, not sooner."""

from collections.abc import Callable
from time import monotonic_ns

from harness.kernel import NS_PER_S, Kernel


class Pace:
    """Leads a kernel along the wall clock, from now on."""

    def __init__(self, kernel: Kernel, clock_ns: Callable[[], int] = monotonic_ns) -> None:
        self._kernel = kernel
        self._clock_ns = clock_ns
        self._offset_ns = clock_ns() - kernel.now_ns

    @property
    def due_ns(self) -> int:
        """The instant that the virtual clock ought to show."""
        return self._clock_ns() - self._offset_ns

    def wait_s(self, most_s: float) -> float:
        """How long there is nothing to do; `most_s` at most."""
        left_ns = self._kernel.quiet_until_ns() - self.due_ns
        return min(max(left_ns / NS_PER_S, 0.0), most_s)

    def catch_up(self) -> int:
        """Let happen what is due; how late the first of it was, 0 if nothing was due."""
        kernel = self._kernel
        next_ns, due_ns = kernel.next_event_ns(), self.due_ns
        kernel.run_until(due_ns)
        return 0 if next_ns is None or next_ns > due_ns else due_ns - next_ns
