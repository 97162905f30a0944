"""A DP master that others wrote (pyprofibus), at a pseudo terminal with our server behind it.

Both run in turns in one thread. Time passes for the slave as it does for the master; `skip_ms`
moves the slave's clock alone, so that a watchdog expires without waiting.
"""

from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from time import monotonic, monotonic_ns
from unittest.mock import patch

from pyprofibus import dp_master
from pyprofibus.dp import (
    DpCfgDataElement,
    DpError,
    DpTelegram_GlobalControl,
    DpTelegram_SlaveDiag_Con,
    DpTelegram_SlaveDiag_Req,
)
from pyprofibus.dp_master import DPM1, DpSlaveDesc
from pyprofibus.fdl import FdlFCB
from pyprofibus.phy import CpPhy
from pyprofibus.phy_serial import CpPhySerial

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from fbgen.resources import shipped
from harness.fieldbus import DpSlave, Segment
from harness.gateways.tospbdp001 import CyclicLayout, Tospbdp001
from harness.kernel import NS_PER_MS, Kernel
from harness.serial import PseudoTerminal, Server, gateways_to_serve

IDENT = 0x1803
PATIENCE_S = 20.0
"""Far longer than anything takes, on a machine that has much else to do."""
MASTER, SLAVE = 1, 2
WATCHDOG_MS = 10_000
"""So long that it never expires because the machine has much else to do."""


class ForeignMaster:
    """pyprofibus as DP master class 1 with one slave."""

    def __init__(self, port: str, configuration: bytes, sizes: tuple[int, int], ident: int) -> None:
        self.phy = CpPhySerial(port)
        self.phy.setConfig(CpPhy.BAUD_9600)
        # How long the master lets the bus rest. Not the port's own speed, of which there is none.
        CpPhy.setConfig(self.phy, CpPhy.BAUD_12000000)
        self.dpm = DPM1(self.phy, MASTER)
        self.slave = DpSlaveDesc()
        self.slave.slaveAddr = SLAVE
        self.slave.setPrmTelegram.da = self.slave.chkCfgTelegram.da = SLAVE
        self.slave.setPrmTelegram.identNumber = ident
        self.slave.inputSize, self.slave.outputSize = sizes
        self.slave.setCfgDataElements([DpCfgDataElement(byte) for byte in configuration])
        self.slave.setSyncMode(True)
        self.slave.setFreezeMode(True)
        self.slave.setWatchdog(WATCHDOG_MS)
        self.dpm.addSlave(self.slave)
        # It would look through all that the tests have in memory, which takes seconds.
        with patch.object(dp_master, "gc"):
            self.dpm.initialize()

    def run(self, outputs: bytes) -> bytes | None:
        """One turn; gives the inputs if some came. A slave that refuses is asked again."""
        self.slave.setMasterOutData(outputs)
        try:
            self.dpm.run()
        except DpError:
            return None
        inputs = self.slave.getMasterInData()
        return None if inputs is None else bytes(inputs)

    def global_control(self, command: int) -> None:
        telegram = DpTelegram_GlobalControl(da=127, sa=MASTER)
        telegram.controlCommand = command
        self.dpm.dpTrans.send(fcb=FdlFCB(), telegram=telegram)


class Interplay:
    """The master and the server with a slave, `sizes` being its outputs and inputs."""

    def __init__(
        self,
        kernel: Kernel,
        slave: DpSlave,
        configuration: bytes,
        sizes: tuple[int, int],
        ident: int,
    ) -> None:
        self.slave = slave
        self.segment = Segment(kernel, [slave])
        self.skipped_ns = 0
        self.port = PseudoTerminal()
        self.server = Server(
            kernel, self.segment, self.port, lambda: monotonic_ns() + self.skipped_ns
        )
        self.outputs = bytes(sizes[0])
        self.inputs = b""
        self.master = ForeignMaster(self.port.name, configuration, sizes, ident)

    def close(self) -> None:
        self.master.dpm.destroy()
        self.port.close()

    def skip_ms(self, milliseconds: int) -> None:
        self.skipped_ns += milliseconds * NS_PER_MS
        self.server.step()

    def until(self, reached: Callable[[bytes], bool]) -> None:
        """Run until this is so for the latest inputs; an AssertionError if it never is."""
        end_s = monotonic() + PATIENCE_S
        while not reached(self.inputs):
            assert monotonic() < end_s, f"inputs {self.inputs.hex()}, {self.slave.state}"
            self.inputs = self.master.run(self.outputs) or self.inputs
            self.server.step()

    def diagnosis(self) -> DpTelegram_SlaveDiag_Con:
        """Slave_Diag as the master reads it, fetched out of turn."""
        request = DpTelegram_SlaveDiag_Req(da=SLAVE, sa=MASTER)
        self.master.phy.releaseBus()
        self.master.dpm.dpTrans.send(fcb=FdlFCB(), telegram=request)
        end_s = monotonic() + PATIENCE_S
        while monotonic() < end_s:
            self.server.step()
            _, answer = self.master.dpm.dpTrans.poll()
            if DpTelegram_SlaveDiag_Con.checkType(answer):
                return answer
        raise AssertionError("no diagnosis")

    def exchanges(self, count: int = 5) -> None:
        """So many more answers with inputs."""
        answered = 0
        end_s = monotonic() + PATIENCE_S
        while answered < count:
            assert monotonic() < end_s, self.slave.state
            answered += self.master.run(self.outputs) is not None
            self.server.step()


class GatewayInterplay(Interplay):
    """The TOSPBDP001 of the manual's example with its inverter, as it is served."""

    def __init__(self, layout: str, configuration: bytes | None, ident: int) -> None:
        catalog = load_catalog()
        plan = load_plant(shipped("examples") / "manual_example" / "plant.yaml", catalog)
        entry = plan.gateways[0].model_copy(update={"layout": layout})
        served = gateways_to_serve(plan.model_copy(update={"gateways": (entry,)}), catalog)
        gateway = served.devices.gateways[entry.name]
        assert isinstance(gateway, Tospbdp001)
        self.gateway = gateway
        self.drive = served.devices.drives["drive11"]
        self.layout: CyclicLayout = gateway.settings.layout
        sizes = (self.layout.output_length, self.layout.input_length)
        configuration = configuration or self.layout.configuration
        super().__init__(served.kernel, gateway.slave, configuration, sizes, ident)

    def telegram(self, text: str) -> None:
        """The nine bytes of the manual into the outputs, in the layout's places."""
        printed = bytes.fromhex(text.replace("xx", "00"))
        outputs = bytearray(self.layout.output_length)
        outputs[:3], rest = printed[:3], printed[3:]
        for start, end in self.layout.telegram:
            outputs[start:end], rest = rest[: end - start], rest[end - start :]
        self.outputs = bytes(outputs)


@contextmanager
def interplay(
    layout: str = "gsd10", configuration: bytes | None = None, ident: int = IDENT
) -> Iterator[GatewayInterplay]:
    """Both sides, closed afterwards."""
    with closing(GatewayInterplay(layout, configuration, ident)) as both:
        yield both
