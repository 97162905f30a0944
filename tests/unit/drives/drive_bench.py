"""A master with inverters on a line, for the tests in this folder."""

from collections.abc import Mapping

from fbgen.catalog import Drive, load_catalog
from fbgen.wire import modbus
from fbgen.wire.toshiba import seal
from harness.drives import Inverter, InverterSettings, Load, ReplyTime, set_for_line
from harness.kernel import NS_PER_MS, NS_PER_S, Kernel
from harness.line import GATEWAY_FORMAT, Line, Reception, Role, Topology

CATALOG = load_catalog()
SERIES = CATALOG.drive("vf-s11")
GATEWAY_SETTINGS = {"baud_rate": 4.0, "parity": 1.0}
"""What the TOSPBDP001 manual, section 6, asks for."""

FIXED_REPLY = ReplyTime(10 * NS_PER_MS, 10 * NS_PER_MS)


class Bench:
    """Asks in hex without 2FH and SUM, and tells what came back the same way.

    `asks_modbus` is the same for MODBUS, without the CRC.
    """

    def __init__(
        self,
        seed: int = 1,
        topology: Topology = Topology.FOUR_WIRE,
        series: Drive | str = SERIES,
        kernel: Kernel | None = None,
    ) -> None:
        self.series = CATALOG.drive(series) if isinstance(series, str) else series
        self.kernel = Kernel(seed) if kernel is None else kernel
        self.line = Line(self.kernel, topology)
        self.port = self.line.attach(self, Role.MASTER, GATEWAY_FORMAT)
        self.heard: list[Reception] = []

    def receive(self, reception: Reception) -> None:
        self.heard.append(reception)

    def add(
        self,
        inv_no: int = 11,
        parameters: Mapping[str, float] | None = None,
        settings: InverterSettings | None = None,
    ) -> Inverter:
        """One more inverter, by default set up as the gateway's manual asks."""
        if settings is None:
            wanted = set_for_line(self.series, None, 19_200, "even")
            wanted |= {"inverter_number": inv_no} | dict(parameters or {})
            settings = InverterSettings(parameters=wanted, reply_time=FIXED_REPLY)
        return Inverter(self.kernel, self.line, self.series, settings)

    def send(self, frame: bytes) -> list[bytes]:
        """Send a whole frame and wait for replies, 40 ms in all."""
        self.heard.clear()
        self.port.transmit(frame)
        self.kernel.run_for(40 * NS_PER_MS)
        return [reception.data for reception in self.heard]

    def ask(self, payload: str) -> str:
        """The reply to a binary request, both without 2FH and SUM; empty for silence."""
        replies = self.send(seal(bytes.fromhex(payload)))
        assert len(replies) <= 1, "more than one reply"
        if not replies:
            return ""
        assert replies[0] == seal(replies[0][1:-1])
        return replies[0][1:-1].hex(" ").upper()

    def ask_modbus(self, payload: str) -> str:
        """The reply to a MODBUS request, both without the CRC; empty for silence."""
        replies = self.send(modbus.seal(bytes.fromhex(payload)))
        assert len(replies) <= 1, "more than one reply"
        if not replies:
            return ""
        assert replies[0] == modbus.seal(replies[0][:-2])
        return replies[0][:-2].hex(" ").upper()

    def wait(self, seconds: float) -> None:
        """Let time pass."""
        self.kernel.run_for(round(seconds * NS_PER_S))


def loaded(torque_percent: float, inv_no: int = 11) -> InverterSettings:
    """Settings of an inverter with a load of constant torque."""
    return InverterSettings(
        parameters=GATEWAY_SETTINGS | {"inverter_number": inv_no},
        load=Load(torque_percent),
        reply_time=FIXED_REPLY,
    )
