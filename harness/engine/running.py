"""A program that runs by itself on the virtual clock, without a plant.

Start-up blocks, then the program cycle, tasks and cyclic interrupts, each at its instants. Nothing
takes time here, so nothing can be interrupted: what is due at one instant runs in the order of its
priority. For execution times, preemption and hardware there is `harness.plc`.
"""

from harness.engine.interface import Engine
from harness.engine.organization import CyclicInterrupt, ObSettings, cyclic_interrupts
from harness.engine.tasks import CyclicTask, cyclic_tasks, startup_blocks
from harness.kernel import Kernel


class Running:
    """The runs of one loaded program. `scans` counts those of the program cycle."""

    __slots__ = ("_cycle_ns", "_engine", "_interrupts", "_kernel", "_obs", "_tasks", "scans")

    def __init__(self, engine: Engine, kernel: Kernel, cycle_ns: int, obs: ObSettings) -> None:
        """Raises DiagnosticError: FB7404, FB7410, FB7411."""
        self._engine = engine
        self._kernel = kernel
        self._cycle_ns = cycle_ns
        self._obs = obs
        self._tasks = cyclic_tasks(engine.program, obs)
        self._interrupts = cyclic_interrupts(engine.program, obs)
        self.scans = 0

    def start(self, *, warm: bool) -> None:
        """A restart: initial values, the start-up block, and everything is due from now on."""
        engine, now_ns = self._engine, self._kernel.now_ns
        engine.reset(warm)
        self.scans = 0
        for name in startup_blocks(engine.program, self._obs, warm=warm):
            engine.run_block(name)
        for task in self._tasks:
            task.due_ns, task.was_true = now_ns, False
        for interrupt in self._interrupts:
            period = interrupt.period
            interrupt.due_ns = now_ns + period.interval_ns + period.phase_ns

    def scan(self, count: int) -> None:
        """Run until the program cycle, or else the first task, has run `count` times more."""
        last = self.scans + count
        while self.scans < last:
            self._step()

    def run_until(self, end_ns: int) -> None:
        """Run everything that is due before `end_ns`; the clock then shows it."""
        while self._next_ns() < end_ns:
            self._step()
        self._kernel.run_until(end_ns)

    def _next_ns(self) -> int:
        cyclic = min(task.due_ns for task in self._tasks)
        return min((one.due_ns for one in self._interrupts if one.due_ns < cyclic), default=cyclic)

    def _step(self) -> None:
        """Let time pass up to the next run, and run it."""
        self._kernel.run_until(self._next_ns())
        now_ns = self._kernel.now_ns
        due = [one for one in self._interrupts if one.due_ns <= now_ns]
        if due:
            self._interrupt(max(due, key=lambda one: one.number))
        else:
            self._run(next(task for task in self._tasks if task.due_ns <= now_ns))

    def _interrupt(self, interrupt: CyclicInterrupt) -> None:
        interval_ns = interrupt.period.interval_ns
        late = (self._kernel.now_ns - interrupt.due_ns) // interval_ns
        interrupt.due_ns += (late + 1) * interval_ns
        self._engine.run_block(interrupt.block)

    def _run(self, task: CyclicTask) -> None:
        task.ran(self._kernel.now_ns, self._cycle_ns)
        if task.is_wanted(self._engine):
            for name in task.blocks:
                self._engine.run_block(name)
        if task is self._counted():
            self.scans += 1

    def _counted(self) -> CyclicTask:
        free = (task for task in self._tasks if task.interval_ns is None and not task.single)
        return next(free, self._tasks[0])
