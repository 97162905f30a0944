"""A gateway of the plant, or a serial line, as templates see it, whatever its type."""

from collections.abc import Iterator, Sequence

from fbgen.blocks.frames import FieldView, FrameView
from fbgen.blocks.literals import SclText, real, truth
from fbgen.catalog import origin
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.plant import DeviceNetDrive, Plant, PlantDrive, PlantGateway


@dataclass(frozen=True, slots=True)
class FirstValue:
    """What a parameter of the user's begins with: its path below the gateway, and the value."""

    path: str
    value: SclText


@dataclass(frozen=True, slots=True)
class UnitView:
    """What the blocks of the plant as a whole need of a gateway or a serial line.

    `block`, `drives_type` and `params_type` are names of its block and of the types of its parts in
    TOS_Plant and TOS_Parameters.
    """

    name: str
    block: str
    drives_type: str
    params_type: str
    first_values: tuple[FirstValue, ...]


@dataclass(frozen=True, slots=True)
class GatewayView(UnitView):
    """A gateway: what is known of it beside that."""

    profibus_address: SclText
    station: SclText
    frame: FrameView

    @property
    def access(self) -> str:
        """How the program reaches the cyclic data."""
        return self.frame.access

    @property
    def layout_id(self) -> str:
        """The layout of the catalogue."""
        return self.frame.layout_id

    @property
    def identifiers(self) -> str:
        """Its configuration identifiers in hexadecimal."""
        return self.frame.identifiers

    @property
    def output_length(self) -> int:
        """Bytes to the gateway."""
        return self.frame.output_length

    @property
    def input_length(self) -> int:
        """Bytes from the gateway."""
        return self.frame.input_length

    @property
    def inputs(self) -> tuple[FieldView, ...]:
        """The fields from the gateway."""
        return self.frame.inputs

    @property
    def outputs(self) -> tuple[FieldView, ...]:
        """The fields to the gateway."""
        return self.frame.outputs

    @property
    def laddr_in(self) -> SclText:
        """What DPRD_DAT takes."""
        return self.frame.laddr_in

    @property
    def laddr_out(self) -> SclText:
        """What DPWR_DAT takes."""
        return self.frame.laddr_out


def frequency_values(drive: PlantDrive | DeviceNetDrive) -> Iterator[FirstValue]:
    """What a drive's parameters of frequency begin with, whatever it is connected to."""
    place = origin(f"drive {drive.name}", drive)
    yield FirstValue(f"{drive.name}.minFrequency", real(drive.parameters.min_frequency_hz, place))
    yield FirstValue(f"{drive.name}.maxFrequency", real(drive.max_frequency_hz, place))
    yield FirstValue(f"{drive.name}.atSetpoint", real(drive.parameters.at_setpoint_hz, place))


def inhibit_values(drive: PlantDrive | DeviceNetDrive) -> Iterator[FirstValue]:
    """What keeps a drive from running, as chosen in the plant file."""
    place = origin(f"drive {drive.name}", drive)
    own = drive.parameters
    yield FirstValue(f"{drive.name}.localInhibits", truth(own.local_inhibits, place))
    yield FirstValue(f"{drive.name}.interlockInhibits", truth(own.interlock_inhibits, place))


def other_types(chosen: Sequence[PlantGateway]) -> Iterator[Diagnostic]:
    """FB5009: the blocks of a family carry the words and times of one type of gateway."""
    for gateway in chosen[1:]:
        first = chosen[0]
        if gateway.type != first.type:
            yield Diagnostic(
                "FB5009",
                f"the gateway '{gateway.name}' is a {gateway.type}, '{first.name}' a {first.type}, "
                "and the blocks of one plant are made for one type of each kind",
                gateway.span_of("type"),
                "make a plant file of its own for each type",
            )


def gateway_place(plant: Plant, gateway: PlantGateway) -> tuple[SclText, SclText]:
    """Its PROFIBUS address, and how OB86 tells the station."""
    place = origin(f"gateway {gateway.name}", gateway)
    return (
        SclText(str(gateway.profibus_address), place),
        SclText(str(_station(plant, gateway)), place),
    )


def several_masters(plant: Plant) -> bool:
    """Whether the gateways belong to more than one DP master system."""
    return len({gateway.dp_master for gateway in plant.gateways}) > 1


def _station(plant: Plant, gateway: PlantGateway) -> int:
    """How OB86 tells the station: its address, above it the master where there are several."""
    master = gateway.dp_master if several_masters(plant) else 0
    return master << 8 | gateway.profibus_address
