"""PROFIBUS data link telegrams (FDL, EN 50170 volume 2, part 4; DIN 19245 part 1).

    SD1  10 DA SA FC FCS 16                          no data
    SD2  68 LE LE 68 DA SA FC data(1..246) FCS 16    LE = 4..249 counts DA to the end of the data
    SD3  A2 DA SA FC data(8) FCS 16                  eight bytes of data
    SD4  DC DA SA                                    token
    SC   E5                                          short acknowledgement

FCS is the low byte of the sum from DA to the last data byte. Bit 7 of an address says that the data
begin with a service access point: the destination's first, then the source's. FC of a request: bit
6 = 1, bit 5 frame count bit, bit 4 frame count bit valid, bits 3-0 function; of a reply: bit 6 = 0,
bits 5-4 kind of station (00 slave), bits 3-0 function. Segment addresses (bits 7 and 6 of an
extension byte) are for couplers between networks and are refused.
"""

from enum import IntEnum
from typing import TypeAlias

from fbgen.dataclass import dataclass

SD1, SD2, SD3, SD4, SC = 0x10, 0x68, 0xA2, 0xDC, 0xE5
END = 0x16
BROADCAST = 127
"""Destination of telegrams that all stations take and none answers."""
HIGHEST_STATION = 126
LONGEST_UNIT = 246
"""Most data bytes of a telegram, service access points included."""
FIXED_UNIT = 8
_ADDRESS, _EXTENDED = 0x7F, 0x80
_NO_SAP_BITS = 0xC0
_REQUEST, _BIT, _VALID = 0x40, 0x20, 0x10
_FUNCTION, _STATION = 0x0F, 0x30
_HEAD = 3
_SHORTEST_LE, _LONGEST_LE = _HEAD + 1, _HEAD + LONGEST_UNIT
_LE_FRAME = 6
"""Bytes of an SD2 telegram that LE does not count."""
_LENGTHS = {SD1: 6, SD3: 14, SD4: 3, SC: 1}


class TelegramError(ValueError):
    """Bytes that are no telegram, or a telegram that cannot be."""


class RequestFunction(IntEnum):
    """Functions of a request. SDA, SDN, SRD: send data with acknowledge, with none, and request."""

    TIME_EVENT = 0x0
    SDA_LOW = 0x3
    SDN_LOW = 0x4
    SDA_HIGH = 0x5
    SDN_HIGH = 0x6
    DIAGNOSIS = 0x7
    FDL_STATUS = 0x9
    SRD_LOW = 0xC
    SRD_HIGH = 0xD
    IDENT = 0xE
    LSAP_STATUS = 0xF


class ReplyFunction(IntEnum):
    """Functions of a reply."""

    OK = 0x0
    USER_ERROR = 0x1
    NO_RESOURCE = 0x2
    NO_SERVICE = 0x3
    DATA_LOW = 0x8
    NO_DATA = 0x9
    DATA_HIGH = 0xA
    DATA_LOW_NO_RESOURCE = 0xC
    DATA_HIGH_NO_RESOURCE = 0xD


@dataclass(frozen=True, slots=True)
class ShortAcknowledgement:
    """SC: all is well, and there is nothing to say."""


@dataclass(frozen=True, slots=True)
class Token:
    """SD4: the right to send, handed from master to master."""

    destination: int
    source: int

    def __post_init__(self) -> None:
        _check_addresses(self.destination, self.source)


@dataclass(frozen=True, slots=True)
class DataTelegram:
    """SD1, SD2 or SD3: without data, or with. `control` is the FC byte.

    `fixed` is a telegram with exactly eight bytes of data that is sent as SD3; a receiver makes no
    difference. Raises TelegramError for what no telegram can say.
    """

    destination: int
    source: int
    control: int
    data: bytes = b""
    destination_sap: int | None = None
    source_sap: int | None = None
    fixed: bool = False

    def __post_init__(self) -> None:
        _check_addresses(self.destination, self.source)
        if not 0 <= self.control <= 0x7F:
            raise TelegramError(f"the function code {self.control:02X} has the reserved bit 7")
        for sap in (self.destination_sap, self.source_sap):
            if sap is not None and not 0 <= sap <= 0x3F:
                raise TelegramError(f"service access point {sap}: they count from 0 to 63")
        length = len(self.unit)
        if length > LONGEST_UNIT:
            raise TelegramError(f"{length} bytes of data: {LONGEST_UNIT} is the most")
        if self.fixed and length != FIXED_UNIT:
            raise TelegramError(f"{length} bytes of data: SD3 carries {FIXED_UNIT}")

    @property
    def unit(self) -> bytes:
        """The data as they are sent, with the service access points in front."""
        saps = [sap for sap in (self.destination_sap, self.source_sap) if sap is not None]
        return bytes(saps) + self.data

    @property
    def is_request(self) -> bool:
        """True for what an active station asks, False for a reply."""
        return bool(self.control & _REQUEST)

    @property
    def function(self) -> int:
        """A RequestFunction or a ReplyFunction, or a reserved number."""
        return self.control & _FUNCTION

    @property
    def frame_count_bit(self) -> bool:
        """Toggled by the sender for every new request to one station."""
        return bool(self.control & _BIT)

    @property
    def frame_count_valid(self) -> bool:
        """Whether the frame count bit tells a new request from a repeated one."""
        return bool(self.control & _VALID)

    @property
    def station_type(self) -> int:
        """In a reply: 0 slave, 1 master not ready, 2 master ready, 3 master in the ring."""
        return (self.control & _STATION) >> 4


Telegram: TypeAlias = DataTelegram | Token | ShortAcknowledgement


def request_control(function: RequestFunction, frame_count: bool | None = None) -> int:
    """FC of a request; `frame_count` is the frame count bit if it is valid, None if not."""
    if frame_count is None:
        return _REQUEST | function
    return _REQUEST | _VALID | (_BIT if frame_count else 0) | function


def first_request_control(function: RequestFunction) -> int:
    """FC of the request with which a master begins to count: bit 1, but not yet valid."""
    return _REQUEST | _BIT | function


def encode(telegram: Telegram) -> bytes:
    """The bytes of a telegram."""
    if isinstance(telegram, ShortAcknowledgement):
        return bytes((SC,))
    if isinstance(telegram, Token):
        return bytes((SD4, telegram.destination, telegram.source))
    destination = telegram.destination | (0 if telegram.destination_sap is None else _EXTENDED)
    source = telegram.source | (0 if telegram.source_sap is None else _EXTENDED)
    unit = telegram.unit
    body = bytes((destination, source, telegram.control)) + unit
    if not unit:
        start = bytes((SD1,))
    elif telegram.fixed:
        start = bytes((SD3,))
    else:
        start = bytes((SD2, len(body), len(body), SD2))
    return start + body + bytes((sum(body) & 0xFF, END))


def measure(data: bytes | bytearray) -> int | None:
    """Length of the telegram that begins here; None if more bytes are needed to say.

    Raises TelegramError if no telegram begins like this.
    """
    if not data:
        return None
    if data[0] != SD2:
        length = _LENGTHS.get(data[0])
        if length is None:
            raise TelegramError(f"no telegram begins with {data[0]:02X}")
        return length
    if len(data) > 1 and not _SHORTEST_LE <= data[1] <= _LONGEST_LE:
        raise TelegramError(f"length {data[1]}: it is {_SHORTEST_LE} to {_LONGEST_LE}")
    if len(data) > 2 and data[1] != data[2]:
        raise TelegramError(f"the length is given as {data[1]} and as {data[2]}")
    if len(data) > 3 and data[3] != SD2:
        raise TelegramError(f"{data[3]:02X} in place of the second start delimiter")
    return data[1] + _LE_FRAME if len(data) > 3 else None


def decode(data: bytes | bytearray) -> Telegram:
    """The telegram that these bytes are, all of them.

    Raises TelegramError if they are none.
    """
    length = measure(data)
    if length is None or length != len(data):
        raise TelegramError(f"{len(data)} bytes are not one whole telegram")
    start = data[0]
    if start == SC:
        return ShortAcknowledgement()
    if start == SD4:
        return Token(data[1], data[2])
    body = bytes(data[4:-2] if start == SD2 else data[1:-2])
    if data[-1] != END:
        raise TelegramError(f"{data[-1]:02X} in place of the end delimiter")
    if sum(body) & 0xFF != data[-2]:
        raise TelegramError(f"check sum {data[-2]:02X} in place of {sum(body) & 0xFF:02X}")
    destination_sap, rest = _sap(body[0], body[_HEAD:])
    source_sap, rest = _sap(body[1], rest)
    return DataTelegram(
        body[0] & _ADDRESS,
        body[1] & _ADDRESS,
        body[2],
        rest,
        destination_sap,
        source_sap,
        start == SD3,
    )


def _sap(address: int, unit: bytes) -> tuple[int | None, bytes]:
    if not address & _EXTENDED:
        return None, unit
    if not unit:
        raise TelegramError("an address announces a service access point that is not there")
    if unit[0] & _NO_SAP_BITS:
        raise TelegramError(f"the address extension {unit[0]:02X} is no service access point")
    return unit[0], unit[1:]


def _check_addresses(destination: int, source: int) -> None:
    if not 0 <= destination <= BROADCAST:
        raise TelegramError(f"address {destination}: stations count from 0 to {BROADCAST}")
    if not 0 <= source <= HIGHEST_STATION:
        raise TelegramError(f"sender {source}: stations count from 0 to {HIGHEST_STATION}")
