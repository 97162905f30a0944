"""Run, stop, direction and speed of an inverter: what it makes of its commands.

Facts: VF-AS1 RS485 manual E6581315, section 8.1, table 1, for the command word; VF-S11 manual
E6581230 for FH, UL, LL, ACC and dEC. Nothing here is stepped: the output frequency is worked out
from the last change.

Inferred, because the documents at hand do not say: coast stop wins over DC braking, and both over
run; jog needs the run bit; with a preset speed its frequency counts whatever bit 14 says; LL is not
for jogging; after coasting the inverter starts at 0 Hz and does not search the speed. Forced
continuous operation (terminal function 56) runs on as it ran last; specified speed operation (58)
runs forward at preset speed 15; both come to an end by a trip. The greatest deceleration, bit 7 of
FA20, is the shortest that dEC can be set to.
"""

from dataclasses import replace
from enum import Enum
from math import inf

from fbgen.dataclass import dataclass
from harness.drives.command_words import CommandWords
from harness.drives.load import Load, Motor
from harness.drives.ramp import Ramp, standing
from harness.drives.registers import Registers
from harness.drives.terminals import FORCED_RUN, SPECIFIED_SPEED
from harness.kernel import NS_PER_S, Kernel

_RAMP_KINDS = ("acceleration", "deceleration")
PARAMETERS = (
    "command_mode",
    "frequency_mode",
    "acceleration_time",
    "acceleration_time_2",
    "deceleration_time",
    "deceleration_time_2",
    "maximum_frequency",
    "upper_limit_frequency",
    "lower_limit_frequency",
    "jog_frequency",
    "dc_braking_current",
    *(f"preset_speed_{number}" for number in range(1, 16)),
)
"""Names of the ComNos that say how the inverter runs."""

MORE_RAMPS = tuple(f"{kind}_time_{number}" for number in (3, 4) for kind in _RAMP_KINDS)
"""Those that only some series have."""

_FIRE_SPEED = "preset_speed_15"


class Mode(Enum):
    """What the output stage does."""

    RUN = "run"
    STOP = "ramp down to rest"
    COAST = "output off"
    DC_BRAKE = "direct current"


_RUN, _STOP = Mode.RUN, Mode.STOP
"""By names of their own, as every telegram asks for them."""


@dataclass(frozen=True, slots=True)
class Panel:
    """The hands at the inverter: panel or terminals, for when the network has no priority."""

    run: bool = False
    reverse: bool = False
    frequency_hz: float = 0.0


@dataclass(frozen=True, slots=True)
class Wish:
    """What the commands ask for, wherever they come from. `hz` lies within the limits.

    `pattern` counts the ramps, from 0 for ACC and dEC on.
    """

    run: bool = False
    reverse: bool = False
    coast: bool = False
    dc_braking: bool = False
    jog: bool = False
    pattern: int = 0
    quick_stop: bool = False
    pi_control_off: bool = False
    motor_2: bool = False
    hz: float = 0.0


class Operation:
    """The output stage with motor and load. `evaluate` after each change of command or setting."""

    __slots__ = (
        "_counted_ns",
        "_kernel",
        "_operated_ns",
        "_powered_ns",
        "_powered_since_ns",
        "_ramps",
        "_registers",
        "_shortest_s",
        "load",
        "mode",
        "motor",
        "panel",
        "ramp",
        "shaft",
        "wish",
        "words",
    )

    def __init__(
        self,
        kernel: Kernel,
        registers: Registers,
        words: CommandWords,
        motor: Motor,
        load: Load,
    ) -> None:
        self._kernel = kernel
        self._registers = registers
        self.words = words
        names = {comno.name for comno in registers.cells.values()}
        numbers = ("", *(f"_{number}" for number in (2, 3, 4)))
        self._ramps = [more for more in numbers if f"acceleration_time{more}" in names]
        cell = registers.cell("deceleration_time")
        self._shortest_s = max(cell.resolution, cell.minimum or 0.0)
        self._counted_ns = kernel.now_ns
        self._operated_ns = self._powered_ns = 0
        self._powered_since_ns: int | None = kernel.now_ns
        self.motor = motor
        self.load = load
        self.panel = Panel()
        self.mode = Mode.STOP
        self.ramp = standing(kernel.now_ns)
        self.shaft = standing(kernel.now_ns)
        self.wish = Wish()
        self.wish = self._wish()

    @property
    def network_command(self) -> bool:
        """True while run and stop come from a command word: by bit 15 or by CMOd.

        A terminal that forces local control wins over both (VF-AS1 E6581315, 8.1, input 48).
        """
        return self.words.commanding is not None

    @property
    def command_source(self) -> int:
        """Who commands at present, in the values of CMOd."""
        return self.words.source("command_mode", self.network_command)

    @property
    def frequency_source(self) -> int:
        """Where the set-point comes from at present, in the values of FMOd."""
        return self.words.source("frequency_mode", self.network_frequency)

    @property
    def network_frequency(self) -> bool:
        """True while the set-point is that of a port: by bit 14 or by FMOd."""
        return self.words.setting_frequency is not None

    @property
    def output_hz(self) -> float:
        """Output frequency now, negative in reverse."""
        mode = self.mode
        if mode is _RUN or mode is _STOP:
            return self.ramp.at(self._kernel.now_ns)
        return 0.0

    @property
    def running(self) -> bool:
        """True while the output stage turns the motor, ramping down included."""
        mode = self.mode
        return mode is _RUN or (mode is _STOP and self.output_hz != 0.0)

    @property
    def reverse(self) -> bool:
        """Direction of rotation; at rest the one that is commanded."""
        output = self.output_hz
        return output < 0 if output else self.wish.reverse

    @property
    def moving_until_ns(self) -> int:
        """Instant at which the output frequency is where it goes to; the past while it stands."""
        if self.mode not in (_RUN, _STOP) or self.output_hz == self.ramp.target_hz:
            return self.ramp.start_ns
        return max(self.ramp.end_ns, self._kernel.now_ns + 1)

    @property
    def shaft_hz(self) -> float:
        """Speed of the shaft as a frequency, negative in reverse; it turns on without drive."""
        if self.mode in (Mode.RUN, Mode.STOP):
            return self.output_hz
        return self.shaft.at(self._kernel.now_ns)

    @property
    def torque_percent(self) -> float:
        """Torque of the motor in percent of its rated torque."""
        if not self.running:
            return 0.0
        return self.load.torque_at(self.output_hz, self.ramp.slope(self._kernel.now_ns))

    @property
    def current_percent(self) -> float:
        """Output current in percent of the rated current."""
        if self.mode is Mode.DC_BRAKE:
            return self._registers.value("dc_braking_current")
        if not self.running:
            return 0.0
        return self.motor.current_percent(self.torque_percent, self.output_hz)

    @property
    def torque_current_percent(self) -> float:
        """The part of the output current that makes the torque."""
        return self.motor.torque_current_percent(self.torque_percent, self.output_hz)

    @property
    def exciting_current_percent(self) -> float:
        """The part of the output current that magnetises the motor."""
        return self.motor.exciting_current_percent(self.output_hz) if self.running else 0.0

    @property
    def operated_ns(self) -> int:
        """Time that the output stage has run in all."""
        self._count()
        return self._operated_ns

    @property
    def powered_ns(self) -> int:
        """Time with supply in all."""
        since_ns = self._powered_since_ns
        return self._powered_ns + (0 if since_ns is None else self._kernel.now_ns - since_ns)

    def supply(self, on: bool) -> None:
        """The supply comes or goes; without it the output stage is off."""
        self._powered_ns = self.powered_ns
        self._powered_since_ns = self._kernel.now_ns if on else None
        self.stop_output()

    def evaluate(self) -> None:
        """Follow the commands and parameters as they are now."""
        self._count()
        wish = self.wish = self._wish()
        if wish.coast:
            self._switch_off(Mode.COAST, self.load.coast_rate)
        elif wish.dc_braking:
            self._switch_off(Mode.DC_BRAKE, self.motor.dc_braking_rate)
        else:
            runs = wish.run and not wish.quick_stop
            target = (-wish.hz if wish.reverse else wish.hz) if runs else 0.0
            self._drive(Mode.RUN if runs else Mode.STOP, target)

    def stop_output(self) -> None:
        """Switch the output stage off at once, as a trip or a loss of supply does."""
        self._count()
        self._switch_off(Mode.COAST, self.load.coast_rate)

    def restart(self) -> None:
        """As after power-on: no command from the network, nobody has pressed RUN again."""
        self.stop_output()
        self.panel = replace(self.panel, run=False)
        self.evaluate()

    def _drive(self, mode: Mode, target: float) -> None:
        now_ns = self._kernel.now_ns
        if mode is Mode.STOP and self.mode in (Mode.COAST, Mode.DC_BRAKE):
            self._switch_off(Mode.COAST, self.load.coast_rate)
            return
        which = self._ramps[min(self.wish.pattern, len(self._ramps) - 1)]
        acceleration = self._rate("acceleration_time" + which)
        deceleration = self._rate("deceleration_time" + which)
        if self.wish.quick_stop:
            deceleration = self._registers.value("maximum_frequency") / self._shortest_s
        changed = (target, acceleration, deceleration) != self.ramp[2:]
        if changed or mode is not self.mode:
            self.ramp = Ramp(now_ns, self.output_hz, target, acceleration, deceleration)
        self.mode = mode

    def _switch_off(self, mode: Mode, rate: float) -> None:
        if self.mode is not mode:
            now_ns = self._kernel.now_ns
            self.shaft = Ramp(now_ns, self.shaft_hz, 0.0, inf, rate)
            self.mode = mode

    def _rate(self, time_name: str) -> float:
        seconds = self._registers.value(time_name)
        return self._registers.value("maximum_frequency") / seconds if seconds else inf

    def _wish(self) -> Wish:
        words, registers = self.words, self._registers
        forced = words.overriding
        if forced == FORCED_RUN:
            wish, hz = self.wish, self._limited(self.wish.hz)
            return Wish(run=True, reverse=wish.reverse, pattern=wish.pattern, hz=hz)
        if forced == SPECIFIED_SPEED:
            return Wish(run=True, hz=self._limited(registers.value(_FIRE_SPEED)))
        channel, setting = words.commanding, words.setting_frequency
        hz = self.panel.frequency_hz if setting is None else registers.value(setting.setpoint)
        if channel is None:
            panel, coast = self.panel, words.coasts_always
            return Wish(run=panel.run, reverse=panel.reverse, coast=coast, hz=self._limited(hz))
        command, bits = words.word_of(channel), words.bits
        second, second_bits = words.second_word_of(channel), words.second_bits
        jog = bool(command & bits.jog)
        if preset := bits.preset(command):
            hz = registers.value(f"preset_speed_{preset}")
        elif jog:
            hz = registers.value("jog_frequency")
        return Wish(
            run=bool(command & bits.run),
            reverse=bool(command & bits.reverse),
            coast=bool(command & bits.coast_stop) or words.coasts_always,
            dc_braking=bool(command & bits.dc_braking),
            jog=jog,
            pattern=bool(command & bits.pattern_2) | second_bits.pattern_of(second),
            quick_stop=bool(second & second_bits.quick_stop),
            pi_control_off=bool(command & bits.pi_control_off),
            motor_2=bool(command & bits.motor_2),
            hz=self._limited(hz, to_jog=jog),
        )

    def _limited(self, hz: float, to_jog: bool = False) -> float:
        """A frequency within LL, but for jogging, UL and FH."""
        value = self._registers.value
        if not to_jog:
            hz = max(hz, value("lower_limit_frequency"))
        return min(hz, value("upper_limit_frequency"), value("maximum_frequency"))

    def _count(self) -> None:
        """Add the time since the last count in which the output stage ran."""
        now_ns, since_ns = self._kernel.now_ns, self._counted_ns
        if self.mode is Mode.RUN:
            self._operated_ns += now_ns - since_ns
        elif self.mode is Mode.STOP:
            self._operated_ns += max(0, min(now_ns, self.ramp.end_ns) - since_ns)
        self._counted_ns = now_ns


def hours(duration_ns: int) -> int:
    """Whole hours of a time."""
    return duration_ns // (3600 * NS_PER_S)
