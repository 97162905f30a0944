"""`.TcTTO`: a task of TwinCAT, which is a CONFIGURATION with one TASK as text.

CycleTime is in microseconds, and of two tasks the one with the lower Priority goes first, as in
IEC 61131-3. Programs of libraries (VisuElems.Visu_Prg) are left out: they are in no file.
Source: files that TwinCAT XAE writes, in published projects.
"""

from collections.abc import Iterator

from fbgen.lang.ast import Configuration, Literal, LiteralKind, ProgramInstance, Resource, Task
from fbgen.lang.containers.embedded import Assembly, content
from fbgen.lang.containers.xml_tree import Element

_NS_PER_US = 1000
_US_PER_MS = 1000
_RESOURCE = "PLC"


def write_task(text: Assembly, item: Element) -> None:
    """The task as a CONFIGURATION."""
    text.add("CONFIGURATION ")
    text.add_attribute(item, "Name")
    text.add(f"\nRESOURCE {_RESOURCE} ON PLC\nTASK ")
    text.add_attribute(item, "Name")
    text.add("(")
    cycle, priority = item.child("CycleTime"), item.child("Priority")
    if cycle is not None and content(cycle).strip().isdecimal():
        ms, rest = divmod(int(content(cycle)), _US_PER_MS)
        interval = f"LTIME#{int(content(cycle))}us" if rest else f"T#{ms}ms"
        text.add_at(f"INTERVAL := {interval}, ", cycle.inner_start)
    text.add("PRIORITY := ")
    if priority is not None and content(priority).strip().isdecimal():
        text.add_content(priority)
    else:
        text.add("0")
    text.add(");\n")
    for call in item.named("PouCall"):
        for name in call.named("Name"):
            program = content(name).strip()
            if program and "." not in program:
                text.add_at("PROGRAM ", name.inner_start)
                text.add_content(name)
                text.add(" WITH ")
                text.add_attribute(item, "Name")
                text.add(" : ")
                text.add_content(name)
                text.add(";\n")
    text.add("END_RESOURCE\nEND_CONFIGURATION\n")


# --- writing ------------------------------------------------------------------------------------


def is_of_tasks(unit: Configuration) -> bool:
    """True if there is nothing in a configuration but tasks and the programs that they call."""
    return not unit.sections and all(_is_of_tasks(one) for one in unit.resources)


def _is_of_tasks(resource: Resource) -> bool:
    return (
        not resource.sections
        and all(_fits(task) for task in resource.tasks)
        and all(_calls(one, resource) for one in resource.programs)
    )


def _fits(task: Task) -> bool:
    return all(
        one.name.upper() in ("INTERVAL", "PRIORITY") and isinstance(one.value, Literal)
        for one in task.properties
    )


def _calls(program: ProgramInstance, resource: Resource) -> bool:
    """True for a program that its task calls by its own name, once."""
    same = [one for one in resource.programs if one.type.name == program.type.name]
    return len(same) == 1 and bool(program.task) and not (program.arguments or program.qualifiers)


def task_objects(unit: Configuration) -> Iterator[tuple[str, str]]:
    """Name and content of each task."""
    for resource in unit.resources:
        for task in resource.tasks:
            values = {one.name.upper(): one.value for one in task.properties}
            inside = ""
            cycle = values.get("INTERVAL")
            if isinstance(cycle, Literal) and cycle.kind is LiteralKind.DURATION:
                inside += "    <!--CycleTime in micro seconds.-->\n"
                inside += f"    <CycleTime>{int(cycle.value) // _NS_PER_US}</CycleTime>\n"
            priority = values.get("PRIORITY")
            number = priority.value if isinstance(priority, Literal) else 0
            inside += f"    <Priority>{number}</Priority>\n"
            for program in resource.programs:
                if program.task.casefold() == task.name.casefold():
                    name = program.type.name
                    inside += f"    <PouCall>\n      <Name>{name}</Name>\n    </PouCall>\n"
            yield task.name, inside
