"""Cyclic interrupts of a CPU in RUN: when they are due, and which of them waits for which.

A cyclic interrupt begins at its instant also in the middle of a scan, between two of its accesses
to hardware. One of a lower priority class waits until the other one is through. One that is due
again before it has run is lost.
"""

from collections.abc import Callable, Iterable
from functools import partial

from harness.engine.organization import CyclicInterrupt
from harness.kernel import Event, Kernel


class Interrupts:
    """The cyclic interrupts of one CPU. `run` runs a block; `lose` hears of runs that are lost."""

    __slots__ = ("_all", "_class", "_events", "_kernel", "_life", "_lose", "_pending", "_run")

    def __init__(
        self,
        kernel: Kernel,
        interrupts: Iterable[CyclicInterrupt],
        run: Callable[[str], None],
        lose: Callable[[CyclicInterrupt], None],
    ) -> None:
        self._kernel = kernel
        self._all = tuple(interrupts)
        self._run = run
        self._lose = lose
        self._class = 0
        self._pending: list[CyclicInterrupt] = []
        self._life = 0
        self._events: dict[int, Event] = {}

    @property
    def priority_class(self) -> int:
        """That of the interrupt that runs, 0 for none."""
        return self._class

    def begin(self) -> None:
        """The CPU goes to RUN: their grids begin, the first run is one interval away."""
        self.end()
        for interrupt in self._all:
            period = interrupt.period
            interrupt.due_ns = self._kernel.now_ns + period.interval_ns + period.phase_ns
            self._arrange(interrupt)

    def end(self) -> None:
        """The CPU goes to STOP."""
        for event in self._events.values():
            self._kernel.cancel(event)
        self._events.clear()
        self._pending.clear()
        self._class = 0
        self._life += 1

    def _arrange(self, interrupt: CyclicInterrupt) -> None:
        self._events[interrupt.number] = self._kernel.at(
            interrupt.due_ns, partial(self._due, interrupt)
        )

    def _due(self, interrupt: CyclicInterrupt) -> None:
        interrupt.due_ns += interrupt.period.interval_ns
        self._arrange(interrupt)
        if interrupt in self._pending:
            self._lose(interrupt)
            return
        self._pending.append(interrupt)
        self._run_next()

    def _run_next(self) -> None:
        """Run the most urgent one that waits, if it may interrupt what runs."""
        before = self._class
        waiting = [one for one in self._pending if one.priority_class > before]
        if not waiting:
            return
        interrupt = max(waiting, key=lambda one: one.number)
        self._class = interrupt.priority_class
        life = self._life
        self._run(interrupt.block)
        if life != self._life:
            return
        self._class = before
        self._pending.remove(interrupt)
        if self._pending:
            # As an event, so that an overloaded CPU does not keep the clock from stopping.
            self._kernel.at(self._kernel.now_ns, self._run_next)
