"""A simulated plant as a whole: PLC, PROFIBUS, gateways, lines and inverters on one clock."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from fbgen.catalog import Catalog
from fbgen.plant import Plant
from harness.drives import Inverter
from harness.fieldbus import DpMaster, Station
from harness.gateways.tospbdp001 import Memory, Tospbdp001
from harness.installation.holds import Holds
from harness.kernel import Kernel
from harness.line import Line, Spacing
from harness.plc import Cpu
from harness.trace.recorder import Recorder
from harness.trace.telegrams import TelegramRecorder


@dataclass(frozen=True, slots=True)
class Installation:
    """Everything that was built from one plant file.

    Gateways, stations (the gateways as the master sees them) and lines go by the gateway's name,
    drives by their own. `plan` is the plant file. `spacing` notes telegrams to different drives
    that follow each other too closely; `memories` has what is in gateways at the start, and the PLC
    starts `start_after_ns` later than they; `holds` knows what faults hold.
    """

    plan: Plant
    catalog: Catalog
    kernel: Kernel
    cpu: Cpu
    master: DpMaster
    gateways: Mapping[str, Tospbdp001]
    stations: Mapping[str, Station]
    lines: Mapping[str, Line]
    drives: Mapping[str, Inverter]
    spacing: Mapping[str, Spacing]
    memories: Mapping[str, Memory] = field(default_factory=dict)
    start_after_ns: int = 0
    holds: Holds = field(default_factory=Holds)

    def start(self) -> None:
        """Switch the gateways on and start the CPU; drives have their supply already."""
        for name, gateway in self.gateways.items():
            gateway.power_on(self.memories.get(name))
        self.kernel.run_for(self.start_after_ns)
        self.cpu.start()

    def run_for(self, duration_ns: int) -> None:
        """Let `duration_ns` of the plant's time pass."""
        self.kernel.run_for(duration_ns)

    def record(self, variables: Iterable[str] = ()) -> Recorder:
        """Record everything from now on; `finish` of what this gives is the trace.

        `variables` are paths of the PLC beside those of TOS_Plant. Raises DiagnosticError for
        variables that the PLC does not have.
        """
        return Recorder(self, variables)

    def record_telegrams(self) -> dict[str, TelegramRecorder]:
        """Listen to every gateway from now on; by the gateway's name."""
        return {
            entry.name: TelegramRecorder(
                self.master,
                self.stations[entry.name],
                self.lines[entry.name],
                self.gateways[entry.name].port,
                self.catalog.gateway(entry.type).layout(entry.layout),
                processing_ns=self.gateways[entry.name].settings.processing_ns,
            )
            for entry in self.plan.gateways
        }
