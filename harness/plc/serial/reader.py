"""Messages out of characters, by start and end conditions.

STATUS of a message: TIA Portal Information System, "Error messages" of Freeport communication, 0094
to 0099 and 81E0 to 81EB. Inferred: behind a character with a parity or framing error a message goes
on to its end and is then handed over as that error, without its bytes.
"""

from fbgen.dataclass import dataclass
from harness.line.serial_format import PARITY_ERROR
from harness.plc.serial.conditions import LONGEST_MESSAGE, ReceiveConditions, Sequence

NS_PER_MS = 1_000_000
BY_LENGTH, BY_TIME, BY_GAP, NO_RESPONSE, BY_FIELD, BY_SEQUENCE = range(0x94, 0x9A)
PARITY, FRAMING, FIELD_TOO_LONG = 0x81E1, 0x81E2, 0x81E4


@dataclass(frozen=True, slots=True)
class Message:
    """What the module has received. With the highest bit of `status`, or with 0097, an error."""

    data: bytes
    status: int

    @property
    def failed(self) -> bool:
        """True for an error."""
        return bool(self.status & 0x8000) or self.status == NO_RESPONSE


class MessageReader:
    """Takes characters with their times. `deadline_ns` is when a message ends by time alone."""

    __slots__ = ("_bit_ns", "_conditions", "_data", "_error", "_first_ns", "_last_ns", "_started")

    def __init__(self, conditions: ReceiveConditions, bit_ns: int) -> None:
        self._conditions = conditions
        self._bit_ns = bit_ns
        self._data = bytearray()
        self._error = 0
        self._first_ns = 0
        self._last_ns = -(1 << 62)
        self._started = False

    @property
    def deadline_ns(self) -> int | None:
        """The instant at which the message in progress ends without a further character."""
        if not self._started:
            return None
        conditions, times = self._conditions, []
        if conditions.gap_bits is not None:
            times.append(self._last_ns + conditions.gap_bits * self._bit_ns)
        if conditions.message_ms is not None:
            times.append(self._first_ns + conditions.message_ms * NS_PER_MS)
        return min(times) if times else None

    def feed(self, byte: int, mark: int, end_ns: int) -> list[Message]:
        """The messages that end with this character, or before it."""
        done = self.expire(end_ns - 1)
        conditions, last_ns = self._conditions, self._last_ns
        idle_ns = end_ns - last_ns
        self._last_ns = end_ns
        if not self._started:
            if conditions.idle_bits and idle_ns < conditions.idle_bits * self._bit_ns:
                return done
            self._first_ns = end_ns
        if mark and not self._error:
            self._error = PARITY if mark & PARITY_ERROR else FRAMING
        self._data.append(byte)
        if not self._started and not self._begins():
            return done
        self._started = True
        if (status := self._end()) is not None:
            done.append(self._finish(status))
        return done

    def expire(self, now_ns: int) -> list[Message]:
        """The message that has ended by time up to this instant."""
        due_ns = self.deadline_ns
        if due_ns is None or due_ns > now_ns:
            return []
        gap_bits = self._conditions.gap_bits
        by_gap = gap_bits is not None and due_ns == self._last_ns + gap_bits * self._bit_ns
        return [self._finish(BY_GAP if by_gap else BY_TIME)]

    def reset(self) -> None:
        """Wait for the beginning of a message."""
        self._data.clear()
        self._error = 0
        self._started = False

    def _finish(self, status: int) -> Message:
        message = Message(b"", self._error) if self._error else Message(bytes(self._data), status)
        self.reset()
        return message

    def _begins(self) -> bool:
        """Whether the characters so far begin a message; what cannot begin one is dropped."""
        conditions = self._conditions
        if conditions.start_character is None and not conditions.start_sequences:
            return True
        starts = conditions.start_sequences
        if conditions.start_character is not None:
            starts = (*starts, (conditions.start_character,))
        if any(len(self._data) >= len(one) and _matches(self._data, one) for one in starts):
            return True
        while self._data and not any(_matches(self._data, one) for one in starts):
            del self._data[0]
        if not self._data:
            self._error = 0
        return False

    def _end(self) -> int | None:
        conditions, data = self._conditions, self._data
        length = len(data)
        if length in (conditions.maximum_length, conditions.fixed_length):
            return BY_LENGTH
        end = conditions.end_sequence
        if end and length >= len(end) and _matches(data[-len(end) :], end):
            return BY_SEQUENCE
        field = conditions.length_field
        if field is not None and length >= field.offset - 1 + field.size:
            at = field.offset - 1
            said = int.from_bytes(data[at : at + field.size], "big")
            whole = at + field.size + said + field.rest
            if whole > LONGEST_MESSAGE:
                self._error = self._error or FIELD_TOO_LONG
                return BY_FIELD
            if length >= whole:
                return BY_FIELD
        return None


def _matches(data: bytearray | bytes, sequence: Sequence) -> bool:
    return all(
        wanted is None or byte == wanted for byte, wanted in zip(data, sequence, strict=False)
    )
