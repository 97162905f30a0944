"""Where a message begins and where it ends: what a communication module is set to.

As in the device configuration, or as `Receive_Config` says. Source: TIA Portal Information System,
"Receive_Config: Configure PtP recipient", the tables of start and end conditions, and "Error
messages", 81C0 to 81CC.
"""

from fbgen.dataclass import dataclass

Sequence = tuple[int | None, ...]
"""Characters that must come one behind the other; None for any."""

LONGEST_MESSAGE = 4096


@dataclass(frozen=True, slots=True)
class LengthField:
    """The message says its own length: `offset` bytes, `size` bytes of length, `rest` uncounted."""

    offset: int
    size: int
    rest: int = 0


@dataclass(frozen=True, slots=True)
class ReceiveConditions:
    """Start and end conditions; what is None or empty does not count.

    Without `idle_bits`, `start_character` and `start_sequences` any character begins a message.
    `gap_bits` is the character delay time, from the end of one character to the end of the next
    (inferred: the default of 12 bit times is more than a character). `response_ms` runs from the
    end of what was sent to the first character.
    """

    idle_bits: int | None = None
    start_character: int | None = None
    start_sequences: tuple[Sequence, ...] = ()
    response_ms: int | None = None
    message_ms: int | None = None
    gap_bits: int | None = 44
    maximum_length: int | None = None
    fixed_length: int | None = None
    length_field: LengthField | None = None
    end_sequence: Sequence = ()

    def problem(self) -> int:
        """STATUS of `Receive_Config` for these conditions, 0 where they are right."""
        ends = (self.message_ms, self.gap_bits, self.maximum_length, self.fixed_length)
        if all(one is None for one in ends) and self.length_field is None and not self.end_sequence:
            return 0x81C1
        for length in (self.maximum_length, self.fixed_length):
            if length is not None and not 1 <= length <= LONGEST_MESSAGE:
                return 0x81C3
        field = self.length_field
        if field is not None:
            if not 1 <= field.offset <= LONGEST_MESSAGE:
                return 0x81C4
            if field.size not in (1, 2, 4):
                return 0x81C5
            if not 0 <= field.rest <= 255:
                return 0x81C6
        if self.response_ms == 0:
            return 0x81C8
        if self.gap_bits == 0:
            return 0x81C9
        if self.end_sequence and all(one is None for one in self.end_sequence):
            return 0x81CB
        if any(all(one is None for one in sequence) for sequence in self.start_sequences):
            return 0x81CC
        return 0
