"""The command words of an inverter, one a port, and which of them has priority.

Facts: VF-AS1 RS485 manual E6581315, 8.1: a word commands while its bit 15 is set, and its set-point
counts while its bit 14 is, whatever CMOd and FMOd say; both stay until they are written off, until
power off or a reset. Terminal functions 48, 56 and 58 win over all of it. Bits that act always do
so without bit 15. The second word counts with the first of its port (page 46).

Inferred: if several words have priority, the port that stands first in the catalogue has it; where
CMOd or FMOd say serial communication, that is the first port.
"""

from fbgen.catalog import Drive, SerialPort
from fbgen.dataclass import dataclass
from harness.drives.registers import Registers
from harness.drives.terminals import Terminals
from harness.drives.word_bits import NO_SECOND_WORD, CommandBits, SecondBits

SERIAL = "serial communication"


@dataclass(frozen=True, slots=True)
class Channel:
    """The cells of one port: command word, second command word if there is one, set-point."""

    command: int
    second: int | None
    setpoint: str


class CommandWords:
    """What the words in the cells ask for; they are read where they lie."""

    __slots__ = (
        "_always",
        "_modes",
        "_overriding",
        "_registers",
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
        self.channels = tuple(_channel(registers, port) for port in ports)
        self.second_bits = _second_bits(series, self.channels)
        self._modes = {
            name: next(
                (value for value, text in registers.cell(name).values.items() if text == SERIAL),
                None,
            )
            for name in ("command_mode", "frequency_mode")
        }
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
        serial = self._modes[mode]
        if serial is not None and self._registers.word(mode) == serial and self.channels:
            return self.channels[0]
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
