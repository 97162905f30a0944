"""A DeviceNet network as its templates see it: where the bytes of drives lie, what they are.

Data are little endian, as they stand in frames; the words and what carries them come from the
assemblies of the catalogue.
"""

from collections.abc import Iterator

from fbgen.blocks.dev_assemblies import Side, kind_of, pair_of, sides_of, wrong_choices
from fbgen.blocks.dev_parameters import DriveChannelView, drive_channel, job_timeout_ms
from fbgen.blocks.gateways import FirstValue, UnitView, frequency_values, inhibit_values
from fbgen.blocks.literals import SclText, byte, milliseconds, truth
from fbgen.catalog import Catalog, origin
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.plant import DeviceNetDrive, DeviceNetNetwork, Plant


@dataclass(frozen=True, slots=True)
class ByteWord:
    """A word of the image: the variable that stands for it, and the addresses of its two bytes."""

    target: str
    low: SclText
    high: SclText


@dataclass(frozen=True, slots=True)
class DevDriveView:
    """A drive on the network. `active_byte` and `active_mask` tell whether it exchanges data."""

    name: str
    series: str
    mac: int
    assemblies: str
    kind: SclText
    silence: SclText
    active_byte: SclText
    active_mask: SclText
    inputs: tuple[ByteWord, ...]
    outputs: tuple[ByteWord, ...]
    channel: DriveChannelView | None


@dataclass(frozen=True, slots=True)
class DevNetworkView(UnitView):
    """A network with everything its block needs."""

    drives: tuple[DevDriveView, ...]


def dev_network_view(plant: Plant, network: DeviceNetNetwork, catalog: Catalog) -> DevNetworkView:
    """What the templates of one network are told; it has an `active_address`."""
    return DevNetworkView(
        name=network.name,
        block=f"DEV_Network_{network.name}",
        drives_type=f"typeDevNetwork_{network.name}",
        params_type=f"typeDevParam_{network.name}",
        first_values=tuple(
            value
            for drive in network.drives
            for value in _first_values(drive, catalog, job_timeout_ms(plant, network))
        ),
        drives=tuple(_drive(network, drive, catalog) for drive in network.drives),
    )


def _first_values(
    drive: DeviceNetDrive, catalog: Catalog, timeout_ms: float
) -> Iterator[FirstValue]:
    place = origin(f"drive {drive.name}", drive)
    yield from frequency_values(drive)
    yield from inhibit_values(drive)
    in_rpm = truth(drive.parameters.speed_unit == "rpm", place)
    yield FirstValue(f"{drive.name}.inRpm", in_rpm)
    entry = catalog.devicenet_gateway(drive.type).option("motor_poles")
    poles = drive.options.get(entry.id, entry.default)
    yield FirstValue(f"{drive.name}.poles", SclText(str(poles), place))
    yield FirstValue(f"{drive.name}.timeout", milliseconds(timeout_ms, place))


def _drive(network: DeviceNetNetwork, drive: DeviceNetDrive, catalog: Catalog) -> DevDriveView:
    entry, series = catalog.devicenet_gateway(drive.type), catalog.drive(drive.series)
    pair = pair_of(drive, entry)
    outputs, inputs = sides_of(drive, catalog)
    place = origin(f"drive {drive.name}", drive)
    table = network.active_address
    assert table is not None, "checked before"
    silence = series.times.reset_silence
    return DevDriveView(
        name=drive.name,
        series=drive.series,
        mac=drive.mac,
        assemblies=drive.assemblies,
        kind=SclText(str(kind_of(pair)), origin(f"assembly {pair.output.instance}", pair)),
        silence=milliseconds(
            silence.ms, origin(f"{series.id} reset_silence", silence, silence.source or "")
        ),
        active_byte=SclText(f"%IB{table + drive.mac // 8}", place),
        active_mask=byte(1 << drive.mac % 8, place),
        inputs=tuple(_words(inputs)),
        outputs=tuple(_words(outputs)),
        channel=drive_channel(entry, pair, series),
    )


def _words(side: Side) -> Iterator[ByteWord]:
    drive, assembly = side.drive, side.assembly
    area, address = ("Q", drive.output_address) if side.is_output else ("I", drive.input_address)
    members = side.members()
    for field in assembly.fields:
        source = origin(f"assembly {assembly.instance}, {field.name}", field, assembly.source or "")
        first = address + field.offset
        low, high = (SclText(f"%{area}B{first + place}", source) for place in (0, 1))
        yield ByteWord(_target(side, members[field.name]), low, high)


def _target(side: Side, member: str) -> str:
    name, out = side.drive.name, side.is_output
    if member.startswith("words["):
        return f"drives.{name}.{'control' if out else 'state'}.{member}"
    return f"{'out' if out else 'in'}_{name}.{member}"


def network_problems(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5018 no table of who is there; FB5019 words that are not chosen as a drive needs them."""
    for network in plant.devicenet:
        if network.active_address is None:
            yield Diagnostic(
                "FB5018",
                f"the blocks of '{network.name}' could not see that a drive is lost",
                network.span_of("name"),
                "add active_address: first byte of the scanner's table of who exchanges data; a "
                "program of your own may do without",
            )
        for drive in network.drives:
            yield from wrong_choices(drive, catalog)
