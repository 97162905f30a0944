"""The CAN identifiers of DeviceNet: message groups 1 to 4, and those of the predefined connections.

IEC 62026-3, as devicenet-py 0.0.1 and public descriptions have it. The MAC ID in an identifier is
that of the sender in groups 1 and 3; in group 2 it is that of the slave, whoever sends.
"""

from enum import IntEnum, unique

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import MAX_IDENTIFIER, MAX_MAC

_GROUP_2, _GROUP_3, _GROUP_4, _BEHIND = 0x400, 0x600, 0x7C0, 0x7F0
_MESSAGES = {1: 16, 2: 8, 3: 7, 4: 48}


@unique
class SlaveMessage(IntEnum):
    """Message IDs of group 1 with which a slave of the predefined set sends its I/O."""

    MULTICAST_POLL_RESPONSE = 12
    COS = 13
    BIT_STROBE_RESPONSE = 14
    POLL_RESPONSE = 15


@unique
class Group2(IntEnum):
    """Message IDs of group 2, all with the MAC ID of the slave."""

    BIT_STROBE = 0
    MULTICAST_POLL = 1
    COS_ACKNOWLEDGE = 2
    EXPLICIT_RESPONSE = 3
    EXPLICIT_REQUEST = 4
    POLL = 5
    UNCONNECTED_REQUEST = 6
    DUPLICATE_MAC_CHECK = 7


@dataclass(frozen=True, slots=True)
class Identifier:
    """A CAN identifier taken apart. Group 4 has no MAC ID. ValueError for one that cannot be."""

    group: int
    message: int
    mac: int | None

    def __post_init__(self) -> None:
        messages = _MESSAGES.get(self.group)
        if messages is None or not 0 <= self.message < messages:
            raise ValueError(f"there is no message {self.message} in group {self.group}")
        if self.group == 4:
            if self.mac is not None:
                raise ValueError("messages of group 4 have no MAC ID")
        elif self.mac is None or not 0 <= self.mac <= MAX_MAC:
            raise ValueError(f"{self.mac} is no MAC ID, they are 0 to 63")

    @property
    def number(self) -> int:
        """The identifier as CAN has it."""
        mac = self.mac or 0
        if self.group == 1:
            return self.message << 6 | mac
        if self.group == 2:
            return _GROUP_2 | mac << 3 | self.message
        if self.group == 3:
            return _GROUP_3 | self.message << 6 | mac
        return _GROUP_4 | self.message


def parse_identifier(number: int) -> Identifier | None:
    """What an identifier says; None for those that DeviceNet does not have (7F0 to 7FF)."""
    if not 0 <= number <= MAX_IDENTIFIER:
        raise ValueError(f"{number:X} is no identifier of 11 bits")
    if number >= _BEHIND:
        return None
    if number >= _GROUP_4:
        return Identifier(4, number - _GROUP_4, None)
    if number >= _GROUP_3:
        return Identifier(3, number >> 6 & 0x7, number & MAX_MAC)
    if number >= _GROUP_2:
        return Identifier(2, number & 0x7, number >> 3 & MAX_MAC)
    return Identifier(1, number >> 6, number & MAX_MAC)


def slave_message(message: SlaveMessage, mac: int) -> int:
    """The identifier of a message of group 1."""
    return Identifier(1, message, mac).number


def group_2(message: Group2, mac: int) -> int:
    """The identifier of a message of group 2, of or to the slave with this MAC ID."""
    return Identifier(2, message, mac).number
