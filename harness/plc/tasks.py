"""What a CPU runs, and when: OB1 or the tasks of a CONFIGURATION, and the start-up block.

On S7 the user's OB1 runs, or, where the files have none, the harness's own, which calls TOS_Main.
IEC programs run as their CONFIGURATION says; without one every PROGRAM runs once a cycle.
"""

from dataclasses import dataclass

from fbgen.diagnostics import error
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Program

MAIN_FUNCTION = "TOS_Main"
_OB1 = ("main", "ob1")
_OB100 = ("startup", "ob100")


@dataclass(slots=True)
class CyclicTask:
    """Blocks that run together. Without an interval they run with the CPU's cycle.

    `due_ns` is the instant of the next run; a lower `priority` goes first.
    """

    name: str
    interval_ns: int | None
    priority: int
    blocks: tuple[str, ...]
    due_ns: int = 0


def cyclic_tasks(program: Program) -> list[CyclicTask]:
    """The tasks of a program, in the order of their priorities.

    Raises DiagnosticError FB7404 for a program in which nothing would ever run.
    """
    if program.tasks:
        tasks = [
            CyclicTask(
                task.name,
                task.interval_ns,
                task.priority,
                tuple(block.name for _, block in task.programs),
            )
            for task in program.tasks
        ]
        return sorted(tasks, key=lambda task: task.priority)
    for name in _OB1:
        block = program.blocks.get(name)
        if block is not None and block.kind is BlockKind.ORGANIZATION_BLOCK:
            return [CyclicTask("OB1", None, 1, (block.name,))]
    main = program.blocks.get(MAIN_FUNCTION.casefold())
    if main is not None and main.kind is BlockKind.FUNCTION:
        return [CyclicTask("OB1", None, 1, (main.name,))]
    programs = tuple(
        block.name for block in program.blocks.values() if block.kind is BlockKind.PROGRAM
    )
    if not programs:
        raise error(
            "FB7404",
            "nothing in these files would run on a controller",
            next((block.span for block in program.blocks.values()), None),
            f'add an ORGANIZATION_BLOCK "Main", a FUNCTION {MAIN_FUNCTION} or a PROGRAM',
        )
    return [CyclicTask("cycle", None, 1, programs)]


def startup_blocks(program: Program) -> tuple[str, ...]:
    """The blocks that run once when the CPU goes to RUN."""
    found = (program.blocks.get(name) for name in _OB100)
    return tuple(
        block.name
        for block in found
        if block is not None and block.kind is BlockKind.ORGANIZATION_BLOCK
    )
