"""How one inverter of a plant is set up."""

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

from fbgen.dataclass import dataclass
from harness.drives.load import Load, Motor, Rating
from harness.kernel import NS_PER_MS

TimeoutRestart = Literal["any_answered", "writes"]


@dataclass(frozen=True, slots=True)
class ReplyTime:
    """Time from the end of a request to the begin of the reply, drawn evenly between the two.

    The default minimum follows from the 30 to 40 ms that the TOSPBDP001 manual, section 9, gives
    for the whole way, of which the line and the gateway take 20 ms.
    """

    minimum_ns: int = 10 * NS_PER_MS
    maximum_ns: int = 20 * NS_PER_MS


@dataclass(frozen=True, slots=True)
class InverterSettings:
    """What differs from a new inverter.

    `parameters` are physical values by ComNo or name of the catalogue, stored in the EEPROM before
    the plant starts. `rotary_switch` is SW5 of the RS4003Z board: unless it is 0 it gives the
    INV-NO instead of F802. `port` is the one at the line, by its name in the catalogue; None is the
    first. `timeout_restart` is an option of the catalogue, `options` are those that are flags and
    set, such as broadcast_reads.
    """

    name: str = "drive"
    parameters: Mapping[str, float] = field(default_factory=dict)
    motor: Motor = field(default_factory=Motor)
    load: Load = field(default_factory=Load)
    rating: Rating = field(default_factory=Rating)
    reply_time: ReplyTime = field(default_factory=ReplyTime)
    rotary_switch: int = 0
    port: str | None = None
    timeout_restart: TimeoutRestart = "any_answered"
    options: frozenset[str] = frozenset()
