"""All objects that hold variables of a program, found from those that it has by name."""

from collections.abc import Iterable, Iterator
from typing import Any

from fbgen.lang.checked import VariableKind
from fbgen.lang.types import ArrayType, BlockType, StructType, Type
from harness.engine.compiled.data.model import Model, Record, is_scalar


def held_in(model: Model, roots: Iterable[tuple[Record, Any]]) -> Iterator[tuple[Record, Any]]:
    """These objects and all inside of them. What an in-out refers to belongs to somebody else."""
    for record, data in roots:
        yield record, data
        for part in record.parts:
            if part.kind is not VariableKind.IN_OUT and not is_scalar(part.type):
                yield from _held_as(model, part.type, getattr(data, part.slot))


def _held_as(model: Model, kind: Type, data: Any) -> Iterator[tuple[Record, Any]]:
    if isinstance(kind, ArrayType) and not is_scalar(kind.element):
        for element in data:
            yield from _held_as(model, kind.element, element)
    elif isinstance(kind, StructType | BlockType):
        yield from held_in(model, [(model.record_of(kind), data)])
