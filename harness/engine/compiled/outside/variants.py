"""Variables that are handed over from outside for a VARIANT, ANY or POINTER."""

from collections.abc import Callable
from typing import Any

from fbgen.lang.types import Type
from harness.engine.compiled.data.memory import Location, Memory
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.data.placement import Bytes
from harness.engine.compiled.expressions.bound_variants import Variant
from harness.engine.interface import Engine, Reference, Value


class OutsideCell:
    """A single value somewhere in the data of the program."""

    __slots__ = ("_read", "_write")

    def __init__(self, read: Callable[[], Any], write: Callable[[Any], None]) -> None:
        self._read = read
        self._write = write

    @property
    def value(self) -> Any:
        """The value."""
        return self._read()

    @value.setter
    def value(self, content: Any) -> None:
        self._write(content)


def reference_to(engine: Engine, path: str, found: Location | Type) -> Reference:
    """A reference to what stands at a path; of what has an absolute address there is the type."""

    def read() -> Value:
        return engine.global_value(path)

    def write(value: Value) -> None:
        engine.set_global(path, value)

    if not isinstance(found, Location):
        return Reference(found, Variant(found, OutsideCell(read, write)), read, write)
    target: Any = OutsideCell(found.read, found.write)
    if not is_scalar(found.kind):
        target = found.read()
    return Reference(found.kind, Variant(found.kind, target), read, write)


def new_variable(memory: Memory, data: Bytes, kind: Type, value: Value | None) -> Reference:
    """A variable of its own, in bytes, so that it has an address."""
    first = bytearray(data.layout.encode(kind, data.shapes.value(kind, None)))
    view = data.view(kind, first, 0)
    if is_scalar(kind):
        location = Location(kind, lambda: view.value, lambda given: setattr(view, "value", given))
    else:
        location = Location(kind, lambda: view, lambda _: None)

    def read() -> Value:
        return memory.export(kind, location.read())

    def write(given: Value) -> None:
        memory.load("value", location, given)

    if value is not None:
        write(value)
    return Reference(kind, Variant(kind, view), read, write)
