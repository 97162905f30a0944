"""The variables of PROGRAMs: an object of their own, or a global one if other blocks name them."""

from collections.abc import Mapping
from typing import Any

from harness.engine.compiled.model import Model


def program_data(model: Model, namespace: Mapping[str, Any], key: str) -> Any:
    """The object with the variables of a PROGRAM, or of a task's instance of one."""
    variable = model.program.program_variable(key)
    if variable is not None:
        return namespace[model.global_name(variable)]
    return namespace[model.name_of(model.program.program_instances()[key])]()
