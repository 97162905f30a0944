"""Instructions that move whole areas of memory: what generated code calls for them."""

from typing import Any

from fbgen.lang.checked import SystemCall
from harness.engine.compiled.data.areas import VariableArea
from harness.engine.compiled.data.cells import ElementCell
from harness.engine.compiled.data.placement import Bytes
from harness.engine.environment import Environment
from harness.engine.faults import (
    address_out_of_range,
    no_data_block,
    too_many_elements,
    unknown_area,
)

_BLOCK = 0x84


def move_area(node: SystemCall, source: VariableArea, target: VariableArea) -> int:
    """BLKMOV and UBLKMOV: as much as both hold; FILL: over and over, until the target is full."""
    room = target.length
    data = source.read()
    if node.name == "FILL":
        while data and len(data) < room:
            data += data
    target.write(data[:room])
    return 0


def _left(node: SystemCall, cell: ElementCell, count: int) -> None:
    room = len(cell.elements) - cell.position
    if count < 0 or count > room:
        raise too_many_elements(node.span, node.name, count, room)


def move_elements(node: SystemCall, source: Any, count: int, target: ElementCell) -> int:
    """MOVE_BLK has an element as source, FILL_BLK a value."""
    is_move = node.name.endswith("MOVE_BLK")
    if is_move:
        _left(node, source, count)
    _left(node, target, count)
    if is_move:
        first = source.position
        contents = [source.elements[first + number] for number in range(count)]
        contents = [_copied(content) for content in contents]
    else:
        contents = [source] * count
    elements: Any = target.elements
    for position, content in enumerate(contents, target.position):
        if hasattr(content, "_assign"):
            elements[position]._assign(content)
        elif isinstance(content, list):
            elements[position][:] = content
        else:
            elements[position] = content
    return 0


def _copied(content: Any) -> Any:
    return content._copy() if hasattr(content, "_copy") else content


class BlockPokes:
    """POKE_BLK on the memory of one controller."""

    __slots__ = ("_data", "_environment")

    def __init__(self, data: Bytes, environment: Environment) -> None:
        self._data = data
        self._environment = environment

    def run(self, node: SystemCall, *numbers: int) -> int:
        """Copies bytes from one area to another one."""
        code, block, first, to_code, to_block, to_first, count = numbers
        size = max(count, 0)
        data = bytes(self._area(node, code, block, first, size)[first : first + size])
        target = self._area(node, to_code, to_block, to_first, size)
        target[to_first : to_first + size] = data
        return 0

    def _area(self, node: SystemCall, code: int, block: int, byte: int, size: int) -> bytearray:
        environment = self._environment
        memory: bytearray | None
        if code == _BLOCK:
            memory, name = self._data.block(block), f"%DB{block}.DBB{byte}"
            if memory is None:
                raise no_data_block(node.span, block)
        elif code == 0x81:
            memory, name = environment.inputs, f"%IB{byte}"
        elif code == 0x82:
            memory, name = environment.outputs, f"%QB{byte}"
        elif code == 0x83:
            memory, name = environment.markers, f"%MB{byte}"
        else:
            raise unknown_area(node.span, code)
        if byte < 0 or byte + size > len(memory):
            raise address_out_of_range(node.span, name, len(memory))
        return memory
