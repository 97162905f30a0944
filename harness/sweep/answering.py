"""A drive whose answers tell which telegram they belong to.

It listens and answers as a simulated inverter does, half duplex and with its reply time; but each
value that it gives for a read is a number of its own, counted up over all drives of a run. So a
value that the PLC shows belongs to one telegram and to no other.
"""

from fbgen.catalog import Drive, SerialPort
from fbgen.dataclass import dataclass
from fbgen.wire.toshiba import ErrorCode
from harness.drives.communication import Communication
from harness.drives.device import Owner
from harness.drives.registers import Registers
from harness.drives.settings import InverterSettings, ReplyTime, set_for_line
from harness.kernel import Kernel
from harness.line import Line

_BAUD_RATE = 19_200
UNKNOWN_COM_NO = 0x7FFF
"""No drive knows this ComNo: it refuses, and its refusal does not pass the gateway."""


@dataclass(slots=True)
class AnswerValues:
    """The source of the values of all drives of a line."""

    last: int = 0

    def begin(self, first: int) -> None:
        """A new run, with values behind this one."""
        self.last = first & 0xFFFF

    def next(self) -> int:
        """A value that no drive has given in this run."""
        self.last = self.last + 1 & 0xFFFF
        return self.last


class AnsweringDrive:
    """One such drive on a line."""

    def __init__(
        self, kernel: Kernel, line: Line, series: Drive, inv_no: int, values: AnswerValues
    ) -> None:
        link = series.link
        words = {
            **set_for_line(series, None, _BAUD_RATE, "even"),
            link.inv_no: inv_no,
            link.timeout: 0,
        }
        delivered = {
            series.comno(name).number: series.comno(name).to_word(word)
            for name, word in words.items()
        }
        self.tripped = False
        self._values = values
        registers = Registers(series, delivered)
        assert series.communication is not None, "checked where the drives of the sweep are chosen"
        port = series.communication.ports[0]
        owner = Owner(series, registers, self)
        self._communication = Communication(kernel, line, owner, port, InverterSettings())

    def begin(self, reply_ns: int) -> None:
        """Listen from now on and answer so long after each telegram."""
        self._communication.reply_time = ReplyTime(reply_ns, reply_ns)
        self.tripped = False
        self.revive()

    def die(self) -> None:
        """Fall silent, in the middle of a reply if need be."""
        self._communication.stop()

    def revive(self) -> None:
        """Listen again."""
        self._communication.restart(0)

    # What the communication asks of the device behind it

    def read(self, number: int) -> int | None:
        """A value of its own for each read."""
        if number == UNKNOWN_COM_NO:
            return None
        return self._values.next()

    def write_ram(self, number: int, word: int) -> ErrorCode | None:
        """Take any value."""
        return None

    def write_eeprom(self, number: int, word: int) -> ErrorCode | None:
        """Take any value."""
        return self.write_ram(number, word)

    def follow(self, port: SerialPort, number: int, word: int, master_tripped: bool) -> None:
        """Take any set-point."""

    def time_out(self, port: SerialPort) -> None:
        """Its time-out is off."""

    def heard(self, port: SerialPort) -> None:
        """Its time-out is off."""
