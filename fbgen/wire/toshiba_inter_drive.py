"""S and s of the Toshiba protocol: a master drive gives its set-point to the drives that follow it.

VF-AS1 RS485 manual E6581315, pp. 19, 39: binary only, to FA01 over the two-wire port or FA05 over
the four-wire port, in 0.01 % of the maximum frequency; 0000H to FFFFH without a check of the range;
S says that the master is sound, s that it has tripped. Nobody answers, with an error neither. On
the wire such a set-point is a request like others; this names what is in it. A gateway may send it
too (TOSPBDP001 manual v1.1, 8 D and 8 F).
"""

from fbgen.dataclass import dataclass
from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import BROADCAST, Address, Command, Request

TWO_WIRE = 0xFA01
FOUR_WIRE = 0xFA05
FULL = 10_000
"""100.00 %: the maximum frequency of each drive."""


@dataclass(frozen=True, slots=True)
class SetPoint:
    """What a following drive is told. `word` counts 0.01 %."""

    word: int
    master_tripped: bool = False
    com_no: int = TWO_WIRE
    address: Address = BROADCAST

    @property
    def percent(self) -> float:
        """The set-point in percent of the maximum frequency."""
        return 100 * self.word / FULL


def encode(set_point: SetPoint) -> bytes:
    """The frame that a master drive sends."""
    command = Command.S_TRIPPED if set_point.master_tripped else Command.S
    return toshiba_binary.encode_request(
        Request(set_point.address, command, set_point.com_no, set_point.word)
    )


def set_point_of(request: Request) -> SetPoint | None:
    """The set-point in a request, if it is S or s."""
    if request.command not in (Command.S, Command.S_TRIPPED):
        return None
    tripped = request.command is Command.S_TRIPPED
    return SetPoint(request.data, tripped, request.com_no, request.address)
