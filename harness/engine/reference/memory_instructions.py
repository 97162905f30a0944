"""Instructions that move whole areas of memory, areas read before anything is written.

Sources: TIA Portal help, "MOVE_BLK", "FILL_BLK", "POKE_BLK", "BLKMOV", "FILL". A CPU leaves open
what overlapping areas give; here they come out as if they did not overlap.
"""

from collections.abc import Sequence

from fbgen.lang.checked import Expression, IndexRef, Place, SystemCall
from fbgen.lang.types import Scalar
from harness.engine.faults import too_many_elements
from harness.engine.interface import Value
from harness.engine.reference.areas import StorageArea
from harness.engine.reference.frames import Frame
from harness.engine.reference.places import Places
from harness.engine.reference.storage import Storage


def move_areas(call: SystemCall, places: Places, frame: Frame) -> Scalar:
    """BLKMOV, UBLKMOV and FILL: as much as both areas hold, or the target full of the source."""
    (_, source_place), (_, target_place) = call.arguments
    assert isinstance(source_place, Place)
    assert isinstance(target_place, Place)
    source = StorageArea(places.find(source_place, frame), source_place.span)
    target = StorageArea(places.find(target_place, frame), target_place.span)
    data, room = source.read(), target.length
    if call.name == "FILL" and data:
        data *= room // len(data) + 1
    target.write(data[:room])
    return 0


def move_elements(
    call: SystemCall, values: Sequence[Value], target: Sequence[Storage], count: int
) -> None:
    """MOVE_BLK: `values` are those from the first element on; FILL_BLK: it is one value."""
    fills = "FILL" in call.name
    for room in (len(target),) if fills else (len(values), len(target)):
        if not 0 <= count <= room:
            raise too_many_elements(call.span, call.name, count, room)
    for number in range(count):
        target[number].write(values[0 if fills else number])


def elements(expression: Expression, places: Places, frame: Frame) -> list[Storage]:
    """The elements of an array from a given one on."""
    assert isinstance(expression, IndexRef)
    return places.elements_from(expression, frame)


def poke_block(call: SystemCall, numbers: Sequence[int], places: Places) -> None:
    """POKE_BLK."""
    code, block, first, to_code, to_block, to_first, count = numbers
    find = places.addresses.area
    size = max(count, 0)
    data = bytes(find(call.span, code, block, first, size)[first : first + size])
    find(call.span, to_code, to_block, to_first, size)[to_first : to_first + size] = data
