"""Run, stop, direction and speed of an inverter: what it makes of its commands.

Facts: VF-AS1 RS485 manual E6581315, section 8.1, table 1, for the command word; VF-S11 manual
E6581230 for FH, UL, LL, ACC and dEC. Nothing here is stepped: the output frequency is worked out
from the last change.

Inferred, because the documents at hand do not say: coast stop wins over DC braking, and both over
run; jog needs the run bit; with a preset speed its frequency counts whatever bit 14 says; LL is not
for jogging; after coasting the inverter starts at 0 Hz and does not search the speed.
"""

from dataclasses import replace
from enum import Enum
from math import inf

from fbgen.catalog import Drive
from fbgen.dataclass import dataclass
from harness.drives.load import Load, Motor
from harness.drives.ramp import Ramp, standing
from harness.drives.registers import Registers
from harness.drives.word_bits import CommandBits
from harness.kernel import NS_PER_S, Kernel

SERIAL = "serial communication"
PARAMETERS = (
    "command_mode",
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
    """What the commands ask for, wherever they come from. `hz` lies within the limits."""

    run: bool = False
    reverse: bool = False
    coast: bool = False
    dc_braking: bool = False
    jog: bool = False
    pattern_2: bool = False
    pi_control_off: bool = False
    motor_2: bool = False
    hz: float = 0.0


class Operation:
    """The output stage with motor and load. `evaluate` after each change of command or setting."""

    __slots__ = (
        "_bits",
        "_counted_ns",
        "_kernel",
        "_operated_ns",
        "_registers",
        "_serial_mode",
        "_setpoint",
        "command",
        "load",
        "local",
        "mode",
        "motor",
        "panel",
        "ramp",
        "shaft",
        "wish",
    )

    def __init__(
        self, kernel: Kernel, series: Drive, registers: Registers, motor: Motor, load: Load
    ) -> None:
        self._kernel = kernel
        self._registers = registers
        self._bits = CommandBits.of(series.command_word)
        self._setpoint = series.link.setpoint
        self._serial_mode = next(
            (
                value
                for value, text in series.comno("command_mode").values.items()
                if text == SERIAL
            ),
            None,
        )
        self._counted_ns = kernel.now_ns
        self._operated_ns = 0
        self.motor = motor
        self.load = load
        self.panel = Panel()
        self.local = False
        self.command = 0
        self.mode = Mode.STOP
        self.ramp = standing(kernel.now_ns)
        self.shaft = standing(kernel.now_ns)
        self.wish = self._wish()

    @property
    def network_command(self) -> bool:
        """True while run and stop come from the command word: by bit 15 or by CMOd.

        A terminal that forces local control wins over both (VF-AS1 E6581315, 8.1, input 48).
        """
        return not self.local and (
            bool(self.command & self._bits.network_command)
            or self._registers.word("command_mode") == self._serial_mode
        )

    @property
    def command_source(self) -> int:
        """Who commands at present, in the values of CMOd; a forced one is the terminal board."""
        if self.network_command:
            return 0 if self._serial_mode is None else int(self._serial_mode)
        return 0 if self.local else self._registers.word("command_mode")

    @property
    def network_frequency(self) -> bool:
        """True while the set-point comes from FA01, by bit 14."""
        return not self.local and bool(self.command & self._bits.network_frequency)

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

    def evaluate(self) -> None:
        """Follow the commands and parameters as they are now."""
        self._count()
        wish = self.wish = self._wish()
        if wish.coast:
            self._switch_off(Mode.COAST, self.load.coast_rate)
        elif wish.dc_braking:
            self._switch_off(Mode.DC_BRAKE, self.motor.dc_braking_rate)
        else:
            target = (-wish.hz if wish.reverse else wish.hz) if wish.run else 0.0
            self._drive(Mode.RUN if wish.run else Mode.STOP, target)

    def stop_output(self) -> None:
        """Switch the output stage off at once, as a trip or a loss of supply does."""
        self._count()
        self._switch_off(Mode.COAST, self.load.coast_rate)

    def restart(self) -> None:
        """As after power-on: no command from the network, nobody has pressed RUN again."""
        self.stop_output()
        self.command = 0
        self.panel = replace(self.panel, run=False)
        self.evaluate()

    def _drive(self, mode: Mode, target: float) -> None:
        now_ns = self._kernel.now_ns
        if mode is Mode.STOP and self.mode in (Mode.COAST, Mode.DC_BRAKE):
            self._switch_off(Mode.COAST, self.load.coast_rate)
            return
        which = "_2" if self.wish.pattern_2 else ""
        acceleration = self._rate("acceleration_time" + which)
        deceleration = self._rate("deceleration_time" + which)
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
        command, bits, registers = self.command, self._bits, self._registers
        network = self.network_command
        preset = bits.preset(command) if network else 0
        jog = network and bool(command & bits.jog)
        if preset:
            hz = registers.value(f"preset_speed_{preset}")
        elif jog:
            hz = registers.value("jog_frequency")
        elif self.network_frequency:
            hz = registers.value(self._setpoint)
        else:
            hz = self.panel.frequency_hz
        if not jog:
            hz = max(hz, registers.value("lower_limit_frequency"))
        hz = min(hz, registers.value("upper_limit_frequency"), registers.value("maximum_frequency"))
        if not network:
            return Wish(run=self.panel.run, reverse=self.panel.reverse, hz=hz)
        return Wish(
            run=bool(command & bits.run),
            reverse=bool(command & bits.reverse),
            coast=bool(command & bits.coast_stop),
            dc_braking=bool(command & bits.dc_braking),
            jog=jog,
            pattern_2=bool(command & bits.pattern_2),
            pi_control_off=bool(command & bits.pi_control_off),
            motor_2=bool(command & bits.motor_2),
            hz=hz,
        )

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
