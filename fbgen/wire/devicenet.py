"""Numbers of DeviceNet: services, general status codes, allocation choices, data of CAN frames.

DeviceNet puts CIP on CAN with identifiers of 11 bits and up to 8 bytes (IEC 62026-3). Which service
and status has which number: ODVA's CIP, as public implementations have it; what the DEV003Z offers
of it stands in its catalogue.
"""

from enum import IntEnum, IntFlag

from fbgen.dataclass import dataclass

MAX_MAC = 63
"""The greatest MAC ID of a node."""
MAX_IDENTIFIER = 0x7FF
FRAME_BYTES = 8
"""Data that a CAN frame can carry."""
_AROUND_BITS = 47
"""Around the data of a frame with an identifier of 11 bits, the pause behind it included."""


@dataclass(frozen=True, slots=True)
class Frame:
    """A CAN data frame with an identifier of 11 bits. ValueError for one that CAN does not have."""

    identifier: int
    data: bytes

    def __post_init__(self) -> None:
        if not 0 <= self.identifier <= MAX_IDENTIFIER:
            raise ValueError(f"{self.identifier:X} is no identifier of 11 bits")
        if len(self.data) > FRAME_BYTES:
            raise ValueError(f"a CAN frame carries 8 bytes at most, not {len(self.data)}")

    def __str__(self) -> str:
        return f"{self.identifier:03X} {self.data.hex(' ').upper()}".rstrip()

    @property
    def bits(self) -> int:
        """Its length on the cable, with the pause behind it and without stuff bits."""
        return _AROUND_BITS + 8 * len(self.data)


class Service(IntEnum):
    """Services of objects. A response has bit 7 set beside its service."""

    RESET = 0x05
    GET_ATTRIBUTE_SINGLE = 0x0E
    SET_ATTRIBUTE_SINGLE = 0x10
    ERROR_RESPONSE = 0x14
    ALLOCATE = 0x4B
    RELEASE = 0x4C


class Status(IntEnum):
    """General status codes of error responses."""

    SUCCESS = 0x00
    RESOURCE_UNAVAILABLE = 0x02
    SERVICE_NOT_SUPPORTED = 0x08
    INVALID_ATTRIBUTE_VALUE = 0x09
    ALREADY_IN_REQUESTED_STATE = 0x0B
    OBJECT_STATE_CONFLICT = 0x0C
    ATTRIBUTE_NOT_SETTABLE = 0x0E
    PRIVILEGE_VIOLATION = 0x0F
    DEVICE_STATE_CONFLICT = 0x10
    NOT_ENOUGH_DATA = 0x13
    ATTRIBUTE_NOT_SUPPORTED = 0x14
    TOO_MUCH_DATA = 0x15
    OBJECT_DOES_NOT_EXIST = 0x16
    VENDOR_SPECIFIC = 0x1F
    INVALID_PARAMETER = 0x20


NO_ADDITIONAL_CODE = 0xFF
"""In an error response: there is no more to say."""


class AllocationError(IntEnum):
    """Additional codes of the DeviceNet object when it refuses to allocate or to release."""

    ALLOCATED_TO_ANOTHER = 0x01
    INVALID_CHOICE = 0x02
    NEITHER_ALLOCATE_NOR_RELEASE = 0x03
    """What came to the unconnected port of a "group 2 only" server."""


class Choice(IntFlag):
    """Bits of the allocation choice, and of the release choice."""

    EXPLICIT = 0x01
    POLLED = 0x02
    BIT_STROBED = 0x04
    MULTICAST_POLLED = 0x08
    CHANGE_OF_STATE = 0x10
    CYCLIC = 0x20
    ACK_SUPPRESSION = 0x40


class BodyFormat(IntEnum):
    """Bits of class and of instance in explicit requests."""

    C8_I8 = 0
    C8_I16 = 1
    C16_I16 = 2
    C16_I8 = 3

    @property
    def class_bytes(self) -> int:
        """Bytes of the class."""
        return 2 if self in (BodyFormat.C16_I16, BodyFormat.C16_I8) else 1

    @property
    def instance_bytes(self) -> int:
        """Bytes of the instance."""
        return 2 if self in (BodyFormat.C8_I16, BodyFormat.C16_I16) else 1
