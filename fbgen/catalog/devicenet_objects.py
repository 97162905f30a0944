"""The objects of a DeviceNet device: classes, instances, attributes with their access, services.

Types are those of CIP; an array stands without a count, a structure is the row of its members.
"""

from collections.abc import Iterable
from typing import Literal

from pydantic import Field

from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.scalars import Count, Flag, HexByte, Number, SnakeName, Text, Whole
from fbgen.catalog.sourced import Sourced, Status
from fbgen.diagnostics import Diagnostic

DataType = Literal[
    "bool", "byte", "word", "sint", "usint", "int", "uint", "dint", "udint", "short_string",
    "byte_array", "usint_array", "uint_array", "struct",
]  # fmt: skip
NUMBERS: dict[DataType, tuple[int, int]] = {
    "bool": (0, 1),
    "byte": (0, 0xFF),
    "word": (0, 0xFFFF),
    "sint": (-0x80, 0x7F),
    "usint": (0, 0xFF),
    "int": (-0x8000, 0x7FFF),
    "uint": (0, 0xFFFF),
    "dint": (-0x80000000, 0x7FFFFFFF),
    "udint": (0, 0xFFFFFFFF),
}
"""What types of numbers can hold; they have their low byte first."""


class Attribute(Located):
    """An attribute of a class or of its instances. `source` and `status` default to the class's.

    A `settable` one can be written too. `minimum` and `maximum` narrow what its type can hold;
    `default` is what it begins with; `instances` are those that have it, none for all of them.
    """

    id: Count
    name: SnakeName
    title: Text
    type: DataType
    settable: Flag = False
    default: Whole | None = None
    minimum: Whole | None = None
    maximum: Whole | None = None
    values: dict[Number, Text] = Field(default_factory=dict)
    instances: tuple[Count, ...] = ()
    remark: Text | None = None
    source: Text | None = None
    status: Status | None = None

    @property
    def limits(self) -> tuple[int, int]:
        """The least and the greatest number that it takes; of arrays and texts those of bytes."""
        low, high = NUMBERS.get(self.type, (0, 0xFF))
        least = low if self.minimum is None else self.minimum
        return least, high if self.maximum is None else self.maximum

    def problems(self) -> Iterable[Diagnostic]:
        """FB1108 limits that the type cannot hold; FB1104 a value outside of them."""
        low, high = NUMBERS.get(self.type, (0, 0xFF))
        least, greatest = self.limits
        if not low <= least <= greatest <= high:
            message = f"{least} to {greatest} is no range of the type {self.type}"
            yield Diagnostic("FB1108", message, self.span, f"it holds {low} to {high}")
            return
        places = [(value, self.item_span_of("values", value)) for value in self.values]
        if self.default is not None:
            places.append((self.default, self.span_of("default")))
        for value, place in places:
            if not least <= value <= greatest:
                message = f"'{self.name}' cannot be {value}"
                yield Diagnostic("FB1104", message, place, f"it goes from {least} to {greatest}")


class Service(Located):
    """A service of a class: whether the class itself has it, and whether its instances do."""

    code: HexByte
    name: SnakeName
    title: Text
    on_class: Flag
    on_instance: Flag
    source: Text | None = None
    status: Status | None = None


class Instance(Located):
    """A named instance of a class."""

    number: Count
    name: SnakeName
    title: Text


class ObjectClass(Sourced):
    """A class of objects. Without `instances` there is one, or its numbers follow another rule."""

    code: HexByte
    name: SnakeName
    title: Text
    instances: tuple[Instance, ...] = ()
    class_attributes: tuple[Attribute, ...] = ()
    attributes: tuple[Attribute, ...]
    services: tuple[Service, ...]

    def attribute(self, name: str) -> Attribute:
        """The attribute of its instances of a name. Raises DiagnosticError FB1105."""
        message = f"the class '{self.name}' has no attribute '{name}'"
        return pick(self.attributes, name, "FB1105", message)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice."""
        yield from super().problems()
        for attributes in (self.class_attributes, self.attributes):
            yield from no_duplicates(attributes, "id", lambda item: str(item.id), "attribute")
            yield from no_duplicates(attributes, "name", lambda item: item.name, "attribute")
        yield from no_duplicates(self.services, "code", lambda item: f"{item.code:02X}", "service")
        numbers = self.instances
        yield from no_duplicates(numbers, "number", lambda item: str(item.number), "instance")
