"""The command words of an inverter, one a port and one of an option; which of them has priority.

Facts: VF-AS1 RS485 manual E6581315, 8.1: a word commands while its bit 15 is set, and its set-point
counts while its bit 14 is, whatever CMOd and FMOd say; both stay until they are written off, until
power off or a reset. Terminal functions 48, 56 and 58 win over all of it. Bits that act always do
so without bit 15. The second word counts with the first of its port (page 46).

Inferred: if several words have priority, the port that stands first in the catalogue has it; where
CMOd or FMOd say serial communication, that is the first port. An option card inside has FA06 and
FA07 (DEV003Z-1 manual E6581737, pages 19, 26 and 28) and goes before the ports.
"""

from fbgen.catalog import Drive, SerialPort
from fbgen.dataclass import dataclass
from harness.drives.registers import Registers
from harness.drives.terminals import Terminals
from harness.drives.word_bits import NO_SECOND_WORD, CommandBits, SecondBits

SERIAL, OPTION = "serial communication", "communication option"
OPTION_COMMAND, OPTION_SETPOINT = "command_word_option", "frequency_setpoint_option"
_OPTION_CELLS = (OPTION_COMMAND, OPTION_SETPOINT)
_MODES = ("command_mode", "frequency_mode")


@dataclass(frozen=True, slots=True)
class Channel:
    """The cells of one port or option: command word, second one if there is one, set-point."""

    command: int
    second: int | None
    setpoint: str


class CommandWords:
    """What the words in the cells ask for; they are read where they lie."""

    __slots__ = (
        "_always",
        "_modes",
        "_option",
        "_option_modes",
        "_overriding",
        "_registers",
        "_serial",
        "bits",
        "channels",
        "local",
        "second_bits",
        "terminals",
    )

    def __init__(self, series: Drive, registers: Registers, terminals: Terminals) -> None:
        self._registers = registers
        self.terminals = terminals
        word = series.command_word
        self.bits = CommandBits.of(word)
        always = sum(field.mask for field in word.bits if field.always)
        self._always = always & self.bits.coast_stop
        self._overriding = word.overridden_by
        known = series.communication
        ports = () if known is None else known.ports
        self._serial: tuple[Channel, ...] = tuple(_channel(registers, port) for port in ports)
        self._option: Channel | None = _option(series, registers)
        options = () if self._option is None else (self._option,)
        self.channels: tuple[Channel, ...] = (*options, *self._serial)
        self.second_bits = _second_bits(series, self.channels)
        self._modes = {name: _value(registers, name, SERIAL) for name in _MODES}
        self._option_modes = {name: _value(registers, name, OPTION) for name in _MODES}
        self.local = False

    @property
    def overriding(self) -> str | None:
        """The terminal function that wins over the words now, None for none."""
        return self.terminals.acting(self._overriding)

    @property
    def commanding(self) -> Channel | None:
        """Whose run and stop count; None while the panel or the terminals command."""
        return self._with(self.bits.network_command, "command_mode")

    @property
    def setting_frequency(self) -> Channel | None:
        """Whose set-point counts; None while it comes from elsewhere."""
        return self._with(self.bits.network_frequency, "frequency_mode")

    def word_of(self, channel: Channel) -> int:
        """The command word of a port."""
        return self._registers.ram[channel.command]

    def second_word_of(self, channel: Channel) -> int:
        """The second command word of a port, 0 if it has none."""
        return 0 if channel.second is None else self._registers.ram[channel.second]

    @property
    def coasts_always(self) -> bool:
        """Whether a word asks for coasting that acts without any priority."""
        ram, mask = self._registers.ram, self._always
        return mask != 0 and any(ram[channel.command] & mask for channel in self.channels)

    def source(self, name: str, network: bool) -> int:
        """Who commands or sets the frequency at present, in the values of CMOd or FMOd.

        A terminal that forces local control is the terminal board, 0.
        """
        serial = self._modes[name]
        if network and self._option is not None:
            acting = self.commanding if name == "command_mode" else self.setting_frequency
            if acting is self._option:
                return int(self._option_modes[name] or 0)
        if network:
            return 0 if serial is None else int(serial)
        forced = self.local or self.overriding is not None
        return 0 if forced else self._registers.word(name)

    def _with(self, mask: int, mode: str) -> Channel | None:
        if self.local or (self._overriding and self.overriding is not None):
            return None
        ram = self._registers.ram
        for channel in self.channels:
            if ram[channel.command] & mask:
                return channel
        if self._serial and self._is_set_to(mode, self._modes[mode]):
            return self._serial[0]
        return self._option if self._is_set_to(mode, self._option_modes[mode]) else None

    @property
    def given_to_option(self) -> bool:
        """Whether CMOd and FMOd both leave it to an option."""
        return all(self._is_set_to(mode, self._option_modes[mode]) for mode in _MODES)

    def _is_set_to(self, mode: str, value: int | None) -> bool:
        return value is not None and self._registers.word(mode) == value


def _value(registers: Registers, mode: str, text: str) -> int | None:
    """The value of CMOd or FMOd that means this, None where the series does not know it."""
    values = registers.cell(mode).values
    return next((value for value, meaning in values.items() if meaning == text), None)


def _option(series: Drive, registers: Registers) -> Channel | None:
    if all(any(comno.name == name for comno in series.comnos) for name in _OPTION_CELLS):
        return Channel(registers.number(OPTION_COMMAND), None, OPTION_SETPOINT)
    return None


def _channel(registers: Registers, port: SerialPort) -> Channel:
    second = None if port.command_2 is None else registers.number(port.command_2)
    return Channel(registers.number(port.command), second, port.setpoint)


def _second_bits(series: Drive, channels: tuple[Channel, ...]) -> SecondBits:
    for channel in channels:
        if channel.second is not None:
            word = series.comno(channel.second).word
            if word is not None:
                return SecondBits.of(series.word(word))
    return NO_SECOND_WORD
