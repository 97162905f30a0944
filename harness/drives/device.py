"""What a serial port asks of the inverter behind it."""

from typing import Protocol

from fbgen.catalog import Drive, SerialPort
from fbgen.dataclass import dataclass
from fbgen.wire.toshiba import ErrorCode
from harness.drives.registers import Registers


class Device(Protocol):
    """The inverter behind its ports."""

    @property
    def tripped(self) -> bool:
        """True from a trip to the reset."""

    def read(self, number: int) -> int | None:
        """The word of a cell, None if there is none."""

    def write_ram(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell until the next restart; why it is refused, or None."""

    def write_eeprom(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell for good; why it is refused, or None."""

    def follow(self, port: SerialPort, number: int, word: int, master_tripped: bool) -> None:
        """Take a value of the commands S and s, heard at a port."""

    def time_out(self, port: SerialPort) -> None:
        """No telegram came to a port within the time of F803."""

    def heard(self, port: SerialPort) -> None:
        """A telegram has come again to a port that had been in time-out."""


@dataclass(frozen=True, slots=True)
class Owner:
    """The inverter that a port belongs to: what its series has, its cells, and itself."""

    series: Drive
    registers: Registers
    device: Device
