"""What a DP master tells a slave in Set_Prm, and what a slave is made for.

Layout of Set_Prm and the watchdog's unit: EN 50170 volume 2. What lock and unlock do: Norgren FD67
section 5.4.1.1. What the TOSPBDP001 is stands in its GSD file (TOSPBDP001 manual v1.1, section 8):
ident number 1803, sync and freeze, no user parameters.
"""

from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.wire.dp import DIAGNOSIS_BYTES, PrmStatus
from harness.kernel import NS_PER_MS

WATCHDOG_UNIT_NS = 10 * NS_PER_MS
_LARGEST_FACTOR = 255
_SET_PRM_BYTES = 7
_NO_WATCHDOG = (1, 1)
"""Factors that are sent, and do not count, with WD_On = 0."""


class Lock(Enum):
    """What Set_Prm wants of a slave besides its parameters.

    LOCK: it belongs to this master. UNLOCK: it is free for any master. NEITHER: only min Tsdr may
    be changed, all else stays as it is.
    """

    LOCK = "lock"
    UNLOCK = "unlock"
    NEITHER = "neither"


@dataclass(frozen=True, slots=True)
class Parameters:
    """A Set_Prm telegram.

    `watchdog_factors` are WD_Fact_1 and WD_Fact_2, None for WD_On = 0. `group` has one bit for
    each Global_Control group of which the slave is a member. `sync` and `freeze` say that the
    master may send these commands. `min_tsdr` is the least delay of an answer in bit times, 0 for
    no change.
    """

    ident_number: int
    watchdog_factors: tuple[int, int] | None
    group: int = 0
    user_data: bytes = b""
    lock: Lock = Lock.LOCK
    sync: bool = True
    freeze: bool = True
    min_tsdr: int = 11

    def encode(self) -> bytes:
        """The data of the telegram."""
        status = PrmStatus(0)
        if self.watchdog_factors is not None:
            status |= PrmStatus.WD_ON
        if self.freeze:
            status |= PrmStatus.FREEZE_REQ
        if self.sync:
            status |= PrmStatus.SYNC_REQ
        if self.lock is Lock.LOCK:
            status |= PrmStatus.LOCK_REQ
        elif self.lock is Lock.UNLOCK:
            status |= PrmStatus.UNLOCK_REQ
        head = bytes((status, *(self.watchdog_factors or _NO_WATCHDOG), self.min_tsdr))
        return head + self.ident_number.to_bytes(2, "big") + bytes((self.group,)) + self.user_data

    @property
    def watchdog_ns(self) -> int | None:
        """Time without a telegram after which the slave gives up; None for never."""
        if self.watchdog_factors is None:
            return None
        first, second = self.watchdog_factors
        return first * second * WATCHDOG_UNIT_NS


@dataclass(frozen=True, slots=True)
class SlaveType:
    """What a slave accepts: its ident number, its configurations and its user parameters.

    `other_configurations` are taken as well as `configuration`, by a slave of which the master
    chooses the module. Of what the device itself says in Slave_Diag, no more than fits into
    `max_diagnosis_bytes` with the six standard ones.
    """

    ident_number: int
    configuration: bytes
    user_parameter_bytes: int = 0
    other_configurations: tuple[bytes, ...] = ()
    max_diagnosis_bytes: int = DIAGNOSIS_BYTES

    def accepts(self, configuration: bytes) -> bool:
        """Whether these are identifiers of the slave, byte by byte."""
        return configuration == self.configuration or configuration in self.other_configurations


def decode_parameters(data: bytes) -> Parameters | None:
    """The Set_Prm telegram that these data are; None if they are too short to be one."""
    if len(data) < _SET_PRM_BYTES:
        return None
    status = PrmStatus(data[0])
    if status & PrmStatus.UNLOCK_REQ:
        lock = Lock.UNLOCK
    else:
        lock = Lock.LOCK if status & PrmStatus.LOCK_REQ else Lock.NEITHER
    return Parameters(
        int.from_bytes(data[4:6], "big"),
        (data[1], data[2]) if status & PrmStatus.WD_ON else None,
        data[6],
        data[_SET_PRM_BYTES:],
        lock,
        bool(status & PrmStatus.SYNC_REQ),
        bool(status & PrmStatus.FREEZE_REQ),
        data[3],
    )


def watchdog_factors(watchdog_ns: int) -> tuple[int, int]:
    """WD_Fact_1 and WD_Fact_2 for the shortest watchdog time that is not below `watchdog_ns`.

    Raises DiagnosticError FB7202 for a time that no factors can say: 0, or more than 650.25 s.
    """
    units = -(-watchdog_ns // WATCHDOG_UNIT_NS)
    if not 1 <= units <= _LARGEST_FACTOR * _LARGEST_FACTOR:
        raise error(
            "FB7202",
            f"a watchdog time of {watchdog_ns / NS_PER_MS:g} ms cannot be set",
            None,
            "choose 10 ms to 650,250 ms, or switch the watchdog off",
        )
    pairs = (
        (first, -(-units // first))
        for first in range(1, _LARGEST_FACTOR + 1)
        if -(-units // first) <= _LARGEST_FACTOR
    )
    return min(pairs, key=lambda pair: (pair[0] * pair[1], pair[0]))
