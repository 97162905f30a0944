"""Motor and load: which torque and current belong to a speed.

The current is the vector sum of two parts at right angles: the current that magnetises the motor,
which flows without load too, and the one that makes the torque. 100 % is the rated current of the
inverter, taken as that of the motor at its rated torque, so

    I = sqrt(I0^2 + (T x sqrt(100^2 - I0^2))^2)        T = 1 at rated torque.

Above the base frequency the voltage cannot rise further: the flux falls with 1/f, the torque needs
more current. With the motor as it is by default (I0 = 30 %) a load of 32.7 % of the rated torque
at 50 Hz draws 43.28 %, the current in the example of the TOSPBDP001 manual, section 8 G.
"""

from enum import Enum
from math import hypot, sqrt

from fbgen.dataclass import dataclass


class LoadShape(Enum):
    """How the torque of a load depends on the speed."""

    CONSTANT = "constant"
    LINEAR = "linear"
    QUADRATIC = "quadratic"


@dataclass(frozen=True, slots=True)
class Load:
    """A driven machine: `torque_percent` of the rated torque at `at_hz`.

    `inertia_percent_s` is the torque in percent that it takes to change the speed by 1 Hz in a
    second. `coast_s` is the time in which the machine comes to rest from 50 Hz without a drive.
    """

    torque_percent: float = 0.0
    shape: LoadShape = LoadShape.CONSTANT
    at_hz: float = 50.0
    inertia_percent_s: float = 0.0
    coast_s: float = 5.0

    def torque_at(self, hz: float, slope: float = 0.0) -> float:
        """Torque in percent of the rated torque at a speed that changes by `slope` Hz/s."""
        relative = abs(hz) / self.at_hz
        if self.shape is LoadShape.CONSTANT:
            steady = self.torque_percent if hz else 0.0
        elif self.shape is LoadShape.LINEAR:
            steady = self.torque_percent * relative
        else:
            steady = self.torque_percent * relative * relative
        return steady + self.inertia_percent_s * slope

    @property
    def coast_rate(self) -> float:
        """How fast the machine slows down without a drive, in Hz/s."""
        return 50.0 / self.coast_s


@dataclass(frozen=True, slots=True)
class Motor:
    """The motor behind the inverter. Currents in percent of the inverter's rated current."""

    no_load_current_percent: float = 30.0
    base_frequency_hz: float = 50.0
    dc_braking_rate: float = 50.0
    """How fast direct current brings the shaft to rest, in Hz/s."""

    def torque_current_percent(self, torque_percent: float, hz: float) -> float:
        """The part of the current that makes the torque."""
        rated = sqrt(100.0**2 - self.no_load_current_percent**2)
        return torque_percent / 100.0 * rated / self._flux(hz)

    def exciting_current_percent(self, hz: float) -> float:
        """The part of the current that magnetises the motor."""
        return self.no_load_current_percent * self._flux(hz)

    def current_percent(self, torque_percent: float, hz: float) -> float:
        """The output current while the inverter drives the motor."""
        return hypot(
            self.exciting_current_percent(hz), self.torque_current_percent(torque_percent, hz)
        )

    def voltage_percent(self, hz: float) -> float:
        """The output voltage: proportional to the frequency up to the base frequency."""
        return 100.0 * min(1.0, abs(hz) / self.base_frequency_hz)

    def _flux(self, hz: float) -> float:
        return min(1.0, self.base_frequency_hz / abs(hz)) if hz else 1.0


@dataclass(frozen=True, slots=True)
class Rating:
    """What the name plate of the inverter says: here that of 200 V class, 3.7 kW."""

    power_kw: float = 3.7
    current_a: float = 17.5
    voltage_v: float = 200.0

    def power_at(self, torque_percent: float, relative_speed: float) -> float:
        """Power in kW at a torque and a speed as part of the base frequency; without losses."""
        return self.power_kw * torque_percent / 100.0 * relative_speed
