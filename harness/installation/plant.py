"""A simulated plant as a whole: PLC, PROFIBUS, gateways, lines and inverters on one clock."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.plant import Plant, PlantGateway, layout_of
from harness.drives import Inverter
from harness.fieldbus import DpMaster, Station
from harness.gateways.dev003z import Dev003z
from harness.gateways.pbdp110 import Pbdp110
from harness.gateways.tospbdp001 import Memory, Tospbdp001
from harness.installation.devicenet import DeviceNet
from harness.installation.devices import FieldDevices
from harness.installation.holds import Hold, Holds, attribute, switched
from harness.kernel import Kernel
from harness.line import Line, Spacing
from harness.plc import Cpu

if TYPE_CHECKING:
    from harness.trace.recorder import Recorder
    from harness.trace.telegrams import TelegramRecorder


@dataclass(frozen=True, slots=True)
class Installation:
    """Everything that was built from one plant file.

    `devices` are gateways, lines and drives as `FieldDevices` has them; stations are the gateways
    as the master sees them. `plan` is the plant file. `spacing` notes telegrams to different drives
    that follow each other too closely; `memories` has what is in gateways at the start, and the PLC
    starts `start_after_ns` later than they; `holds` knows what faults hold.
    """

    plan: Plant
    catalog: Catalog
    kernel: Kernel
    cpu: Cpu
    master: DpMaster
    devices: FieldDevices
    stations: Mapping[str, Station]
    memories: Mapping[str, Memory] = field(default_factory=dict)
    start_after_ns: int = 0
    holds: Holds = field(default_factory=Holds)

    @property
    def gateways(self) -> Mapping[str, Tospbdp001]:
        """The gateways for telegrams."""
        return self.devices.gateways

    @property
    def interfaces(self) -> Mapping[str, Pbdp110]:
        """The gateways for process data."""
        return self.devices.interfaces

    @property
    def lines(self) -> Mapping[str, Line]:
        """The lines, by the gateway's name, or by that and the channel's: `gw1.a`."""
        return self.devices.lines

    @property
    def networks(self) -> Mapping[str, DeviceNet]:
        """The DeviceNet networks."""
        return self.devices.networks

    @property
    def options(self) -> Mapping[str, Dev003z]:
        """The DeviceNet options, by the names of the drives that they are in."""
        networks = self.networks.values()
        return {name: one for network in networks for name, one in network.options.items()}

    @property
    def drives(self) -> Mapping[str, Inverter]:
        """The inverters."""
        return self.devices.drives

    @property
    def spacing(self) -> Mapping[str, Spacing]:
        """What was sent too closely, by the gateway's name."""
        return self.devices.spacing

    @property
    def telegram_entries(self) -> tuple[PlantGateway, ...]:
        """Those gateways of the plant file that are for telegrams."""
        return tuple(item for item in self.plan.gateways if item.name in self.gateways)

    @property
    def interface_entries(self) -> tuple[PlantGateway, ...]:
        """Those gateways of the plant file that are for process data."""
        return tuple(item for item in self.plan.gateways if item.name in self.interfaces)

    def neighbours(self, drive: str) -> Sequence[str]:
        """The other drives on the line of a drive; none at an interface or on DeviceNet."""
        entries = (
            entry for entry in self.plan.units if drive in {item.name for item in entry.drives}
        )
        entry = next(entries, None)
        if entry is None:
            return ()
        on_a_line = entry.name not in self.interfaces and entry not in self.plan.devicenet
        return tuple(item.name for item in entry.drives if item.name != drive and on_a_line)

    def gets_telegrams(self, drive: str) -> bool:
        """Those on DeviceNet get none."""
        return drive not in self.options

    def cable(self, drive: str) -> Iterator[Hold[bool]]:
        """The cable to a drive at an interface: the supply comes through it, too. The drop of one
        on DeviceNet."""
        for network in self.networks.values():
            if drive in network.drops:
                yield attribute(network.drops[drive], "plugged", False, min)
        for entry in self.interface_entries:
            device = self.interfaces[entry.name]
            for item in entry.drives:
                if item.name == drive and item.channel is not None:
                    channel = item.channel.lower()
                    begin, end = partial(device.unplug, channel), partial(device.plug, channel)
                    yield switched(device, f"cable {channel}", begin, end)

    def start(self) -> None:
        """Switch the gateways on and start the CPU; drives have their supply already."""
        for name, gateway in self.gateways.items():
            gateway.power_on(self.memories.get(name))
        for interface in self.interfaces.values():
            interface.power_on()
        self.kernel.run_for(self.start_after_ns)
        self.cpu.start()

    def run_for(self, duration_ns: int) -> None:
        """Let `duration_ns` of the plant's time pass."""
        self.kernel.run_for(duration_ns)

    def record(self, variables: Iterable[str] = ()) -> "Recorder":
        """Record everything from now on; `finish` of what this gives is the trace.

        `variables` are paths of the PLC beside those of TOS_Plant. Raises DiagnosticError for
        variables that the PLC does not have.
        """
        from harness.trace.recorder import Recorder  # noqa: PLC0415 - few plants are recorded

        return Recorder(self, variables)

    def record_telegrams(self) -> "dict[str, TelegramRecorder]":
        """Listen to every gateway for telegrams from now on; by the gateway's name."""
        from harness.trace.telegrams import TelegramRecorder  # noqa: PLC0415 - as above

        return {
            entry.name: TelegramRecorder(
                self.master,
                self.stations[entry.name],
                self.lines[entry.name],
                self.gateways[entry.name].port,
                layout_of(entry, self.catalog.profibus_gateway(entry.type)),
                processing_ns=self.gateways[entry.name].settings.processing_ns,
            )
            for entry in self.telegram_entries
        }
