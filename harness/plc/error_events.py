"""Error events of an S7-300/400: which organization block, and the 20 bytes it starts with.

Source: TIA Portal help, "Organization blocks (S7-300, S7-400)", OB82, OB85, OB86, OB121, OB122;
"Programming with STEP 7", A5E02789666-01, 27.2 "I/O Access Error during Update of the Process
Image". Not known to the model and left at zero or at these values: the addresses of the master
itself, of the standard slave's diagnosis and of the program's instruction; the master system is 1.
"""

from collections.abc import Iterator
from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.lang.types import DATE_AND_TIME
from fbgen.wire.profibus import Slot
from harness.engine.layout import S7
from harness.engine.organization import (
    ACCESS_ERROR,
    DIAGNOSIS,
    PRIORITY_CLASS_ERROR,
    PROGRAMMING_ERROR,
    RACK_FAILURE,
)

ASYNCHRONOUS_PRIORITY = 26
"""The priority class of OB82, OB85 and OB86 in RUN, unless it is set otherwise."""
_MASTER_SYSTEM = 1
_INCOMING, _OUTGOING = 0x39, 0x38
_STATION_FAILED = 0xC4
_EXTERNAL_FAULT = 0x05
_FAULTLESS = 0x00
_ACCESS_TYPES = {1: 0x10, 2: 0x20, 4: 0x30}

PROGRAMMING_FAULTS = {
    "FB6002": 0x22,
    "FB6010": 0x22,
    "FB6011": 0x3A,
    "FB6014": 0x21,
    "FB6017": 0x24,
    "FB6040": 0x24,
}
"""OB121_SW_FLT for the faults of a program that are programming errors on an S7-300/400.

Error codes for reading; the engines do not tell a write (23, 25) from a read.
"""


class ImageErrors(Enum):
    """Whether OB85 is called when the process image of a station that fails is updated.

    NONE: never, the default of an S7-300. EACH: at every access of every update, the default of an
    S7-400. CHANGES: once when it begins to fail and once when it is well again.
    """

    NONE = "no OB85"
    EACH = "OB85 at each access"
    CHANGES = "OB85 incoming and outgoing"


@dataclass(frozen=True, slots=True)
class ErrorEvent:
    """A call of an organization block for an error. `what` says why, for a person."""

    number: int
    head: bytes
    what: str

    def start(self, priority: int, calendar_ns: int) -> bytes:
        """The start information: event, fault, priority, number, what it concerns, when."""
        stamp = S7.encode(DATE_AND_TIME, calendar_ns)
        return self.head[:2] + bytes((priority, self.number)) + self.head[2:] + stamp


def station_event(name: str, address: int, *, failed: bool) -> ErrorEvent:
    """OB86: a DP station fails, or is back."""
    head = (_INCOMING if failed else _OUTGOING, _STATION_FAILED, 0, 0)
    where = bytes((0, 0, 0, 0, _MASTER_SYSTEM, address))
    what = f"station '{name}' {'has failed' if failed else 'is back'}"
    return ErrorEvent(RACK_FAILURE, bytes(head) + where, what)


def diagnosis_event(name: str, first: Slot, *, reported: bool) -> ErrorEvent:
    """OB82: a station reports a diagnosis, or reports that all is well again."""
    address = first.input_address
    flag = 0x54
    if address is None:
        address, flag = first.output_address or 0, 0x55
    faults = (_EXTERNAL_FAULT if reported else _FAULTLESS, 0, 0, 0)
    head = bytes((_INCOMING if reported else _OUTGOING, 0x42, 0, flag))
    what = f"station '{name}' reports {'a diagnosis' if reported else 'that all is well again'}"
    return ErrorEvent(DIAGNOSIS, head + address.to_bytes(2, "big") + bytes(faults), what)


def access_event(byte: int, count: int, *, reading: bool) -> ErrorEvent:
    """OB122: a direct access reaches nothing."""
    head = bytes((0x29, 0x42 if reading else 0x43, 0, _ACCESS_TYPES[count]))
    where = byte.to_bytes(2, "big") + bytes(4)
    what = f"{'input' if reading else 'output'} byte {byte} cannot be reached"
    return ErrorEvent(ACCESS_ERROR, head + where, what)


def programming_event(code: str) -> ErrorEvent:
    """OB121: a programming error, by the code of the finding."""
    head = bytes((0x25, PROGRAMMING_FAULTS[code])) + bytes(8)
    return ErrorEvent(PROGRAMMING_ERROR, head, "the program has a programming error")


def image_events(
    slot: Slot, *, reading: bool, errors: ImageErrors, bad: bool
) -> Iterator[ErrorEvent]:
    """OB85 for one module: a call for each access, which moves four bytes at most.

    `bad` is False for the end of an error. A module that is consistent as a whole is one access.
    """
    extent = slot.identifier.inputs if reading else slot.identifier.outputs
    first = slot.input_address if reading else slot.output_address
    if extent is None or first is None:
        return
    fault = (0xB1 if reading else 0xB2) + (2 if errors is ImageErrors.CHANGES else 0)
    head = bytes((_INCOMING if bad else _OUTGOING, fault))
    what = f"the process image of {'input' if reading else 'output'} byte "
    for offset, length in _accesses(extent.length, extent.consistent_bytes):
        kind = _ACCESS_TYPES.get(length, 0x57)
        of_range = length if kind == 0x57 else 0
        where = (
            first.to_bytes(2, "big") + bytes((0, of_range)) + (first + offset).to_bytes(2, "big")
        )
        body = head + bytes((kind, 0)) + where
        yield ErrorEvent(PRIORITY_CLASS_ERROR, body, f"{what}{first + offset} cannot be updated")


def _accesses(length: int, consistent: int) -> Iterator[tuple[int, int]]:
    if consistent >= length and length not in _ACCESS_TYPES:
        yield 0, length
        return
    offset = 0
    while offset < length:
        step = next(size for size in (4, 2, 1) if offset + size <= length)
        yield offset, step
        offset += step
