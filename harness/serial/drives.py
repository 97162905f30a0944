"""Inverters on a line of their own, for a master at a port that is none of ours."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field

from fbgen.catalog import Drive, SerialPort
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.wire.line_protocols import LINE_PROTOCOLS, LineProtocol
from harness.drives import Inverter, InverterSettings, ReplyTime
from harness.installation.holds import Hold, Holds
from harness.kernel import Kernel
from harness.line import Line, Parity, Role, SerialFormat, Topology
from harness.serial.bridge import LineBridge
from harness.serial.line_log import LineLog
from harness.serial.ports import Port

LINE = "line"
"""What the line is called for which there is one name only."""
MASTER_STOP_BITS, DRIVE_STOP_BITS = 1, 2
"""VF-S11 communications manual E6581222, p. 4: a drive sends two, and needs to receive one."""


@dataclass(frozen=True, slots=True)
class DriveToServe:
    """One inverter: its name, its number, and what differs from a new one, by ComNo or name.

    `port` is the one that is wired, of a series that has several; None for the first.
    """

    name: str
    series: Drive
    inv_no: int
    parameters: Mapping[str, float] = field(default_factory=dict)
    reply_time: ReplyTime = field(default_factory=ReplyTime)
    port: str | None = None


@dataclass(frozen=True, slots=True)
class LineSetting:
    """How the line is set: the protocol, bit/s and parity of all its inverters."""

    protocol: str
    baud: int
    parity: Parity

    @property
    def from_master(self) -> SerialFormat:
        """The characters of a master."""
        return SerialFormat(self.baud, self.parity, MASTER_STOP_BITS)

    @property
    def from_drives(self) -> SerialFormat:
        """The characters of inverters."""
        return SerialFormat(self.baud, self.parity, DRIVE_STOP_BITS)


@dataclass(frozen=True, slots=True)
class ServedDrives:
    """The inverters of a line with the bridge to their master. It is a `FieldLevel` for faults."""

    kernel: Kernel
    line: Line
    setting: LineSetting
    drives: Mapping[str, Inverter]
    bridge: LineBridge
    log: LineLog
    holds: Holds = field(default_factory=Holds)

    @property
    def lines(self) -> Mapping[str, Line]:
        """The one line there is."""
        return {LINE: self.line}

    def neighbours(self, drive: str) -> Sequence[str]:
        """All the others."""
        return tuple(name for name in self.drives if name != drive)

    def gets_telegrams(self, drive: str) -> bool:
        """All of them."""
        return True

    def cable(self, drive: str) -> Iterable[Hold[bool]]:
        """A drive on a line has its supply from elsewhere."""
        return ()


def line_setting(
    drives: Sequence[Drive],
    protocol: str | None,
    baud: int | None,
    parity: Parity | None,
    wired: str | None = None,
) -> LineSetting:
    """The setting of a line with inverters of these series.

    It is what is asked for, else what a new inverter of the first series has. `wired` is as in
    `DriveToServe`.

    Raises DiagnosticError FB9035 for what one of the series does not have.
    """
    series = drives[0]
    port = serial_port_of(series, wired)
    rate = series.baud_rates(port).get(series.comno(port.baud_rate).default_word, 9_600)
    kind = series.parities(port).get(series.comno(port.parity).default_word, "even")
    setting = LineSetting(protocol or series.protocol, baud or rate, parity or Parity[kind.upper()])
    found = [
        problem
        for one in {item.id: item for item in drives}.values()
        for problem in _problems(one, setting, wired)
    ]
    if found:
        raise DiagnosticError(found)
    return setting


def serial_port_of(series: Drive, wired: str | None = None) -> SerialPort:
    """The port of a series that a line is connected to, by its name; None for the first.

    Raises DiagnosticError FB9035 if there is none.
    """
    ports = series.communication.ports if series.communication is not None else ()
    if not ports:
        raise error(
            "FB9035",
            f"the catalogue knows no serial port of '{series.id}'",
            series.span,
            "add communication: with ports:, as vf-s11.yaml has it",
        )
    found = next((port for port in ports if wired in (None, port.name)), None)
    if found is None:
        names = [port.name for port in ports]
        raise error(
            "FB9035", f"'{series.id}' has no port '{wired}'", None, nearest(wired or "", names)
        )
    return found


def serve_drives(
    drives: Sequence[DriveToServe],
    setting: LineSetting,
    port: Port,
    *,
    byte_times: bool,
    seed: int = 0,
) -> ServedDrives:
    """The inverters with their line, switched on.

    Raises DiagnosticError of `Inverter` for what a series or its simulation does not have.
    """
    kernel = Kernel(seed)
    wires = [serial_port_of(item.series, item.port).wires for item in drives]
    line = Line(kernel, Topology.TWO_WIRE if 2 in wires else Topology.FOUR_WIRE)
    bridge = LineBridge(
        *(kernel, line, port, Role.MASTER, setting.from_master), byte_times=byte_times
    )
    log = LineLog(kernel, line, protocol_of(setting), bridge.node)
    made: dict[str, Inverter] = {}
    for item in drives:
        drive = Inverter(kernel, line, item.series, _settings(item, setting))
        log.add(item.name, drive.communication.port)
        made[item.name] = drive
    return ServedDrives(kernel, line, setting, made, bridge, log)


def protocol_of(setting: LineSetting) -> LineProtocol:
    """How frames are found on the line."""
    return LINE_PROTOCOLS[setting.protocol]


def _settings(item: DriveToServe, setting: LineSetting) -> InverterSettings:
    series = item.series
    port = serial_port_of(series, item.port)
    rates, parities = series.baud_rates(port), series.parities(port)
    parameters: dict[str, float] = {
        port.baud_rate: _value_of(rates, setting.baud),
        port.parity: _value_of(parities, setting.parity.name.lower()),
        port.inv_no: item.inv_no,
    }
    if port.protocol is not None:
        parameters[port.protocol] = _value_of(port.protocols, setting.protocol)
    return InverterSettings(
        name=item.name,
        parameters=parameters | dict(item.parameters),
        reply_time=item.reply_time,
        port=port.name,
    )


def _value_of(meanings: Mapping[int, object], wanted: object) -> int:
    return next(value for value, meaning in meanings.items() if meaning == wanted)


def _problems(series: Drive, setting: LineSetting, wired: str | None) -> Iterator[Diagnostic]:
    port = serial_port_of(series, wired)
    rates, parities = series.baud_rates(port), series.parities(port)
    parity = setting.parity.name.lower()
    for what, wanted, known in (
        ("the protocol", setting.protocol, tuple(port.protocols.values())),
        ("the speed", setting.baud, tuple(rates.values())),
        ("the parity", parity, tuple(parities.values())),
    ):
        if wanted not in known:
            yield Diagnostic(
                "FB9035",
                f"'{series.id}' does not have {what} {wanted}",
                None,
                f"take one of {', '.join(map(str, known))}",
            )
