"""The data of one controller that lies in bytes: its classes, arrays and single values."""

from collections.abc import Callable, Mapping, MutableMapping
from typing import Any

from fbgen.lang.checked import StandardBlock
from fbgen.lang.types import (
    ArrayType,
    BlockType,
    ReferenceType,
    StructType,
    Type,
)
from harness.engine.area_memories import AreaMemories
from harness.engine.compiled.data.model import bytes_name, is_scalar
from harness.engine.compiled.data.placed_pointers import Pointers
from harness.engine.compiled.data.shapes import Shapes
from harness.engine.compiled.library.placed import (
    ByteArray,
    ByteCell,
    ByteStructure,
    Codec,
    byte_attribute,
    fill,
)
from harness.engine.environment import Environment


class Bytes:
    """Makes what lies in bytes. `names` are the module-level names of the generated code."""

    __slots__ = ("_classes", "_model", "_names", "_pointers", "layout", "shapes")

    def __init__(self, shapes: Shapes, names: Mapping[str, Any], environment: Environment) -> None:
        self.shapes = shapes
        self.layout = shapes.layout
        self._model = shapes.model
        numbers = self._model.program.data_blocks
        self._pointers = Pointers(AreaMemories(environment, numbers, self.block), self.view)
        self._names = names
        self._classes: dict[StructType, type[ByteStructure]] = {}

    # --- making ---------------------------------------------------------------------------------

    def codec(self, kind: Type) -> Codec:
        """How a single value is read and written."""
        if isinstance(kind, ReferenceType):
            return self._pointers.codec(kind)
        return self.shapes.codec(kind)

    def view(self, kind: Type, memory: bytearray, bit: int) -> Any:
        """What lies in a memory, as data of a type; a single value as a cell."""
        return self.maker(kind)(memory, bit)

    def maker(self, kind: Type) -> Callable[[bytearray, int], Any]:
        """A function that makes views of a type."""
        if isinstance(kind, StructType):
            return self.class_of(kind)
        if isinstance(kind, BlockType):
            return self._instance_maker(kind)
        if not isinstance(kind, ArrayType):
            way = self.codec(kind)
            return lambda memory, bit: ByteCell(memory, bit, way)
        offsets = self.layout.element_bits(kind)
        if is_scalar(kind.element):
            way = self.codec(kind.element)
            size = self._used_bytes(kind)
            return lambda memory, bit: ByteArray(memory, bit, offsets, way, size)
        inner = self.maker(kind.element)
        return lambda memory, bit: [inner(memory, bit + offset) for offset in offsets]

    def _used_bytes(self, kind: Type) -> int:
        return (self.layout.used_bits(kind) + 7) // 8

    def _instance_maker(self, kind: BlockType) -> Callable[[bytearray, int], Any]:
        """Timers and the like have their memory elsewhere."""
        name = self._model.record_of(kind).class_name
        is_standard = isinstance(self._model.program.block_of(kind.name), StandardBlock)

        def make(memory: bytearray, bit: int) -> Any:
            # Its class may come into being later than this function.
            made = self._names[name]
            return made() if is_standard else made(memory, bit)

        return make

    def class_of(self, kind: StructType) -> type[ByteStructure]:
        """The class of a structure that lies in bytes."""
        if kind not in self._classes:
            self._classes[kind] = self._class(kind)
        return self._classes[kind]

    def _class(self, kind: StructType) -> type[ByteStructure]:
        record = self._model.record_of(kind)
        bits = self.layout.field_bits(kind)
        # What only rounds the length up may belong to somebody else.
        size = self.layout.size_bytes(kind) if kind.is_union else self._used_bytes(kind)
        content: MutableMapping[str, Any] = {"_size": size}
        makers = []
        for part in record.parts:
            bit = bits[part.name.casefold()]
            if is_scalar(part.type):
                content[part.slot] = byte_attribute(self.codec(part.type), bit)
            else:
                makers.append((part.slot, bit, self.maker(part.type)))
        content["__slots__"] = tuple(slot for slot, _, _ in makers)
        content["_parts"] = tuple(makers)
        content["_slots"] = tuple((part.slot, part.type) for part in record.parts)
        content["_first_bytes"] = self.layout.encode(kind, self.shapes.value(kind, None))
        content["_is_union"] = kind.is_union
        content["_names"] = self._names
        content["_plain"] = record.class_name
        made: type[ByteStructure] = type(record.class_name, (ByteStructure,), dict(content))
        return made

    # --- globals --------------------------------------------------------------------------------

    def blocks(self) -> dict[str, ByteStructure]:
        """Data blocks that lie in bytes, by the names that `bytes_name` gives them."""
        made = {}
        for part in self._model.global_record.parts:
            if part.bit is not None and isinstance(part.type, StructType):
                first = self.layout.encode(part.type, self.shapes.value(part.type, part.initial))
                made[bytes_name(part)] = self.class_of(part.type)(bytearray(first), 0)
        return made

    def unions(self) -> dict[str, type[ByteStructure]]:
        """The classes of the unions, by their names."""
        unions = self._model.unions
        return {record.class_name: self.class_of(kind) for record, kind in unions.items()}

    def block(self, number: int) -> bytearray | None:
        """The bytes of a data block; None if there is none with that number in bytes."""
        variable = self._model.program.data_blocks.get(number)
        if variable is None or variable not in self._model.program.byte_memory:
            return None
        memory: bytearray = self._names[self._model.global_name(variable)]._memory
        return memory


def placed_parameter(made: Any, value: Any) -> Any:
    """The place of a parameter that lies in bytes, with its value."""
    if isinstance(made, ByteCell):
        made.value = value
    elif isinstance(made, ByteStructure):
        made._assign(value)
    else:
        fill(made, value)
    return made


FUNCTIONS = {"_placed_parameter": placed_parameter, "_attribute": byte_attribute}
"""What generated code calls."""
