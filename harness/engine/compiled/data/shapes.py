"""Which data of a program lies in bytes, where, and with which first values.

This depends on the program alone; `placement` makes the data of one controller of it.
"""

from collections.abc import Mapping
from typing import Any

from fbgen.lang.checked import Block, VariableKind
from fbgen.lang.types import (
    ArrayInitial,
    ArrayType,
    BlockType,
    Initial,
    StructInitial,
    StructType,
    Type,
)
from harness.engine.block_memory import Placement
from harness.engine.compiled.data.initials import default_scalar
from harness.engine.compiled.data.model import Model, has_memory
from harness.engine.compiled.library.placed import Codec, codec
from harness.engine.interface import Value

_FRAME = (VariableKind.TEMP, VariableKind.RESULT)
_PARAMETERS = (VariableKind.INPUT, VariableKind.OUTPUT)


def frame_kinds(block: Block) -> tuple[VariableKind, ...]:
    """The kinds of variables that are the locals of one call."""
    return _FRAME if has_memory(block) else (*_FRAME, *_PARAMETERS)


class Shapes:
    """The layout of all that lies in bytes.

    `image_sizes` has the bytes of the areas I, Q and M of the controllers that it is for. With
    `leaves` these leave in temporary variables what stands there, see `harness.engine.leftovers`.
    """

    __slots__ = ("_codecs", "image_sizes", "layout", "leaves", "model")

    def __init__(self, model: Model, image_sizes: Mapping[str, int], *, leaves: bool) -> None:
        self.model = model
        self.layout = model.layout
        self.image_sizes = image_sizes
        self.leaves = leaves
        self._codecs: dict[Type, Codec] = {}

    def frame(self, block: Block) -> Placement:
        """The locals of a call that lie in bytes."""
        return self.layout.frame(block, frame_kinds(block))

    def codec(self, kind: Type) -> Codec:
        """How a single value that is no pointer is read and written."""
        if kind not in self._codecs:
            self._codecs[kind] = codec(kind, self.layout)
        return self._codecs[kind]

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
        return default_scalar(kind, self.model.program.dialect)

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

    def block_size(self, number: int) -> int | None:
        """How many bytes a data block has; None if there is none with that number in bytes."""
        variable = self.model.program.data_blocks.get(number)
        if variable is None or variable not in self.model.program.byte_memory:
            return None
        return self.layout.size_bytes(variable.type)


def _is_instance(kind: Type) -> bool:
    while isinstance(kind, ArrayType):
        kind = kind.element
    return isinstance(kind, BlockType)
