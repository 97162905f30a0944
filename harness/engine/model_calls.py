"""A call that the controller's own model carries out: what it gets, and what it gives."""

from collections.abc import Mapping

from fbgen.lang.checked import RoutineCall
from fbgen.lang.types import Scalar, Type
from harness.engine.block_models import BlockModel
from harness.engine.interface import Value
from harness.engine.layout import S7


def call_model(
    node: RoutineCall, model: BlockModel, inputs: Mapping[str, Value]
) -> dict[str, Value]:
    """One call of an instance with the values of the program; the results by casefolded name."""
    kinds: dict[str, Type] = {}
    single: dict[str, Scalar] = {}
    areas: dict[str, bytes] = {}
    for name, expression in node.inputs:
        key, value = name.upper(), inputs[name]
        if key in model.areas:
            kinds[key] = expression.type
            areas[key] = S7.encode(expression.type, value)
        elif isinstance(value, bool | int | float | str):
            single[key] = value
    given = model.call(single, areas)
    results: dict[str, Value] = {name.casefold(): value for name, value in given.values.items()}
    for key, data in given.areas.items():
        whole = data + areas[key][len(data) :]
        results[key.casefold()] = S7.decode(kinds[key], whole)
    return results
