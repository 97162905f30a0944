"""A DeviceNet network as its templates see it: where the bytes of drives lie, what they are.

Data are little endian, as they stand in frames; the words and what carries them come from the
assemblies of the catalogue.
"""

from collections.abc import Iterator, Mapping

from fbgen.blocks.dev_parameters import DriveChannelView, drive_channel, job_timeout_ms
from fbgen.blocks.gateways import FirstValue, UnitView, frequency_values, inhibit_values
from fbgen.blocks.literals import SclText, byte, milliseconds, truth
from fbgen.catalog import Assembly, Catalog, DeviceNetGateway, Drive, origin
from fbgen.catalog.devicenet_gateways import AssemblyField, AssemblyPair, Selection
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.plant import DeviceNetDrive, DeviceNetNetwork, Plant, assemblies_of

CONTROLS = {"basic_control": 1, "extended_control": 2, "command": 3}
"""How a drive is told what to do, by the name of its word: the input `kind` of DEV_Drive."""

_MEMBERS = {
    **{"control": "control", "command": "control", "status": "status"},
    **{"speed": "speed", "frequency": "speed"},
    **{"function": "request", "index": "number", "data": "data"},
}
"""Field of an assembly -> member of typeDevOutput or typeDevInput. FUNCTION is a reserved word."""
_RESPONSE = {"request": "response"}

_COMMANDS = {"command_word_option": "control", "frequency_setpoint_option": "speed"}
_MONITORS = {
    **{"status": "status", "output_frequency": "speed"},
    **{"output_current": "current", "output_voltage": "voltage"},
}
"""What a word that a parameter chooses carries, by the name of its cell -> the member it is."""
NEEDED = ("control", "speed"), ("status", "speed")
"""The members without which a drive cannot be commanded, and not be seen."""


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


def pair_of(drive: DeviceNetDrive, entry: DeviceNetGateway) -> AssemblyPair:
    """The assemblies of a drive of a plant that was checked."""
    pair = assemblies_of(drive, entry)
    assert pair is not None, "checked when the plant was read"
    return pair


def _drive(network: DeviceNetNetwork, drive: DeviceNetDrive, catalog: Catalog) -> DevDriveView:
    entry, series = catalog.devicenet_gateway(drive.type), catalog.drive(drive.series)
    pair = pair_of(drive, entry)
    place = origin(f"drive {drive.name}", drive)
    table = network.active_address
    assert table is not None, "checked before"
    silence = series.times.reset_silence
    return DevDriveView(
        name=drive.name,
        series=drive.series,
        mac=drive.mac,
        assemblies=drive.assemblies,
        kind=SclText(str(_kind(pair)), origin(f"assembly {pair.output.instance}", pair)),
        silence=milliseconds(
            silence.ms, origin(f"{series.id} reset_silence", silence, silence.source or "")
        ),
        active_byte=SclText(f"%IB{table + drive.mac // 8}", place),
        active_mask=byte(1 << drive.mac % 8, place),
        inputs=tuple(_words(drive, entry, series, pair.input)),
        outputs=tuple(_words(drive, entry, series, pair.output)),
        channel=drive_channel(entry, pair, series),
    )


def _kind(pair: AssemblyPair) -> int:
    """By the word that commands; where parameters choose the words it is the command word."""
    words = (field.word for field in pair.output.fields)
    return next((CONTROLS[word] for word in words if word in CONTROLS), CONTROLS["command"])


def has_links(pair: AssemblyPair) -> bool:
    """Whether its data can take run, stop and set-point away from the terminals."""
    return _kind(pair) != CONTROLS["basic_control"]


def has_command_word(pair: AssemblyPair) -> bool:
    """Whether its data know more than run, stop, direction and reset."""
    return _kind(pair) == CONTROLS["command"]


def _words(
    drive: DeviceNetDrive, entry: DeviceNetGateway, series: Drive, assembly: Assembly
) -> Iterator[ByteWord]:
    out = assembly is pair_of(drive, entry).output
    area, address = ("Q", drive.output_address) if out else ("I", drive.input_address)
    members = members_of(drive, entry, series, assembly)
    for field in assembly.fields:
        source = origin(f"assembly {assembly.instance}, {field.name}", field, assembly.source or "")
        first = address + field.offset
        low, high = (SclText(f"%{area}B{first + place}", source) for place in (0, 1))
        yield ByteWord(_target(drive, members[field.name], out=out), low, high)


def _target(drive: DeviceNetDrive, member: str, *, out: bool) -> str:
    if member.startswith("words["):
        return f"drives.{drive.name}.{'control' if out else 'state'}.{member}"
    return f"{'out' if out else 'in'}_{drive.name}.{member}"


def members_of(
    drive: DeviceNetDrive, entry: DeviceNetGateway, series: Drive, assembly: Assembly
) -> Mapping[str, str]:
    """What each field of an assembly is for the blocks; `words[3]` is the user's own business."""
    out = assembly is pair_of(drive, entry).output
    selections, known = (entry.commands, _COMMANDS) if out else (entry.monitors, _MONITORS)
    numbers = {series.comno(name).number: member for name, member in known.items()}
    found: dict[str, str] = {}
    chosen = 0
    for field in assembly.fields:
        if field.parameter is None:
            member = _MEMBERS[field.name]
            found[field.name] = member if out else _RESPONSE.get(member, member)
            continue
        chosen += 1
        number = _chosen(drive, entry, field, selections)
        member = "" if number is None else numbers.get(number, "")
        taken = member in found.values()
        found[field.name] = f"words[{chosen}]" if taken or not member else member
    return found


def _chosen(
    drive: DeviceNetDrive,
    entry: DeviceNetGateway,
    field: AssemblyField,
    selections: tuple[Selection, ...],
) -> int | None:
    """The communication number that a field carries with these settings, None for nothing."""
    parameter = entry.parameter(field.parameter or "")
    value = drive.settings.get(parameter.name, parameter.default)
    return next((item.comno for item in selections if item.code == value), None)


def network_problems(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5018 no table of who is there; FB5019 words that a drive needs are not chosen."""
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
            yield from _not_chosen(drive, catalog)


def _not_chosen(drive: DeviceNetDrive, catalog: Catalog) -> Iterator[Diagnostic]:
    entry, series = catalog.devicenet_gateway(drive.type), catalog.drive(drive.series)
    pair = pair_of(drive, entry)
    sides = (pair.output, entry.commands, _COMMANDS), (pair.input, entry.monitors, _MONITORS)
    for (assembly, selections, known), needed in zip(sides, NEEDED, strict=True):
        found = members_of(drive, entry, series, assembly).values()
        choosing = [field.parameter for field in assembly.fields if field.parameter is not None]
        for member in needed:
            if member in found:
                continue
            cell = series.comno(
                next(name for name, known_as in known.items() if known_as == member)
            )
            code = next(item.code for item in selections if item.comno == cell.number)
            yield Diagnostic(
                "FB5019",
                f"nothing of assembly {assembly.instance} of '{drive.name}' carries "
                f"{cell.hex} ({cell.title})",
                drive.span_of("assemblies"),
                f"add one of them to settings: {', '.join(choosing)}, with the value {code}; the "
                "inverter needs it, too",
            )
