"""The CONFIGURATION that holds the global variables and runs the programs."""

from collections.abc import Sequence

from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    Configuration,
    Declaration,
    Literal,
    LiteralKind,
    NamedType,
    ProgramInstance,
    Resource,
    Task,
    VarSection,
)
from fbgen.lang.literals import duration_text
from fbgen.lang.lowering.build import integer
from fbgen.lang.lowering.schedule import Schedule
from fbgen.source import Span


def configuration(
    place: Span, schedule: Schedule, variables: Sequence[Declaration], programs: Sequence[str]
) -> Configuration:
    """One resource with one task that runs all programs in their order."""
    sections = (VarSection(place, "VAR_GLOBAL", (), tuple(variables)),) if variables else ()
    interval = Literal(
        place,
        LiteralKind.DURATION,
        schedule.interval_ns,
        duration_text(schedule.interval_ns),
        "TIME",
    )
    properties = (
        Argument(place, ArgumentKind.INPUT, "INTERVAL", interval),
        Argument(place, ArgumentKind.INPUT, "PRIORITY", integer(place, schedule.priority)),
    )
    task = Task(place, schedule.task, properties)
    instances = tuple(
        ProgramInstance(place, f"inst{name}", schedule.task, NamedType(place, name))
        for name in programs
    )
    resource = Resource(place, schedule.resource, schedule.resource_type, (), (task,), instances)
    return Configuration(place, schedule.configuration, sections, (resource,))
