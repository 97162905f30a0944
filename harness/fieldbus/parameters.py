"""What a DP master tells a slave in Set_Prm, and what a slave is made for.

Layout of Set_Prm and the watchdog's unit: EN 50170 volume 2. What the TOSPBDP001 is stands in its
GSD file (TOSPBDP001 manual v1.1, section 8): ident number 1803, sync and freeze, no user
parameters.
"""

from dataclasses import dataclass

from fbgen.diagnostics import error
from harness.kernel import NS_PER_MS

WATCHDOG_UNIT_NS = 10 * NS_PER_MS
_LARGEST_FACTOR = 255


@dataclass(frozen=True, slots=True)
class Parameters:
    """A Set_Prm telegram.

    `watchdog_factors` are WD_Fact_1 and WD_Fact_2, None for WD_On = 0. `group` has one bit for
    each Global_Control group of which the slave is a member.
    """

    ident_number: int
    watchdog_factors: tuple[int, int] | None
    group: int = 0
    user_data: bytes = b""

    @property
    def watchdog_ns(self) -> int | None:
        """Time without a telegram after which the slave gives up; None for never."""
        if self.watchdog_factors is None:
            return None
        first, second = self.watchdog_factors
        return first * second * WATCHDOG_UNIT_NS


@dataclass(frozen=True, slots=True)
class SlaveType:
    """What a slave accepts: its ident number, its configuration and its user parameters."""

    ident_number: int
    configuration: bytes
    user_parameter_bytes: int = 0


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
