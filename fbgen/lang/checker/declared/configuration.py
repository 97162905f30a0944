"""Tasks: which program runs when.

Sources: IEC 61131-3 third edition, section 6.8 and table 62 and 63.
"""

from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Task, Variable
from fbgen.lang.checker.library import Library
from fbgen.lang.checker.types.constants import constant_of
from fbgen.lang.types import BOOL, LTIME, UINT
from fbgen.nearest import nearest
from fbgen.source import Span

_PROPERTIES = ("INTERVAL", "PRIORITY", "SINGLE")
_FREE_RUNNING = 65_535


def tasks_of(library: Library) -> tuple[Task, ...]:
    """The tasks of all configurations with their programs, the most urgent first.

    Programs without a task run in one of their own, free running and after all others.
    """
    tasks: list[Task] = []
    for configuration in library.configurations:
        for resource in configuration.resources:
            tasks += _tasks_of_resource(library, resource)
    return tuple(sorted(tasks, key=lambda task: task.priority))


def _tasks_of_resource(library: Library, resource: ast.Resource) -> list[Task]:
    programs: dict[str, list[tuple[str, Block]]] = {"": []}
    nodes: dict[str, ast.Task] = {}
    for node in resource.tasks:
        key = node.name.casefold()
        if key in nodes:
            library.duplicate(node.name, node.span, nodes[key].span)
        nodes[key] = node
        programs[key] = []
    taken: dict[str, Span] = {}
    for instance in resource.programs:
        if instance.name.casefold() in taken:
            library.duplicate(instance.name, instance.span, taken[instance.name.casefold()])
        taken[instance.name.casefold()] = instance.span
        key = instance.task.casefold()
        if key not in programs:
            library.findings.error(
                "FB4060",
                f"there is no task '{instance.task}' in resource {resource.name}",
                instance.span,
                nearest(instance.task, (node.name for node in resource.tasks)),
            )
            continue
        block = _program(library, instance)
        if block is not None:
            programs[key].append((instance.name, block))
    tasks = [_task(library, node, tuple(programs[key])) for key, node in nodes.items()]
    if programs[""]:
        tasks.append(Task(resource.name, None, _FREE_RUNNING, tuple(programs[""])))
    return tasks


def _program(library: Library, instance: ast.ProgramInstance) -> Block | None:
    block = library.user_block(instance.type.name)
    if block is not None and block.kind is BlockKind.PROGRAM:
        return block
    library.findings.error(
        "FB4060",
        f"there is no PROGRAM '{instance.type.name}'",
        instance.type.span,
        nearest(instance.type.name, library.block_names()),
    )
    return None


def _task(library: Library, node: ast.Task, programs: tuple[tuple[str, Block], ...]) -> Task:
    ctx = library.global_context()
    interval_ns: int | None = None
    priority = 0
    single = ""
    for item in node.properties:
        name = item.name.upper()
        if name not in _PROPERTIES or item.value is None:
            library.findings.error(
                "FB4061",
                f"a task has no property '{item.name}' here",
                item.span,
                "INTERVAL, PRIORITY and SINGLE are what a task can have",
            )
        elif name == "SINGLE":
            single = _event(library, item.value)
        elif name == "INTERVAL":
            value = constant_of(ctx, item.value, LTIME, "INTERVAL")
            interval_ns = None if value is None else int(value)
        else:
            value = constant_of(ctx, item.value, UINT, "PRIORITY")
            priority = 0 if value is None else int(value)
    if single and interval_ns is not None:
        library.findings.error(
            "FB4061",
            f"task '{node.name}' has INTERVAL and SINGLE",
            node.span,
            "choose one: a period, or the edge of a variable",
        )
    if interval_ns is not None and interval_ns <= 0:
        library.findings.error(
            "FB4061",
            f"task '{node.name}' has an INTERVAL of zero",
            node.span,
            "use a time above zero, or leave INTERVAL out",
        )
        interval_ns = None
    return Task(node.name, interval_ns, priority, programs, single)


def _event(library: Library, value: ast.Expression) -> str:
    """The global BOOL that starts a task."""
    name = value.name if isinstance(value, ast.Name) else ""
    variable = library.globals.entries.get(name.casefold())
    if isinstance(variable, Variable) and variable.type == BOOL:
        return variable.name
    library.findings.error(
        "FB4061",
        f"SINGLE takes a global variable of type BOOL, not '{value.span.text}'",
        value.span,
        "declare it in VAR_GLOBAL of the configuration",
    )
    return ""
