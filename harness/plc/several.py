"""Several values in the data of one station, as a program reaches them by one call.

Worked out once for each group of accesses that stands in a program.
"""

from collections.abc import Callable, Mapping
from operator import itemgetter
from struct import Struct

from fbgen.dataclass import dataclass
from harness.engine.environment import places_of
from harness.plc.io_module import IoModule

_FORMATS = {1: "B", 2: "H", 4: "I", 8: "Q"}


@dataclass(frozen=True, slots=True)
class Several:
    """Values that one station has, in the order of the accesses.

    `unpack` gives the values from `first` on in the order of their addresses; `in_order` brings
    them into the order of the accesses, None if that is the same. `pieces` has offset, count, and
    the time from before the first access to this one. `took_ns` is the time of all.
    """

    station: IoModule
    unpack: Callable[[bytearray, int], tuple[int, ...]]
    first: int
    in_order: Callable[[tuple[int, ...]], tuple[int, ...]] | None
    pieces: tuple[tuple[int, int, int], ...]
    took_ns: int


def several_at(
    places: str, stations: Mapping[int, tuple[IoModule, int]], access_ns: int
) -> Several | None:
    """The values at `places` (`264:2 261:2`), None unless one station has them, each once.

    `stations` leads from an address to the station and the offset there, `access_ns` is the time of
    one access.
    """
    pieces: list[tuple[int, int, int]] = []
    found: set[IoModule] = set()
    for number, (byte, count) in enumerate(places_of(places), 1):
        for at in range(byte, byte + count):
            if at not in stations:
                return None
            found.add(stations[at][0])
        pieces.append((stations[byte][1], count, number * access_ns))
    if len(found) != 1:
        return None
    by_offset = sorted(pieces)
    first = end = by_offset[0][0]
    layout = ">"
    for offset, count, _ in by_offset:
        if offset < end:
            return None
        layout += f"{offset - end}x{_FORMATS[count]}"
        end = offset + count
    in_order: Callable[[tuple[int, ...]], tuple[int, ...]] | None = None
    if pieces != by_offset:
        in_order = itemgetter(*(by_offset.index(piece) for piece in pieces))
    unpack = Struct(layout).unpack_from
    return Several(found.pop(), unpack, first, in_order, tuple(pieces), pieces[-1][2])
