"""What a serial port asks of the inverter behind it."""

from typing import Protocol

from fbgen.catalog import Drive
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

    def set_scaled(self, number: int, word: int) -> None:
        """Take a value of the commands S and s."""

    def time_out(self) -> None:
        """No telegram came within the time of F803."""


@dataclass(frozen=True, slots=True)
class Owner:
    """The inverter that a port belongs to: what its series has, its cells, and itself."""

    series: Drive
    registers: Registers
    device: Device
