"""Which data of a program lies in bytes, and how it is made: classes, arrays, first values."""

from collections.abc import Callable, Mapping, MutableMapping
from typing import Any

from fbgen.lang.checked import Block, StandardBlock, VariableKind
from fbgen.lang.types import (
    ArrayInitial,
    ArrayType,
    BlockType,
    Initial,
    ReferenceType,
    StructInitial,
    StructType,
    Type,
)
from harness.engine.area_memories import AreaMemories
from harness.engine.block_memory import Placement
from harness.engine.compiled.initials import default_scalar
from harness.engine.compiled.library.placed import (
    ByteArray,
    ByteCell,
    ByteStructure,
    Codec,
    byte_attribute,
    codec,
    fill,
)
from harness.engine.compiled.model import Model, Part, has_memory, is_scalar
from harness.engine.compiled.placed_pointers import Pointers
from harness.engine.environment import Environment
from harness.engine.interface import Value

_FRAME = (VariableKind.TEMP, VariableKind.RESULT)
_PARAMETERS = (VariableKind.INPUT, VariableKind.OUTPUT)


def frame_kinds(block: Block) -> tuple[VariableKind, ...]:
    """The kinds of variables that are the locals of one call."""
    return _FRAME if has_memory(block) else (*_FRAME, *_PARAMETERS)


class Bytes:
    """Makes what lies in bytes. `names` are the module-level names of the generated code.

    `image_sizes` has the bytes of the areas I, Q and M of the controller.
    """

    __slots__ = ("_classes", "_codecs", "_model", "_names", "_pointers", "image_sizes", "layout")

    def __init__(self, model: Model, names: Mapping[str, Any], environment: Environment) -> None:
        self.layout = model.layout
        self.image_sizes = {
            "I": len(environment.inputs),
            "Q": len(environment.outputs),
            "M": len(environment.markers),
        }
        numbers = model.program.data_blocks
        self._pointers = Pointers(AreaMemories(environment, numbers, self.block), self.view)
        self._model = model
        self._names = names
        self._classes: dict[StructType, type[ByteStructure]] = {}
        self._codecs: dict[Type, Codec] = {}

    # --- what is where --------------------------------------------------------------------------

    def frame(self, block: Block) -> Placement:
        """The locals of a call that lie in bytes."""
        return self.layout.frame(block, frame_kinds(block))

    def first_bytes(self, placement: Placement) -> bytes:
        """The memory of an instance or of a call before anything is written."""
        memory = bytearray(placement.size)
        for variable, bit in placement.bits.items():
            # Instances set their own bytes, in-outs have none.
            if (
                variable.overlay is None
                and variable.kind is not VariableKind.IN_OUT
                and not _is_instance(variable.type)
            ):
                value = self.value(variable.type, variable.initial)
                self.layout.write(memory, bit, variable.type, value)
        return bytes(memory)

    def value(self, kind: Type, initial: Initial | None) -> Value:
        """The first value of a variable."""
        value: Value = self._with(self._default(kind), kind, initial)
        return value

    def _default(self, kind: Type) -> Any:
        if isinstance(kind, ArrayType):
            return [self._default(kind.element) for _ in range(kind.count)]
        if isinstance(kind, StructType):
            return {
                field.name: self.value(field.type, field.initial)
                for field in kind.fields
                if not _is_instance(field.type) and (not kind.is_union or field.initial is not None)
            }
        return default_scalar(kind, self._model.program.dialect)

    def _with(self, value: Any, kind: Type, initial: Initial | None) -> Any:
        """A value with those initial values that are given."""
        if initial is None:
            return value
        if isinstance(initial, ArrayInitial):
            assert isinstance(kind, ArrayType)
            return [
                self._with(element, kind.element, item)
                for element, item in zip(value, initial.items, strict=True)
            ]
        if isinstance(initial, StructInitial):
            assert isinstance(kind, StructType)
            changed = dict(value)
            for name, given in initial.fields:
                field = kind.field(name)
                assert field is not None
                before = changed.get(field.name)
                start = self._default(field.type) if before is None else before
                changed[field.name] = self._with(start, field.type, given)
            return changed
        return initial

    # --- making ---------------------------------------------------------------------------------

    def codec(self, kind: Type) -> Codec:
        """How a single value is read and written."""
        if kind not in self._codecs:
            self._codecs[kind] = (
                self._pointers.codec(kind)
                if isinstance(kind, ReferenceType)
                else codec(kind, self.layout)
            )
        return self._codecs[kind]

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
        content["_first_bytes"] = self.layout.encode(kind, self.value(kind, None))
        content["_is_union"] = kind.is_union
        content["_names"] = self._names
        content["_plain"] = record.class_name
        made: type[ByteStructure] = type(record.class_name, (ByteStructure,), dict(content))
        return made

    # --- globals --------------------------------------------------------------------------------

    def block_name(self, part: Part) -> str:
        """The name that the data of a data block has until it is bound to its own."""
        assert isinstance(part.type, StructType)
        self.class_of(part.type)
        return f"_bytes_of_{part.slot}"

    def blocks(self) -> dict[str, ByteStructure]:
        """Data blocks that lie in bytes, by the names of `block_name`."""
        made = {}
        for part in self._model.global_record.parts:
            if part.bit is not None and isinstance(part.type, StructType):
                first = self.layout.encode(part.type, self.value(part.type, part.initial))
                made[self.block_name(part)] = self.class_of(part.type)(bytearray(first), 0)
        return made

    def unions(self) -> dict[str, type[ByteStructure]]:
        """The classes of the unions, by their names."""
        unions = self._model.unions
        return {record.class_name: self.class_of(kind) for record, kind in unions.items()}

    def block_size(self, number: int) -> int | None:
        """How many bytes a data block has; None if there is none with that number in bytes."""
        variable = self._model.program.data_blocks.get(number)
        if variable is None or variable not in self._model.program.byte_memory:
            return None
        return self.layout.size_bytes(variable.type)

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


def _is_instance(kind: Type) -> bool:
    while isinstance(kind, ArrayType):
        kind = kind.element
    return isinstance(kind, BlockType)
