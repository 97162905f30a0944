"""A simulated inverter on its lines: everything a master, a scenario or a fault can see of it.

It knows nothing of gateways. The series in the catalogue says which cells, words, trips and times
it has; `operation` moves the motor, `communication` is a port, `registers` remember.
Facts: VF-S11 communications manual E6581222; VF-AS1 RS485 manual E6581315; TOSPBDP001 manual,
sections 6 to 9. What happens to a trip at power off (it is gone, the past trips stay) is inferred.
"""

from collections.abc import Callable
from typing import Literal

from fbgen.catalog import Drive, SerialPort
from fbgen.diagnostics import DiagnosticError, error
from fbgen.wire.toshiba import ErrorCode
from harness.drives import inter_drive, operation
from harness.drives.command_words import CommandWords
from harness.drives.communication import Communication
from harness.drives.device import Owner
from harness.drives.load import Load
from harness.drives.monitors import Monitors
from harness.drives.new_inverter import check_complete, delivered, not_taken
from harness.drives.operation import Operation, Panel
from harness.drives.registers import Registers
from harness.drives.settings import InverterSettings
from harness.drives.speakers import check_protocols
from harness.drives.terminals import FUNCTION_OF, Terminals
from harness.drives.trips import TripLog
from harness.kernel import Kernel
from harness.line import Line

EMERGENCY_STOP = "E"
_DEFAULTS, _AS_NEW = "factory_setting", 3
COMMUNICATION_ERROR = "Err5"


class Inverter:
    """One inverter. It has been on for a while when it is made: it listens at once.

    Functions in `observers` are called when what it is told or what it does may have changed; a
    frequency on its way along a ramp changes without a word.
    """

    __slots__ = (
        "_acts",
        "_emergency_code",
        "_emergency_terminal",
        "_kernel",
        "_settings",
        "_timeout_code",
        "communication",
        "monitors",
        "name",
        "observers",
        "operation",
        "ports",
        "powered",
        "registers",
        "series",
        "terminals",
        "trips",
    )

    def __init__(
        self,
        kernel: Kernel,
        line: Line,
        series: Drive,
        settings: InverterSettings = InverterSettings(),  # noqa: B008 - frozen
    ) -> None:
        """Raises DiagnosticError FB7101 for parameters that the series would not take.

        FB7104 for a series without a port, or one that it does not have, or told to speak a
        protocol that it does not.
        FB7102 and FB7103 if the series lacks trips or ComNos that the simulation stands on.
        """
        check_complete(series)
        self.series = series
        self.name = settings.name
        self.powered = True
        self.observers: list[Callable[[], None]] = []
        self._emergency_terminal = False
        self.registers = Registers(series, delivered(series, settings))
        check_protocols(series, self.registers)
        self.trips = TripLog(series)
        self.terminals = Terminals(series, self.registers)
        words = CommandWords(series, self.registers, self.terminals)
        self.operation = Operation(kernel, self.registers, words, settings.motor, settings.load)
        self._acts = self._what_acts()
        self.monitors = Monitors(
            series, self.registers, self.operation, self.trips, settings.rating
        )
        self._timeout_code = self.trips.code_of(COMMUNICATION_ERROR)
        self._emergency_code = self.trips.code_of(EMERGENCY_STOP)
        self._kernel = kernel
        self._settings = settings
        self.ports: dict[str, Communication] = {}
        self.communication = self.connect(settings.port, line)

    def connect(self, port: str | None, line: Line) -> Communication:
        """Connect one more port to a line, by its name in the catalogue; None is the first.

        DiagnosticError FB7104 if the series has no such port, or it is connected already.
        """
        known = self.series.communication
        assert known is not None, "checked when the inverter was made"
        facts = known.ports[0] if port is None else known.port(port)
        if facts is None or facts.name in self.ports:
            names = ", ".join(item.name for item in known.ports if item.name not in self.ports)
            raise error(
                "FB7104",
                f"an inverter of the series '{self.series.id}' has no free port '{port}'",
                self.series.span,
                f"free ports: {names or 'none'}",
            )
        owner = Owner(self.series, self.registers, self)
        connected = Communication(self._kernel, line, owner, facts, self._settings)
        self.ports[facts.name] = connected
        return connected

    # What a scenario reads

    @property
    def frequency_hz(self) -> float:
        """Output frequency now, without direction."""
        return abs(self.operation.output_hz)

    @property
    def set_point_hz(self) -> float:
        """The frequency that is commanded, within the limits."""
        return self.operation.wish.hz

    @property
    def shaft_hz(self) -> float:
        """Speed of the shaft as a frequency, negative in reverse."""
        return self.operation.shaft_hz

    @property
    def running(self) -> bool:
        """True while the output turns the motor, ramping down included."""
        return self.operation.running

    @property
    def direction(self) -> Literal["forward", "reverse"]:
        """Direction of rotation; at rest the one that is commanded."""
        return "reverse" if self.operation.reverse else "forward"

    @property
    def moving_until_ns(self) -> int:
        """Instant at which the frequency is where it goes to; the past while it stands."""
        return self.operation.moving_until_ns

    @property
    def told_to_run(self) -> bool:
        """True while it is told to run, by whoever has the command."""
        return self.operation.wish.run

    @property
    def given_to_option(self) -> bool:
        """Whether CMOd and FMOd both leave it to a communication option."""
        return self.operation.words.given_to_option

    @property
    def reverse(self) -> bool:
        """Direction of rotation; at rest the one that is commanded."""
        return self.operation.reverse

    @property
    def network_command(self) -> bool:
        """True while run and stop come from the network."""
        return self.operation.network_command

    @property
    def network_frequency(self) -> bool:
        """True while the set-point comes from the network."""
        return self.operation.network_frequency

    @property
    def current_percent(self) -> float:
        """Output current in percent of the rated current."""
        return self.operation.current_percent

    @property
    def torque_percent(self) -> float:
        """Torque of the motor in percent of its rated torque."""
        return self.operation.torque_percent

    @property
    def tripped(self) -> bool:
        """True from a trip to the reset."""
        return self.trips.code != 0

    @property
    def trip_code(self) -> int:
        """The code in FC90, 0 without a trip."""
        return self.trips.code

    @property
    def trip_display(self) -> str:
        """The trip as the panel shows it, such as Err5; empty without one."""
        return self.trips.display

    @property
    def inv_no(self) -> int:
        """INV-NO to which the inverter listens."""
        return self.communication.inv_no

    # What a scenario does

    @property
    def load(self) -> Load:
        """The driven machine; may be exchanged at any time."""
        return self.operation.load

    @load.setter
    def load(self, load: Load) -> None:
        self.operation.load = load
        self._changed()

    @property
    def panel(self) -> Panel:
        """The local commands as they are; `set_panel` changes them."""
        return self.operation.panel

    def set_panel(self, panel: Panel) -> None:
        """Command from the panel or the terminals: counts while the network has no priority."""
        self.operation.panel = panel
        self._follow()
        self._changed()

    def switch_to_local(self, local: bool) -> None:
        """Switch it at a terminal to local control, or back to what CMOd and the network say."""
        self.operation.words.local = local
        self._follow()
        self._changed()

    def switch_terminal(self, name: str, on: bool) -> None:
        """Switch an input terminal, such as s1. FB7105 for one that the series does not have."""
        self.terminals.switch(name, on)
        self._follow()
        self._changed()

    @property
    def emergency_terminal(self) -> bool:
        """True while the emergency stop at the terminals is open: it trips, and a reset is in vain.

        TOSPBDP001 manual v1.1, section 7: the RES input as inverted EXTN.
        """
        return self._emergency_terminal

    @emergency_terminal.setter
    def emergency_terminal(self, is_open: bool) -> None:
        self._emergency_terminal = is_open
        if is_open:
            self._trip(self._emergency_code)

    def read_parameter(self, key: str | int) -> float:
        """The value of a ComNo in its unit, as a read over the line gives it. FB1105 if unknown."""
        comno = self.series.comno(key)
        return comno.to_value(self.read_word(comno.number))

    def read_word(self, key: str | int) -> int:
        """The word of a ComNo as a read over the line gives it. FB1105 if unknown."""
        word = self.monitors.read(self.series.comno(key).number)
        assert word is not None, "every ComNo of the catalogue has a cell"
        return word

    def set_parameter(self, key: str | int, value: float) -> None:
        """Set a parameter at the panel, which stores it in the EEPROM.

        Raises DiagnosticError FB1105 for an unknown one, FB7101 if the inverter does not take it.
        """
        comno = self.series.comno(key)
        word = comno.to_word(value)
        refused = self.write_eeprom(comno.number, word)
        if refused is not None:
            raise DiagnosticError([not_taken(comno, value, refused)])

    def trip(self, display: str) -> None:
        """Let a trip come, by what the panel shows of it, such as OC1. FB7102 if unknown."""
        self._trip(self.trips.code_of(display))

    def reset(self) -> None:
        """Reset a trip at the panel: the inverter restarts, network control is lost."""
        if self.powered and self.tripped:
            self._restart(self.series.times.reset_silence.ns)

    def power_off(self) -> None:
        """Take the supply away; a reply in progress breaks off."""
        self.powered = False
        for port in self.ports.values():
            port.stop()
        self.operation.supply(False)
        self._changed()

    def power_on(self) -> None:
        """Give the supply back; the inverter is silent while it boots."""
        if not self.powered:
            self.powered = True
            self.operation.supply(True)
            self._restart(self.series.times.boot.ns)

    # What the communication asks for

    def read(self, number: int) -> int | None:
        """The word of a cell, None if there is none."""
        return self.monitors.read(number)

    def writable(self, number: int) -> bool:
        """Whether a cell is there and not for reading alone."""
        comno = self.registers.cells.get(number)
        return comno is not None and "w" in comno.access

    def write_ram(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell until the next restart; why it is refused, or None."""
        refused = self.registers.refusal(number, word, self.running)
        if refused is None:
            self.registers.write_ram(number, word)
            self._written(number)
        return refused

    def write_eeprom(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell for good; why it is refused, or None."""
        refused = self.registers.refusal(number, word, self.running)
        if refused is None:
            refused = self.registers.write_eeprom(number, word)
        if refused is None:
            self._written(number)
        return refused

    def follow(self, port: SerialPort, number: int, word: int, master_tripped: bool) -> None:
        """Take a value of the commands S and s, as the role of the port in drive to drive has it.

        Only the set-point of the port is scaled. What is out of range is dropped: nobody answers.
        """
        role = inter_drive.role_of(self.series, port, self.registers)
        if role is not None and role.sends is not None:
            return
        if master_tripped and role is not None and role.on_master_trip == "trip":
            self._trip(self._emergency_code)
            return
        if number != self.registers.number(port.setpoint):
            self.write_ram(number, word)
            return
        scaled = inter_drive.set_point_word(self.series, port, self.registers, word)
        stands = master_tripped and role is not None and role.on_master_trip == "zero"
        self.registers.write_ram(number, 0 if stands else scaled)
        self._written(number)

    def time_out(self, port: SerialPort) -> None:
        """No telegram came to a port within the time of F803: what F804 says of it."""
        action = "trip"
        if port.timeout_action is not None and port.timeout_actions:
            action = port.timeout_actions.get(self.registers.word(port.timeout_action), "nothing")
        if action == "trip":
            self._trip(self._timeout_code)
        elif action == "alarm":
            self.monitors.timed_out.add(port.name)
            self._changed()

    def heard(self, port: SerialPort) -> None:
        """A telegram has come again to a port that had been in time-out: its alarm goes."""
        self.monitors.timed_out.discard(port.name)
        self._changed()

    # Inside

    def _what_acts(self) -> dict[int, Callable[[int], None]]:
        """What happens when a ComNo is written, for those that act at once."""
        known, number = self.series.communication, self.registers.number
        ports = () if known is None else known.ports
        names = {comno.name for comno in self.series.comnos}
        channels = self.operation.words.channels
        followed = {*operation.PARAMETERS, *(channel.setpoint for channel in channels)}
        followed |= {port.command_2 for port in ports if port.command_2 is not None}
        followed |= {name for name in operation.MORE_RAMPS if name in names}
        followed |= {name for name in names if name.startswith(FUNCTION_OF)}
        acts: dict[int, Callable[[int], None]] = dict.fromkeys(
            map(number, followed), self._parameter
        )
        for channel in channels:
            acts[channel.command] = self._command
        for port in ports:
            acts[number(port.inv_no)] = self._number_changed
            acts[number(port.timeout)] = self._timeout_changed
            if port.inter_drive is not None:
                acts[number(port.inter_drive)] = self._inter_drive_changed
        if _DEFAULTS in names:
            acts[number(_DEFAULTS)] = self._set_defaults
        return acts

    def _written(self, number: int) -> None:
        act = self._acts.get(number)
        if act is not None:
            act(number)
        self._changed()

    def _parameter(self, number: int) -> None:
        self._follow()

    def _number_changed(self, number: int) -> None:
        for port in self.ports.values():
            port.number_changed()

    def _timeout_changed(self, number: int) -> None:
        for port in self.ports.values():
            port.timeout_changed()

    def _inter_drive_changed(self, number: int) -> None:
        for port in self.ports.values():
            port.inter_drive_changed()

    def _set_defaults(self, number: int) -> None:
        """TYP: as new, and started anew; nobody gets a reply."""
        if self.registers.ram[number] == _AS_NEW:
            self.registers.factory_setting()
            self._restart(self.series.times.reset_silence.ns)

    def _command(self, number: int) -> None:
        command = self.registers.ram[number]
        bits = self.operation.words.bits
        if command & bits.fault_reset:
            self._restart(self.series.times.reset_silence.ns)
            return
        if command & bits.emergency_stop:
            self._trip(self._emergency_code)
        self._follow()

    def _follow(self) -> None:
        if self.powered and not self.tripped:
            self.operation.evaluate()

    def _trip(self, code: int) -> None:
        if self.powered and not self.tripped:
            self.trips.latch(code, self.monitors.freeze())
            self.operation.stop_output()
            self._changed()

    def _restart(self, silence_ns: int) -> None:
        self.trips.reset()
        self.monitors.timed_out.clear()
        self.registers.restart()
        self.operation.restart()
        for port in self.ports.values():
            port.restart(silence_ns)
        if self._emergency_terminal:
            self._trip(self._emergency_code)
        self._changed()

    def _changed(self) -> None:
        for observer in self.observers:
            observer()
