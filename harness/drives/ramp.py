"""How a frequency moves: a straight line to its target, worked out when somebody looks.

Frequencies are signed, negative is reverse. Away from zero the acceleration counts, towards zero
the deceleration; a change of direction goes through zero with both, one after the other.
"""

from math import copysign, inf
from typing import NamedTuple

from harness.kernel import NS_PER_S


class Ramp(NamedTuple):
    """From `start_hz` at `start_ns` towards `target_hz`; rates in Hz/s, infinite for a jump."""

    start_ns: int
    start_hz: float
    target_hz: float
    acceleration: float
    deceleration: float

    def at(self, now_ns: int) -> float:
        """The frequency at an instant, in Hz."""
        start, target = self.start_hz, self.target_hz
        if start == target:
            return target
        elapsed = (now_ns - self.start_ns) / NS_PER_S
        if start * target < 0:
            until_zero = abs(start) / self.deceleration
            if elapsed < until_zero:
                return start - copysign(self.deceleration * elapsed, start)
            start, elapsed = 0.0, elapsed - until_zero
        rate = self.acceleration if abs(target) > abs(start) else self.deceleration
        if rate == inf or abs(target - start) <= rate * elapsed:
            return target
        return start + copysign(rate * elapsed, target - start)

    def slope(self, now_ns: int) -> float:
        """How fast the amount of the frequency grows at an instant, in Hz/s; 0 at the target."""
        here = self.at(now_ns)
        if here == self.target_hz:
            return 0.0
        growing = here * self.target_hz >= 0 and abs(self.target_hz) > abs(here)
        return self.acceleration if growing else -self.deceleration

    @property
    def end_ns(self) -> int:
        """Instant at which the target is reached."""
        start, target = self.start_hz, self.target_hz
        if start * target < 0:
            duration = abs(start) / self.deceleration + abs(target) / self.acceleration
        elif abs(target) > abs(start):
            duration = abs(target - start) / self.acceleration
        else:
            duration = abs(target - start) / self.deceleration
        return self.start_ns + round(duration * NS_PER_S)


def standing(now_ns: int, hz: float = 0.0) -> Ramp:
    """A frequency that does not move."""
    return Ramp(now_ns, hz, hz, inf, inf)
