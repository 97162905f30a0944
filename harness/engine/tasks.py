"""What a CPU runs, and when: program cycle, cyclic interrupts or tasks, and start-up blocks.

On S7 the user's OB1 runs and those from OB123 on behind it, or, where the files have none, the
harness's own, which calls TOS_Main or what the settings name. IEC programs run as their
CONFIGURATION says; without one every PROGRAM that no block calls runs once a cycle.
"""

from collections import Counter

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Program, Task
from harness.engine.interface import Engine
from harness.engine.organization import (
    COLD_RESTART,
    PROGRAM_CYCLE,
    WARM_RESTART,
    ObSettings,
    organization_blocks,
)

_FIRST_FURTHER = 123


@dataclass(slots=True)
class CyclicTask:
    """Blocks that run together. Without an interval they run with the CPU's cycle.

    `due_ns` is the instant of the next run; a lower `priority` goes first. A task with `single`
    looks at that variable once a cycle and runs if it has become TRUE.
    """

    name: str
    interval_ns: int | None
    priority: int
    blocks: tuple[str, ...]
    due_ns: int = 0
    single: str = ""
    was_true: bool = False

    def is_wanted(self, engine: Engine) -> bool:
        """Whether it is to run now that it is due."""
        if not self.single:
            return True
        was_true, self.was_true = self.was_true, bool(engine.global_value(self.single))
        return self.was_true and not was_true

    def ran(self, start_ns: int, cycle_ns: int) -> None:
        """The next run comes a cycle later, or on the grid of the interval, none twice."""
        if self.interval_ns is None:
            self.due_ns = start_ns + cycle_ns
        else:
            late = (start_ns - self.due_ns) // self.interval_ns
            self.due_ns += (late + 1) * self.interval_ns


def cyclic_tasks(program: Program, settings: ObSettings | None = None) -> list[CyclicTask]:
    """The tasks of a program, in the order of their priorities.

    Raises DiagnosticError: FB7404 for a program in which nothing would ever run, and as
    `organization_blocks`.
    """
    if program.tasks:
        often = Counter(block for task in program.tasks for _, block in task.programs)
        tasks = [
            CyclicTask(
                task.name, task.interval_ns, task.priority, _names(task, often), single=task.single
            )
            for task in program.tasks
        ]
        return sorted(tasks, key=lambda task: task.priority)
    known = settings or ObSettings()
    numbered = organization_blocks(program, known)
    main = program.blocks.get(known.main_function.casefold())
    blocks = [name for number, name in numbered.items() if number == PROGRAM_CYCLE]
    if not blocks and main is not None and main.kind is BlockKind.FUNCTION:
        blocks = [main.name]
    blocks += [name for number, name in numbered.items() if number >= _FIRST_FURTHER]
    if blocks:
        return [CyclicTask("OB1", None, 1, tuple(blocks))]
    programs = tuple(
        block.name
        for block in program.blocks.values()
        if block.kind is BlockKind.PROGRAM and block not in program.called_programs
    )
    if not programs:
        raise error(
            "FB7404",
            "nothing in these files would run on a controller",
            next((block.span for block in program.blocks.values()), None),
            f'add an ORGANIZATION_BLOCK "Main", a FUNCTION {known.main_function} or a PROGRAM',
        )
    return [CyclicTask("cycle", None, 1, programs)]


def _names(task: Task, often: Counter[Block]) -> tuple[str, ...]:
    """What to run: a PROGRAM by its own name, or by those of its instances if it has several."""
    return tuple(name if often[block] > 1 else block.name for name, block in task.programs)


def startup_blocks(
    program: Program, settings: ObSettings | None = None, *, warm: bool = True
) -> tuple[str, ...]:
    """The block that runs once when the CPU goes to RUN: OB100, or OB102 at a cold restart."""
    known = settings or ObSettings()
    numbered = organization_blocks(program, known)
    wanted = COLD_RESTART if not warm and COLD_RESTART in numbered else WARM_RESTART
    if wanted in numbered:
        return (numbered[wanted],)
    function = program.blocks.get(known.restart_function.casefold())
    return (function.name,) if function is not None and function.kind is BlockKind.FUNCTION else ()
