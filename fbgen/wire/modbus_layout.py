"""What request and reply frames of MODBUS-RTU have in common: parts of them, and their limits."""

from struct import Struct

from fbgen.wire.modbus import MOST_READ, Function

READ, WRITE = int(Function.READ), int(Function.WRITE)
WRITE_SEVERAL, READ_WRITE = int(Function.WRITE_SEVERAL), int(Function.READ_WRITE)
IDENTIFY = int(Function.IDENTIFY)

IDENTIFICATION = 0x0E
"""The type behind 2BH: read device identification."""

IDENTIFY_CODES = range(1, 5)
LOWEST_ADDRESS = 1
CRC_BYTES = 2

TWO_WORDS = Struct(">BBHH")
WORDS = tuple(Struct(f">{count}H") for count in range(MOST_READ + 1))


def quantity(count: int, most: int) -> int:
    """The number of words. ValueError if no frame can carry so many."""
    if not 1 <= count <= most:
        raise ValueError(f"{count} words are not possible here, only 1 to {most}")
    return count


def identification(code: int) -> int:
    """The code of an identification. ValueError if there is no such one."""
    if code not in IDENTIFY_CODES:
        raise ValueError(f"there is no identification {code}, only 1 to 4")
    return code
