"""Speeds in min-1 and frequencies of the inverter: n = 120 x f / poles."""

from fbgen.dataclass import dataclass

_LARGEST = 0xFFFF


@dataclass(frozen=True, slots=True)
class Speeds:
    """Converts by the number of poles. With four 1800 min-1 are 60 Hz."""

    poles: int

    def hundredths_of_hz(self, speed: int) -> int:
        """A speed in 0.01 Hz."""
        return min(_LARGEST, round(speed * self.poles * 100 / 120))

    def per_minute(self, hundredths: int) -> int:
        """A frequency in 0.01 Hz as a speed."""
        return min(0x7FFF, round(hundredths * 120 / (self.poles * 100)))
