"""The variables of PROGRAMs: an object of their own, or a global one if other blocks name them."""

from collections.abc import Iterator, Mapping
from typing import Any

from harness.engine.compiled.data.model import Model, Record


def programs(
    model: Model, namespace: Mapping[str, Any]
) -> Iterator[tuple[str, tuple[Record, Any]]]:
    """The PROGRAMs, and those of tasks, by casefolded name: the record and its object."""
    for key, block in model.program.program_instances().items():
        variable = model.program.program_variable(key)
        shared = None if variable is None else namespace[model.global_name(variable)]
        data = namespace[model.name_of(block)]() if shared is None else shared
        yield key, (model.block_record(block), data)
