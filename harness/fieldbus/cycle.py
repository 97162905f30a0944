"""The grid of the PROFIBUS cycle: at which instants the master polls its slaves.

Nothing happens at an instant of the grid unless somebody has something new, so the grid is
arithmetic and no event. Jitter delays single instants; it depends on the plant's seed and the
number of the cycle only, so that it is the same however often somebody asks.
"""

from dataclasses import replace
from random import Random

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from harness.kernel import NS_PER_MS

_MASK = (1 << 64) - 1


@dataclass(frozen=True, slots=True)
class CycleTimes:
    """Period of the master's cycle, its phase on the plant's clock and its largest delay, in ns."""

    period_ns: int = 2 * NS_PER_MS
    phase_ns: int = 0
    jitter_ns: int = 0

    def __post_init__(self) -> None:
        if self.period_ns <= 0 or not 0 <= self.jitter_ns < self.period_ns:
            raise error(
                "FB7201",
                f"a PROFIBUS cycle of {self.period_ns / NS_PER_MS:g} ms "
                f"with a jitter of {self.jitter_ns / NS_PER_MS:g} ms is not possible",
                None,
                "the cycle takes some time, and the jitter is less than one cycle",
            )


class CycleGrid:
    """The instants of a master's cycles."""

    __slots__ = ("_jitter_ns", "_period_ns", "_phase_ns", "_random", "_salt", "times")

    def __init__(self, times: CycleTimes, random: Random) -> None:
        self.times = times
        self._period_ns = times.period_ns
        self._phase_ns = times.phase_ns
        self._jitter_ns = times.jitter_ns
        self._random = random
        self._salt = random.getrandbits(64) if times.jitter_ns else 0

    def jitter(self, jitter_ns: int) -> None:
        """Another largest delay, from the next instant on."""
        self.times = replace(self.times, jitter_ns=jitter_ns)
        self._jitter_ns = jitter_ns
        if jitter_ns and not self._salt:
            self._salt = self._random.getrandbits(64)

    def after(self, time_ns: int) -> int:
        """The first instant later than `time_ns`."""
        phase_ns, period_ns = self._phase_ns, self._period_ns
        number = (time_ns - phase_ns) // period_ns
        if self._jitter_ns:
            instant_ns = self._instant(number)
            if instant_ns > time_ns:
                return instant_ns
            return self._instant(number + 1)
        return phase_ns + (number + 1) * period_ns

    def up_to(self, time_ns: int) -> int:
        """The last instant that is not later than `time_ns`."""
        number = (time_ns - self._phase_ns) // self._period_ns
        instant_ns = self._instant(number)
        return instant_ns if instant_ns <= time_ns else self._instant(number - 1)

    def _instant(self, number: int) -> int:
        start_ns = self._phase_ns + number * self._period_ns
        if not self._jitter_ns:
            return start_ns
        mixed = (number * 0x9E3779B97F4A7C15 + self._salt) & _MASK
        mixed = ((mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9) & _MASK
        mixed = ((mixed ^ mixed >> 27) * 0x94D049BB133111EB) & _MASK
        return start_ns + (mixed ^ mixed >> 31) % (self._jitter_ns + 1)
