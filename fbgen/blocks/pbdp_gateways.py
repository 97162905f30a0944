"""A gateway for process data as its templates see it: a drive at each channel."""

from collections.abc import Iterable, Iterator

from fbgen.blocks.frames import frame_view
from fbgen.blocks.gateways import (
    FirstValue,
    GatewayView,
    frequency_values,
    gateway_place,
    inhibit_values,
)
from fbgen.blocks.literals import SclText, byte, milliseconds, truth, word
from fbgen.blocks.trips import command_source
from fbgen.catalog import Catalog, Layout, ProcessDataGateway, origin
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.plant import Plant, PlantDrive, PlantGateway, layout_of
from fbgen.source import Origin

_OUTPUTS = ("command", "frequency", "action", "number", "data")
_INPUTS = ("status", "frequency", "current", "voltage", "response", "number", "data")
"""The data of a channel, in front of which the catalogue puts the channel's name."""
_CALLED_OTHERWISE = {"action": "request"}
"""What typePbdpOutput cannot call like the catalogue: ACTION is a reserved word of IEC 61131-3."""

_RESERVE = 3
"""A job may take so many times the longest that the catalogue says, and some cycles."""
_CYCLES = 6


@dataclass(frozen=True, slots=True)
class PbdpDriveView:
    """A drive at a channel of the gateway. `channel` is the member of the frames: a or b."""

    name: str
    series: str
    channel: str
    letter: str
    diagnosis_mask: SclText
    silence: SclText
    trip_number: SclText
    source_number: SclText
    source_network: SclText
    trip_text: str


@dataclass(frozen=True, slots=True)
class PbdpGatewayView(GatewayView):
    """A gateway with everything its blocks need."""

    identifiers_unverified: bool
    has_parameters: bool
    diagnosis_laddr: SclText | None
    status_poll: SclText
    eeprom: SclText
    timeout: SclText
    drives: tuple[PbdpDriveView, ...]


def pbdp_gateway_view(plant: Plant, gateway: PlantGateway, catalog: Catalog) -> PbdpGatewayView:
    """What the templates of one gateway are told."""
    entry = catalog.process_data_gateway(gateway.type)
    layout = layout_of(gateway, entry)
    place = origin(f"gateway {gateway.name}", gateway)
    address, station = gateway_place(plant, gateway)
    timeout = job_timeout(plant, gateway, entry)
    of_line = (FirstValue("line.timeout", timeout),)
    of_drives = (
        value
        for drive in gateway.drives
        for values in (frequency_values, inhibit_values)
        for value in values(drive)
    )
    return PbdpGatewayView(
        name=gateway.name,
        profibus_address=address,
        station=station,
        frame=frame_view(plant, gateway, layout, _members(entry)),
        block=f"PBDP_Gateway_{gateway.name}",
        drives_type=f"typePbdpGateway_{gateway.name}",
        params_type=f"typePbdpParam_{gateway.name}",
        first_values=(*of_line, *of_drives),
        identifiers_unverified="identifiers" in layout.unverified,
        has_parameters=entry.has_parameter_channel(layout),
        diagnosis_laddr=_diagnosis_laddr(plant, gateway, place),
        status_poll=truth(gateway.status_poll, place),
        eeprom=truth(gateway.eeprom, place),
        timeout=timeout,
        drives=tuple(_drive(item, entry, catalog) for item in gateway.drives),
    )


def job_timeout(plant: Plant, gateway: PlantGateway, entry: ProcessDataGateway) -> SclText:
    """The limit of a job in the parameter channel: the plant file's, or worked out."""
    chosen = gateway.parameters.timeout_ms
    if chosen is not None:
        return milliseconds(chosen, origin(f"gateway {gateway.name}", gateway))
    longest = entry.times.parameter_max
    place = origin(f"{entry.id} parameter_max", longest, longest.source or "")
    return milliseconds(_RESERVE * longest.ms + _CYCLES * plant.cycle_time_ms, place)


def _diagnosis_laddr(plant: Plant, gateway: PlantGateway, place: Origin | None) -> SclText | None:
    """What DPNRM_DG takes; None where it is not given or the PLC does not have the instruction."""
    address = gateway.diagnosis_address
    if address is None or not plant.family.whole_frame:
        return None
    return SclText(f"W#16#{address:X}" if plant.family.classic else str(address), place)


def unknown_fields(chosen: Iterable[PlantGateway], catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5008: layouts whose fields have other lengths than those that the blocks know."""
    layouts: dict[tuple[str, str], Layout] = {}
    for gateway in chosen:
        entry = catalog.process_data_gateway(gateway.type)
        layouts[gateway.type, gateway.layout] = layout_of(gateway, entry)
    for layout in layouts.values():
        for area, fields in (("output", layout.output), ("input", layout.input)):
            for field in fields:
                if not field.pad and field.length != 2:
                    yield Diagnostic(
                        "FB5008",
                        f"the field '{field.name}' of layout '{layout.name}' has {field.length} "
                        f"bytes, and PBDP_Drive has a word for each {area}",
                        field.span_of("length"),
                        "give it two bytes; what stands beside it is a pad",
                    )


def _members(entry: ProcessDataGateway) -> dict[str, str]:
    return {
        f"{channel.name}_{name}": f"{channel.name}.{_CALLED_OTHERWISE.get(name, name)}"
        for channel in entry.channels
        for name in (*_OUTPUTS, *_INPUTS)
    }


def trip_text_of(series: str) -> str:
    """The function with the trips of a series in words: `PBDP_TripText_vf_s11`."""
    return f"PBDP_TripText_{series.replace('-', '_')}"


def _drive(drive: PlantDrive, entry: ProcessDataGateway, catalog: Catalog) -> PbdpDriveView:
    series = catalog.drive(drive.series)
    channel = entry.channel((drive.channel or "A").lower())
    trip = series.comno(series.link.trip)
    source = command_source(series)
    silence = series.times.reset_silence
    return PbdpDriveView(
        name=drive.name,
        series=drive.series,
        channel=channel.name,
        letter=channel.name.upper(),
        diagnosis_mask=byte(
            1 << channel.diagnosis_bit,
            origin(f"{entry.id} channel {channel.name}", channel, channel.source or ""),
        ),
        silence=milliseconds(
            silence.ms, origin(f"{series.id} reset_silence", silence, silence.source or "")
        ),
        trip_number=word(trip.number, origin(f"ComNo {trip.hex}", trip, trip.source or "")),
        source_number=source["number"] if source else word(0),
        source_network=source["network"] if source else word(0),
        trip_text=trip_text_of(drive.series),
    )
