"""A slave whose device only notes what it is told, at the end of a cable."""

from fbgen.wire.dp import MASTER_SAP, SlaveSap
from fbgen.wire.fdl import (
    DataTelegram,
    RequestFunction,
    Telegram,
    decode,
    encode,
    request_control,
)
from fbgen.wire.profibus import decode_identifiers, input_length, output_length
from harness.fieldbus import DpSlave, Lock, Parameters, Segment, SlaveType
from harness.kernel import NS_PER_MS, Kernel

IDENT = 0x1234
CONFIGURATION = bytes.fromhex("A3 91 30")
ADDRESS = 7
ZEROS = bytes(5)
GOOD = Parameters(IDENT, (1, 10), 0x02)
UNLOCK = Parameters(IDENT, None, lock=Lock.UNLOCK)
NEITHER = Parameters(IDENT, None, lock=Lock.NEITHER)
NO_SERVICE = 0x03
SRD = request_control(RequestFunction.SRD_HIGH)


class NotedDevice:
    """4 consistent bytes out, 2 in, and a byte both ways."""

    def __init__(self) -> None:
        self.told: list[str] = []

    def exchange_started(self) -> None:
        self.told.append("started")

    def exchange_lost(self) -> None:
        self.told.append("lost")

    def outputs_received(self, outputs: bytes) -> None:
        self.told.append(outputs.hex())


class WireBench:
    """Requests in, answers out; `watchdog` of 100 ms once there are parameters."""

    def __init__(self, kind: SlaveType | None = None) -> None:
        self.kernel = Kernel()
        self.device = NotedDevice()
        kind = kind or SlaveType(IDENT, CONFIGURATION)
        modules = decode_identifiers(kind.configuration)
        sizes = (output_length(modules), input_length(modules))
        self.slave = DpSlave(self.kernel, self.device, kind, ADDRESS, sizes)
        self.segment = Segment(self.kernel, [self.slave])
        self.slave.power_on(ADDRESS)

    def octets(self, data: bytes) -> bytes:
        return self.segment.receive(data)

    def telegram(self, telegram: Telegram) -> Telegram | None:
        answer = self.octets(encode(telegram))
        return decode(answer) if answer else None

    def ask(
        self,
        sap: int | None,
        data: bytes = b"",
        master: int = 1,
        control: int = SRD,
        address: int = ADDRESS,
    ) -> Telegram | None:
        source_sap = None if sap is None else MASTER_SAP
        return self.telegram(DataTelegram(address, master, control, data, sap, source_sap))

    def set_prm(self, parameters: Parameters = GOOD, master: int = 1) -> Telegram | None:
        return self.ask(SlaveSap.SET_PRM, parameters.encode(), master)

    def chk_cfg(self, configuration: bytes = CONFIGURATION, master: int = 1) -> Telegram | None:
        return self.ask(SlaveSap.CHK_CFG, configuration, master)

    def exchange(self, outputs: bytes = ZEROS, master: int = 1) -> Telegram | None:
        return self.ask(None, outputs, master)

    def diagnosis(self, master: int = 1) -> bytes:
        answer = self.ask(SlaveSap.SLAVE_DIAG, master=master)
        assert isinstance(answer, DataTelegram)
        return answer.data

    def global_control(self, command: int, groups: int = 0, master: int = 1) -> None:
        control = request_control(RequestFunction.SDN_HIGH)
        data = bytes((command, groups))
        assert self.ask(SlaveSap.GLOBAL_CONTROL, data, master, control, 127) is None

    def running(self) -> "WireBench":
        """In data exchange with master 1."""
        self.set_prm()
        self.chk_cfg()
        self.exchange()
        self.device.told.clear()
        return self

    def run_ms(self, milliseconds: float) -> None:
        self.kernel.run_for(round(milliseconds * NS_PER_MS))


def is_refused(answer: Telegram | None) -> bool:
    """Whether a slave says that it has no such service, not now, or not for this master."""
    return isinstance(answer, DataTelegram) and (answer.control, answer.unit) == (NO_SERVICE, b"")
