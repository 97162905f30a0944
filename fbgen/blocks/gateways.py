"""One gateway of the plant as templates see it: its cyclic layout on this PLC, its drives."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from fbgen.blocks.line_times import LineTimes, line_times
from fbgen.blocks.literals import SclText, byte, milliseconds, real
from fbgen.catalog import Catalog, CyclicField, Drive, Layout, TelegramGateway, origin
from fbgen.diagnostics import Diagnostic
from fbgen.plant import Plant, PlantDrive, PlantGateway
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
class FieldView:
    """A field of the cyclic data. `parts` are the addresses to access, the high byte first."""

    name: str
    offset: int
    size: int
    parts: tuple[SclText, ...]


@dataclass(frozen=True, slots=True)
class DriveView:
    """A drive behind the gateway."""

    name: str
    series: str
    inv_no: int
    inv_no_byte: SclText
    max_frequency: SclText
    min_frequency: SclText
    at_setpoint: SclText
    error_pause: SclText


@dataclass(frozen=True, slots=True)
class GatewayView:
    """A gateway with everything its blocks need."""

    name: str
    profibus_address: SclText
    station: SclText
    access: str
    layout_id: str
    identifiers: str
    output_length: int
    input_length: int
    inputs: tuple[FieldView, ...]
    outputs: tuple[FieldView, ...]
    laddr_in: SclText
    laddr_out: SclText
    handshake: SclText
    status_poll: bool
    timeout: SclText
    retries: SclText
    gap: SclText
    apart: SclText
    times: LineTimes
    drives: tuple[DriveView, ...]

    @property
    def outputs_trigger_last(self) -> tuple[FieldView, ...]:
        """DATA first, then the rest backwards, the trigger at the very end."""
        return (*reversed(self.outputs_without_trigger), self._trigger)

    @property
    def outputs_without_trigger(self) -> tuple[FieldView, ...]:
        """Everything but the trigger, in ascending order."""
        return tuple(item for item in self.outputs if item is not self._trigger)

    @property
    def trigger_address(self) -> SclText:
        """Where the trigger lies."""
        return self._trigger.parts[0]

    @property
    def _trigger(self) -> FieldView:
        return next(item for item in self.outputs if item.name == "trigger")


def gateway_view(plant: Plant, gateway: PlantGateway, catalog: Catalog) -> GatewayView:
    """What the templates of one gateway are told."""
    entry = catalog.telegram_gateway(gateway.type)
    layout = entry.layout(gateway.layout)
    place = origin(f"gateway {gateway.name}", gateway)
    series = [catalog.drive(drive.series) for drive in gateway.drives]
    chosen = gateway.parameters.timeout_ms
    limits = line_times(plant, gateway, catalog)
    times = origin(f"gateway {gateway.name}", gateway, inputs=_times_of_the_line(entry, series))
    return GatewayView(
        name=gateway.name,
        profibus_address=SclText(str(gateway.profibus_address), place),
        station=SclText(str(_station(plant, gateway)), place),
        access=gateway.access,
        layout_id=layout.name,
        identifiers=layout.identifiers.hex(" ").upper(),
        output_length=layout.output_length,
        input_length=layout.input_length,
        inputs=_fields(layout, gateway, "I"),
        outputs=_fields(layout, gateway, "Q"),
        laddr_in=_laddr(plant, gateway, gateway.input_address),
        laddr_out=_laddr(plant, gateway, gateway.output_address),
        handshake=SclText("TRUE" if gateway.options.get("handshake", True) else "FALSE", place),
        status_poll=gateway.status_poll,
        timeout=milliseconds(limits.timeout_ms, times if chosen is None else place),
        retries=SclText(str(gateway.parameters.retries), place),
        gap=milliseconds(limits.gap_ms, times),
        apart=milliseconds(limits.apart_ms, times),
        times=limits,
        drives=tuple(_drive(item) for item in gateway.drives),
    )


def several_masters(plant: Plant) -> bool:
    """Whether the gateways belong to more than one DP master system."""
    return len({gateway.dp_master for gateway in plant.gateways}) > 1


def _station(plant: Plant, gateway: PlantGateway) -> int:
    """How OB86 tells the station: its address, above it the master where there are several."""
    master = gateway.dp_master if several_masters(plant) else 0
    return master << 8 | gateway.profibus_address


def missing_fields(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5008: layouts whose fields are not those that the blocks know, each with its length."""
    layouts = {
        (item.type, item.layout): catalog.gateway(item.type).layout(item.layout)
        for item in plant.gateways
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


def _fields(layout: Layout, gateway: PlantGateway, area: str) -> tuple[FieldView, ...]:
    fields = layout.output if area == "Q" else layout.input
    base = (gateway.output_address if area == "Q" else gateway.input_address) or 0
    views = []
    for item in fields:
        if item.pad:
            continue
        source = origin(f"layout {layout.name}, {item.name}", item, layout.source or "")
        words = gateway.access == "per_identifier" and _is_word(layout, item, area)
        parts = (
            (f"%{area}W{base + item.offset}",)
            if words
            else tuple(f"%{area}B{base + offset}" for offset in range(item.offset, item.end))
        )
        texts = tuple(SclText(part, source) for part in parts)
        views.append(FieldView(_MEMBERS[item.name], item.offset, item.length, texts))
    return tuple(views)


def _is_word(layout: Layout, item: CyclicField, area: str) -> bool:
    """Whether one identifier is just this field as a word: then one access moves it as a whole.

    The process image is accessed by bytes: IEC 61131-3 counts words where S7 counts bytes.
    """
    for identifier in layout.parsed_identifiers:
        start = identifier.output_offset if area == "Q" else identifier.input_offset
        if start == item.offset:
            return item.length == 2 and identifier.unit_length == 2
    return False


def _laddr(plant: Plant, gateway: PlantGateway, address: int | None) -> SclText:
    """S7-1200/1500 take the hardware identifier, S7-300/400 the start address."""
    source = origin(f"gateway {gateway.name}", gateway)
    if plant.family.classic:
        return SclText(f"W#16#{address or 0:X}", source)
    return SclText(str(gateway.hardware_identifier or 0), source)


def _drive(drive: PlantDrive) -> DriveView:
    place = origin(f"drive {drive.name}", drive)
    own = drive.parameters
    return DriveView(
        name=drive.name,
        series=drive.series,
        inv_no=drive.inv_no,
        inv_no_byte=byte(drive.inv_no, place),
        max_frequency=real(drive.max_frequency_hz, place),
        min_frequency=real(own.min_frequency_hz, place),
        at_setpoint=real(own.at_setpoint_hz, place),
        error_pause=milliseconds(own.error_pause_ms, place),
    )
