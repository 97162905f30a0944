"""What the parts of the option share: the catalogue's entry, the inverter, and what commands it."""

from fbgen.catalog import DeviceNetGateway
from fbgen.dataclass import dataclass
from harness.gateways.dev003z.cells import Cells
from harness.gateways.dev003z.commands import Commands
from harness.gateways.dev003z.host import Host
from harness.gateways.dev003z.own_parameters import OwnParameters
from harness.gateways.dev003z.speeds import Speeds
from harness.gateways.dev003z.supervisor import Supervisor


@dataclass(frozen=True, slots=True)
class Parts:
    """One of each."""

    gateway: DeviceNetGateway
    host: Host
    own: OwnParameters
    cells: Cells
    speeds: Speeds
    commands: Commands
    supervisor: Supervisor
