"""What an inverter gives when a monitor is read: FC90, FC91, FD00.. and FE00..

Facts: VF-AS1 RS485 manual E6581315, sections 8.2, 8.3 and appendix 1; LinuxCNC driver vfs11_vfd for
the bits of FD01. Output terminals read as their field says; the DC voltage is the rated one, powers
are without losses, and the motor turns as fast as it is told, so what is estimated, fed back or
compensated is the output frequency. A monitor that copies another follows it until a trip freezes
it. What has no state here (heat, energy, keys, analogue inputs, second status words) reads 0.
"""

from collections.abc import Callable, Mapping
from functools import partial

from fbgen.catalog import Drive
from harness.drives.load import Rating
from harness.drives.operation import Mode, Operation, hours
from harness.drives.registers import Registers
from harness.drives.trips import TripLog
from harness.drives.word_bits import StatusBits

_TENTHS = 10
_CPU_VERSION = 0x0100
_EEPROM_VERSION = 0x0100
_RATED_VOLTAGE_PERCENT = 100.0
_PATTERN_2 = 1
TIMEOUT_ALARM = "communication_timeout"
"""The bit of FC91 for a time-out, by its name in the catalogue."""

_RUN, _DC_BRAKE = Mode.RUN, Mode.DC_BRAKE


class Monitors:
    """Reads any cell of the inverter.

    `alarm` holds the bits of FC91 that are given from outside; `timed_out` the ports whose time-out
    is shown as an alarm.
    """

    __slots__ = (
        "_bits",
        "_emergency",
        "_frozen_copies",
        "_operation",
        "_rating",
        "_readers",
        "_registers",
        "_timeout_alarm",
        "_trips",
        "alarm",
        "dc_voltage_percent",
        "output_terminals",
        "timed_out",
    )

    def __init__(
        self,
        series: Drive,
        registers: Registers,
        operation: Operation,
        trips: TripLog,
        rating: Rating,
    ) -> None:
        self._registers = registers
        self._operation = operation
        self._trips = trips
        self._bits = StatusBits.of(series.word("status"))
        self._emergency = trips.code_of("E")
        alarms = [field for word in series.words if word.name == "alarm" for field in word.bits]
        self._timeout_alarm = sum(field.mask for field in alarms if field.name == TIMEOUT_ALARM)
        self._rating = rating
        self.alarm = 0
        self.timed_out: set[str] = set()
        self.dc_voltage_percent = _RATED_VOLTAGE_PERCENT
        self.output_terminals = 0
        present = self._present()
        self._readers: dict[int, Callable[[], int]] = {
            comno.number: present[comno.name] for comno in series.comnos if comno.name in present
        }
        self._frozen_copies: dict[int, Callable[[], int]] = {
            comno.number: self._reader(registers.number(comno.frozen_copy_of))
            for comno in series.comnos
            if comno.frozen_copy_of is not None
        }
        self._readers.update(self._frozen_copies)

    def read(self, number: int) -> int | None:
        """The word of a cell, None if there is no such cell."""
        frozen = self._trips.frozen
        if number in frozen:
            return frozen[number]
        reader = self._readers.get(number)
        return self._registers.ram.get(number) if reader is None else reader()

    def _reader(self, number: int) -> Callable[[], int]:
        return self._readers.get(number, lambda: self._registers.ram[number])

    def freeze(self) -> Mapping[int, int]:
        """The values now of all monitors that a trip freezes."""
        return {number: reader() for number, reader in self._frozen_copies.items()}

    @property
    def status(self) -> int:
        """The operating status, FD01."""
        bits, operation, trip = self._bits, self._operation, self._trips.code
        wish = operation.wish
        word = bits.standby if not trip else bits.failure | bits.tripped
        if wish.coast:
            word |= bits.coast_stopped
        elif not trip:
            word |= bits.standby_st_on
        if trip and trip == self._emergency:
            word |= bits.emergency_stopped
        if self.alarm or self.timed_out:
            word |= bits.alarm
        if operation.running:
            word |= bits.running
        if operation.reverse:
            word |= bits.reverse
        mode = operation.mode
        if mode is _DC_BRAKE:
            word |= bits.dc_braking
        elif wish.jog and mode is _RUN:
            word |= bits.jog
        if wish.pattern == _PATTERN_2:
            word |= bits.pattern_2
        if wish.pi_control_off:
            word |= bits.pi_control_off
        if wish.motor_2:
            word |= bits.motor_2
        return word

    def _present(self) -> dict[str, Callable[[], int]]:
        """The monitors by their names in the catalogue."""
        operation, trips = self._operation, self._trips
        motor = operation.motor
        readers: dict[str, Callable[[], int]] = {
            "trip_code": lambda: trips.code,
            "alarm": lambda: self.alarm | (self._timeout_alarm if self.timed_out else 0),
            "status": lambda: self.status,
            "output_frequency": lambda: _hundredths(operation.output_hz),
            "frequency_command": lambda: _hundredths(operation.wish.hz),
            "estimated_frequency": lambda: _hundredths(operation.output_hz),
            "feedback_frequency": lambda: _hundredths(operation.shaft_hz),
            "compensated_frequency": lambda: _hundredths(operation.output_hz),
            "command_source": lambda: operation.command_source,
            "frequency_source": lambda: operation.frequency_source,
            "output_current": lambda: _hundredths(operation.current_percent),
            "output_voltage": lambda: _hundredths(motor.voltage_percent(operation.output_hz)),
            "dc_voltage": lambda: _hundredths(self.dc_voltage_percent),
            "torque": lambda: _hundredths(operation.torque_percent),
            "torque_command": lambda: _hundredths(operation.torque_percent),
            "torque_current": lambda: _hundredths(operation.torque_current_percent),
            "exciting_current": lambda: _hundredths(operation.exciting_current_percent),
            "input_power": lambda: _hundredths(self._power_kw()),
            "output_power": lambda: _hundredths(self._power_kw()),
            "load_factor": lambda: round(operation.current_percent),
            "rated_current": lambda: round(self._rating.current_a * _TENTHS),
            "rated_voltage": lambda: round(self._rating.voltage_v * _TENTHS),
            "input_terminals": lambda: operation.words.terminals.word,
            "output_terminals": lambda: self.output_terminals,
            "operation_time": lambda: hours(operation.operated_ns) & 0xFFFF,
            "power_on_time": lambda: hours(operation.powered_ns) & 0xFFFF,
            "cpu1_version": lambda: _CPU_VERSION,
            "cpu2_version": lambda: _CPU_VERSION,
            "eeprom_version": lambda: _EEPROM_VERSION,
        }
        for place in range(len(trips.past)):
            readers[f"past_trip_{place + 1}"] = partial(trips.past.__getitem__, place)
        return readers

    def _power_kw(self) -> float:
        operation = self._operation
        relative = operation.output_hz / operation.motor.base_frequency_hz
        return self._rating.power_at(operation.torque_percent, relative)


def _hundredths(value: float) -> int:
    """A frequency, percentage or the like without its sign in counts of 0.01."""
    return min(0xFFFF, round(abs(value) * 100))
