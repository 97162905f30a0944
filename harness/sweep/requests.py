"""What is asked of a line during one run of a sweep, and what came of it."""

from collections.abc import Sequence

from fbgen.dataclass import dataclass
from harness.rules.repeats_allowed import is_repeatable

READ, WRITE_RAM, WRITE_EEPROM, SETPOINT = 0x47, 0x50, 0x57, 0x53
BROADCAST = 0xFF
COMMAND_WORD, FAULT_RESET = 0xFA00, 0x2000


@dataclass(frozen=True, slots=True)
class Request:
    """A telegram that is asked for. `channel` is the place of the user who asks, from 0."""

    channel: int
    inv_no: int
    cmd: int
    com_no: int
    data: int = 0
    reply_expected: bool = True

    @property
    def repeatable(self) -> bool:
        """Whether a drive may get it twice: a read, or a write after which it is as after one.

        A reset restarts the drive each time; a cell of the EEPROM wears out with each write.
        """
        return is_repeatable(self.telegram)

    @property
    def telegram(self) -> bytes:
        """INV-NO, CMD, ComNo and DATA as they go out."""
        return (
            bytes((self.inv_no, self.cmd))
            + self.com_no.to_bytes(2, "big")
            + self.data.to_bytes(2, "big")
        )

    def __str__(self) -> str:
        return f"channel {self.channel}: {self.telegram.hex(' ').upper()}"


@dataclass(frozen=True, slots=True)
class Ask:
    """Ask for these at the same instant; `wait` until all have ended."""

    requests: Sequence[Request]
    wait: bool = True


@dataclass(frozen=True, slots=True)
class Die:
    """The drive with this INV-NO falls silent, as if its supply went."""

    inv_no: int


@dataclass(frozen=True, slots=True)
class Revive:
    """It listens again."""

    inv_no: int


@dataclass(frozen=True, slots=True)
class Pause:
    """Nothing is asked for a while."""

    duration_ns: int


@dataclass(frozen=True, slots=True)
class EmergencyStop:
    """The rising edge of the line's emergency stop."""


Step = Ask | Die | Revive | Pause | EmergencyStop


@dataclass(slots=True)
class Outcome:
    """What became of a request; `ended_ns` None while it has not ended."""

    request: Request
    posted_ns: int
    ended_ns: int | None = None
    done: bool = False
    status: int = 0
    data: int = 0
