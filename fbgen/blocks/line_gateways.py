"""A gateway with a serial line as its templates see it: telegrams one by one, drives by INV-NO."""

from collections.abc import Iterable, Iterator

from fbgen.blocks.frames import frame_view
from fbgen.blocks.gateways import (
    FirstValue,
    GatewayView,
    frequency_values,
    gateway_place,
    inhibit_values,
)
from fbgen.blocks.line_times import LineTimes, line_times
from fbgen.blocks.literals import SclText, byte, milliseconds, truth
from fbgen.catalog import Catalog, Drive, TelegramGateway, origin
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.plant import Plant, PlantDrive, PlantGateway, layout_of
from fbgen.source import Origin

_MEMBERS = {
    "control": "control",
    "trigger": "trigger",
    "status": "gatewayStatus",
    "inv_no": "invNo",
    "cmd": "cmd",
    "comno": "comNo",
    "data": "data",
}
"""Field of the catalogue's layout -> member of typeTosOutput and typeTosInput."""

_TELEGRAM = {"inv_no": 1, "cmd": 1, "comno": 2, "data": 2}
_OUTPUTS = {"control": 2, "trigger": 1, **_TELEGRAM}
_INPUTS = {"status": 2, **_TELEGRAM}
"""The fields of both directions with their lengths in bytes, as the members are declared."""


@dataclass(frozen=True, slots=True)
class DriveView:
    """A drive on a line."""

    name: str
    series: str
    inv_no: int
    inv_no_byte: SclText


@dataclass(frozen=True, slots=True)
class LineGatewayView(GatewayView):
    """A gateway with everything its blocks need."""

    handshake: SclText
    status_poll: bool
    timeout: SclText
    retries: SclText
    gap: SclText
    apart: SclText
    taken: SclText
    times: LineTimes
    drives: tuple[DriveView, ...]
    line_block: str = "TOS_Line"
    poll_block: str = "TOS_StatusPoll"
    drive_block: str = "TOS_Drive"
    alarms_block: str = "TOS_Alarms"


def line_gateway_view(plant: Plant, gateway: PlantGateway, catalog: Catalog) -> LineGatewayView:
    """What the templates of one gateway are told."""
    entry = catalog.telegram_gateway(gateway.type)
    place = origin(f"gateway {gateway.name}", gateway)
    series = [catalog.drive(drive.series) for drive in gateway.drives]
    chosen = gateway.parameters.timeout_ms
    limits = line_times(plant, gateway, catalog)
    times = origin(f"gateway {gateway.name}", gateway, inputs=_times_of_the_line(entry, series))
    address, station = gateway_place(plant, gateway)
    timeout = milliseconds(limits.timeout_ms, times if chosen is None else place)
    retries = SclText(str(gateway.parameters.retries), place)
    of_drives = (value for drive in gateway.drives for value in drive_values(drive))
    return LineGatewayView(
        name=gateway.name,
        profibus_address=address,
        station=station,
        frame=frame_view(plant, gateway, layout_of(gateway, entry), _MEMBERS, "trigger"),
        block=f"TOS_Gateway_{gateway.name}",
        drives_type=f"typeTosGateway_{gateway.name}",
        params_type=f"typeTosParam_{gateway.name}",
        first_values=(
            FirstValue("line.timeout", timeout),
            FirstValue("line.retries", retries),
            *of_drives,
        ),
        handshake=truth(bool(gateway.options.get("handshake", True)), place),
        status_poll=gateway.status_poll,
        timeout=timeout,
        retries=retries,
        gap=milliseconds(limits.gap_ms, times),
        apart=milliseconds(limits.apart_ms, times),
        taken=milliseconds(limits.taken_ms, times),
        times=limits,
        drives=tuple(drive_view(item) for item in gateway.drives),
    )


def missing_fields(chosen: Iterable[PlantGateway], catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5008: layouts whose fields are not those that the blocks know, each with its length."""
    layouts = {
        (item.type, item.layout): layout_of(item, catalog.profibus_gateway(item.type))
        for item in chosen
    }
    for layout in layouts.values():
        for area, fields, wanted in (
            ("output", layout.output, _OUTPUTS),
            ("input", layout.input, _INPUTS),
        ):
            found = {item.name: item.length for item in fields if not item.pad}
            if found != wanted:
                listed = ", ".join(f"{name} ({size})" for name, size in wanted.items())
                yield Diagnostic(
                    "FB5008",
                    f"the {area} fields of layout '{layout.name}' are not those of TOS_Telegram",
                    layout.span_of(area),
                    f"the fields, with their lengths in bytes, are {listed}; all else is a pad",
                )


def _times_of_the_line(entry: TelegramGateway, series: Iterable[Drive]) -> Iterator[Origin | None]:
    """The entries that times of a line are worked out from."""
    for name in ("processing", "trigger_poll"):
        time = getattr(entry.times, name)
        yield origin(f"{entry.id} {name}", time, time.source or "")
    yield origin(f"{entry.id} subnetwork", entry.subnetwork, entry.subnetwork.source or "")
    for drive in series:
        limit = drive.times.reply_max
        yield origin(f"{drive.id} reply_max", limit, limit.source or "")


def drive_values(drive: PlantDrive) -> Iterator[FirstValue]:
    """What the parameters of a drive on a line begin with."""
    place = origin(f"drive {drive.name}", drive)
    pause = milliseconds(drive.parameters.error_pause_ms, place)
    yield from frequency_values(drive)
    yield FirstValue(f"{drive.name}.errorPause", pause)
    yield from inhibit_values(drive)


def drive_view(drive: PlantDrive) -> DriveView:
    """A drive by its number."""
    place = origin(f"drive {drive.name}", drive)
    return DriveView(drive.name, drive.series, drive.inv_no, byte(drive.inv_no, place))
