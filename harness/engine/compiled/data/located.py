"""What a path from outside leads to, and which variables have an absolute address."""

from collections.abc import Container, Mapping
from typing import Any

from fbgen.lang.checked import Program, Variable
from harness.engine.compiled.data.memory import Location, Memory
from harness.engine.compiled.data.model import Model, Record
from harness.engine.faults import wrong_path
from harness.engine.path_types import global_steps


def located_at(
    path: str, program: Program, located: Mapping[str, Variable], programs: Container[str]
) -> Variable | None:
    """The variable with an absolute address that a path names, global or of a PROGRAM."""
    steps = [step.casefold() for step in global_steps(program, path) if isinstance(step, str)]
    if len(steps) == 1:
        return located.get(steps[0])
    if len(steps) == 2 and steps[0] in programs:
        for variable in program.program_instances()[steps[0]].variables:
            if variable.name.casefold() == steps[1] and variable.address is not None:
                return variable
    return None


def found_at(
    path: str,
    memory: Memory,
    model: Model,
    variables: object,
    programs: Mapping[str, tuple[Record, Any]],
) -> Location:
    """Where the data at a path is. `variables` holds the global ones.

    Raises DiagnosticError FB6020 and FB6024 for a path that leads nowhere.
    """
    first, *rest = global_steps(model.program, path)
    if isinstance(first, tuple):
        raise wrong_path(path, "it starts with an index")
    record = model.global_record
    if record.part(first) is None and first.casefold() in programs:
        record, data = programs[first.casefold()]
        if not rest:
            raise wrong_path(path, f"'{first}' is a PROGRAM: name one of its variables")
        return memory.find_in(path, data, record, rest)
    return memory.find_in(path, variables, record, (first, *rest))
