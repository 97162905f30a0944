"""The gateways of a plant with their inverters, for a master that is none of ours."""

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.plant import Plant
from harness.drives import Inverter
from harness.fieldbus import NO_MASTER, DpSlave, Segment
from harness.installation import FieldDevices, build_devices
from harness.kernel import Kernel

_FREE = "no master"


@dataclass(frozen=True, slots=True)
class ServedGateways:
    """All gateways of a plant on one PROFIBUS cable, switched on."""

    plan: Plant
    kernel: Kernel
    devices: FieldDevices
    segment: Segment

    @property
    def state(self) -> str:
        """One line for a person: what each gateway and each inverter does."""
        parts = []
        for entry in self.plan.gateways:
            parts.append(_slave(entry.name, self.devices.slave(entry.name)))
            parts += [_drive(item.name, self.devices.drives[item.name]) for item in entry.drives]
        return "; ".join(parts)


def gateways_to_serve(plan: Plant, catalog: Catalog, seed: int = 0) -> ServedGateways:
    """The devices of a plant, switched on, with nothing but a cable towards the master.

    Raises DiagnosticError FB7502 for a gateway that cannot be simulated.
    """
    kernel = Kernel(seed)
    devices = build_devices(plan, catalog, kernel, {})
    for entry in plan.gateways:
        devices.device(entry.name).power_on()
    slaves = [devices.slave(entry.name) for entry in plan.gateways]
    return ServedGateways(plan, kernel, devices, Segment(kernel, slaves))


def _slave(name: str, slave: DpSlave) -> str:
    master = slave.master_address
    owner = _FREE if master == NO_MASTER else f"master {master}"
    return f"{name} (address {slave.address}) {slave.state.value}, {owner}"


def _drive(name: str, drive: Inverter) -> str:
    if drive.tripped:
        return f"{name} tripped {drive.trip_display}"
    return f"{name} {drive.frequency_hz:.2f} Hz" if drive.running else f"{name} stopped"
