"""What a caller from outside gives a FUNCTION or a method, and what it gets back, by variable."""

from collections.abc import Mapping
from typing import Any

from fbgen.lang.checked import Variable
from harness.engine.faults import unknown_name
from harness.engine.interface import Value


def given_inputs(
    parameters: tuple[Variable, ...], arguments: Mapping[str, Value]
) -> dict[Variable, Value]:
    """The arguments by their parameters. Raises FB6020."""
    by_key = {variable.name.casefold(): variable for variable in parameters}
    given = {}
    for name, value in arguments.items():
        if name.casefold() not in by_key:
            raise unknown_name("input", name, [variable.name for variable in parameters])
        given[by_key[name.casefold()]] = value
    return given


def by_variable(returned: tuple[Variable, ...], values: Any) -> dict[Variable, Any]:
    """What the Python function of a block returned."""
    if len(returned) == 1:
        return {returned[0]: values}
    return dict(zip(returned, values or (), strict=True))
