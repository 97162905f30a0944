"""Port_Config, Send_Config and Receive_Config: other settings until the supply is lost.

Source: TIA Portal Information System, the pages of the three instructions and "Error messages".
What the harness has no use for is taken and not looked at: flow control, RTS and break times, end
characters that are sent along. RECEIVE_CONDITIONS lies in memory as its table says, S7 layout; a
variable that is shorter is 8322.
"""

from collections.abc import Mapping

from harness.line import Parity, SerialFormat
from harness.plc.serial.conditions import LengthField, ReceiveConditions, Sequence
from harness.plc.serial.jobs import TimedInstruction
from harness.plc.serial.module import SerialModule

BAUD_RATES = {
    **{1: 300, 2: 600, 3: 1200, 4: 2400, 5: 4800, 6: 9600, 7: 19_200, 8: 38_400, 9: 57_600},
    **{10: 76_800, 11: 115_200, 12: 250_000},
}
PARITIES = {1: Parity.NONE, 2: Parity.EVEN, 3: Parity.ODD}
_CONDITIONS_BYTES = 64


class PortConfig(TimedInstruction):
    """Baud rate, parity and stop bits."""

    __slots__ = ()

    def begin(self, module: SerialModule, areas: Mapping[str, bytes]) -> int:
        """81A0 to 81AA for what the module does not have."""
        checks = (
            (0x81A0, self.number("PROTOCOL") == 0),
            (0x81A1, self.number("BAUD", 6) in BAUD_RATES),
            (0x81A2, self.number("PARITY", 1) in PARITIES),
            (0x81A3, self.number("DATABITS", 1) == 1),
            (0x81A4, self.number("STOPBITS", 1) in (1, 2)),
            (0x81A5, self.number("FLOWCTRL", 1) == 1),
            (0x81AA, self.number("MODE") in range(5)),
        )
        for status, right in checks:
            if not right:
                return status
        module.configure(
            SerialFormat(
                BAUD_RATES[self.number("BAUD", 6)],
                PARITIES[self.number("PARITY", 1)],
                self.number("STOPBITS", 1),
            )
        )
        return 0


class SendConfig(TimedInstruction):
    """The idle line before what is sent."""

    __slots__ = ()

    def begin(self, module: SerialModule, areas: Mapping[str, bytes]) -> int:
        """IDLELINE in bit times."""
        module.idle_bits = self.number("IDLELINE")
        module.clear()
        return 0


class ReceiveConfig(TimedInstruction):
    """Where a message begins and where it ends."""

    __slots__ = ()

    areas = ("RECEIVE_CONDITIONS",)

    def begin(self, module: SerialModule, areas: Mapping[str, bytes]) -> int:
        """81C0 to 81CC for conditions that cannot be."""
        data = areas["RECEIVE_CONDITIONS"]
        if len(data) < _CONDITIONS_BYTES:
            return 0x8322
        try:
            conditions = read_conditions(data)
        except ValueError:
            return 0x81C0
        status = conditions.problem()
        if not status:
            module.configure(conditions=conditions)
        return status


def read_conditions(data: bytes) -> ReceiveConditions:
    """The structure Receive_Conditions. Raises ValueError for start conditions that cannot be.

    START: STARTCOND, IDLETIME (words), STARTCHAR (byte), four sequences of CTL and 5 characters.
    END: ENDCOND, FIXLEN, MAXLEN, N, LENGTHSIZE, LENGTHM, RCVTIME, MSGTIME, CHARGAP (words), a
    sequence. Arrays and structures begin at even bytes: a sequence has 8, a byte behind CTL is left
    out.
    """

    def word(at: int) -> int:
        return int.from_bytes(data[at : at + 2], "big")

    def sequence(at: int) -> Sequence:
        chosen = range(5)
        return tuple(data[at + 2 + i] if data[at] >> i & 1 else None for i in chosen)

    start, end = word(0), word(38)
    if not start or start & 0x04 or (start & 0x02 and start != 0x02):
        raise ValueError
    sequences = tuple(sequence(6 + 8 * i) for i in range(4) if start >> (4 + i) & 1)
    last = sequence(56)
    while last and last[0] is None:
        last = last[1:]
    return ReceiveConditions(
        idle_bits=word(2) if start & 0x08 else None,
        start_character=data[4] if start & 0x01 else None,
        start_sequences=sequences,
        fixed_length=word(40) if end & 0x40 else None,
        maximum_length=word(42) if end & 0x08 else None,
        length_field=LengthField(word(44), word(46), word(48)) if end & 0x10 else None,
        response_ms=word(50) if end & 0x01 else None,
        message_ms=word(52) if end & 0x02 else None,
        gap_bits=word(54) if end & 0x04 else None,
        end_sequence=(last or (None,)) if end & 0x20 else (),
    )
