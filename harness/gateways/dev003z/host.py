"""What the option asks of the inverter that it is inside of."""

from collections.abc import Callable
from typing import Protocol

from fbgen.wire.toshiba import ErrorCode


class Host(Protocol):
    """The inverter. Functions in `observers` are called when what it does may have changed."""

    observers: list[Callable[[], None]]
    powered: bool

    @property
    def tripped(self) -> bool:
        """True from a trip to the reset."""

    @property
    def running(self) -> bool:
        """True while the output turns the motor, ramping down included."""

    @property
    def told_to_run(self) -> bool:
        """True while it is told to run, by whoever has the command."""

    @property
    def given_to_option(self) -> bool:
        """Whether CMOd and FMOd both leave it to a communication option."""

    @property
    def network_command(self) -> bool:
        """True while run and stop come from the network."""

    @property
    def network_frequency(self) -> bool:
        """True while the set-point comes from the network."""

    @property
    def reverse(self) -> bool:
        """Direction of rotation; at rest the one that is commanded."""

    def read(self, number: int) -> int | None:
        """The word of a cell, None if there is none."""

    def writable(self, number: int) -> bool:
        """Whether a cell is there and not for reading alone."""

    def write_ram(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell until the next restart; why it is refused, or None."""

    def write_eeprom(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell for good; why it is refused, or None."""

    def trip(self, display: str) -> None:
        """Let a trip come, by what the panel shows of it."""
