"""One gateway of the plant as templates see it: its cyclic layout on this PLC, its drives."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from fbgen.blocks.literals import SclText, byte, milliseconds, real
from fbgen.catalog import Catalog, CyclicField, Drive, Gateway, Layout, Sequence, origin
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


_BUS_CYCLE_MS = 5


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
    longest_telegram_ms: float
    drive_zero: SclText
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


def gateway_view(
    plant: Plant,
    gateway: PlantGateway,
    sequences: Iterable[Sequence],
    catalog: Catalog,
) -> GatewayView:
    """What the templates of one gateway are told."""
    entry = catalog.gateway(gateway.type)
    layout = entry.layout(gateway.layout)
    place = origin(f"gateway {gateway.name}", gateway)
    series = [catalog.drive(drive.series) for drive in gateway.drives]
    reply_max = max(item.times.reply_max.ms for item in series)
    chosen = gateway.parameters.timeout_ms
    timeout_ms = reply_timeout_ms(plant, entry, reply_max) if chosen is None else float(chosen)
    times = origin(f"gateway {gateway.name}", gateway, inputs=_times_of_the_line(entry, series))
    return GatewayView(
        name=gateway.name,
        profibus_address=SclText(str(gateway.profibus_address), place),
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
        timeout=milliseconds(timeout_ms, times if chosen is None else place),
        retries=SclText(str(gateway.parameters.retries), place),
        gap=milliseconds(silent_gap_ms(plant, entry, reply_max), times),
        apart=milliseconds(apart_ms(entry, reply_max), times),
        longest_telegram_ms=_longest_telegram_ms(plant, timeout_ms, sequences),
        drive_zero=SclText("TRUE" if any(not item.inv_no for item in gateway.drives) else "FALSE"),
        drives=tuple(_drive(item) for item in gateway.drives),
    )


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


def reply_timeout_ms(plant: Plant, gateway: Gateway, reply_max_ms: float) -> float:
    """How long a reply may take, with a reserve of twice the time that the manual adds up.

    Drive, gateway in both directions and 8 bytes on the line in both directions, and two cycles of
    the PLC for reading and writing. Source: TOSPBDP001 manual v1.1, 9.
    """
    line_ms = 2 * _frame_ms(gateway)
    return 2 * (reply_max_ms + 2 * gateway.times.processing.ms + line_ms) + 2 * plant.cycle_time_ms


def silent_gap_ms(plant: Plant, gateway: Gateway, reply_max_ms: float) -> float:
    """How long the line is left alone after a telegram that nobody answers.

    The gateway has surely looked at the trigger, processed and sent the telegram, also where the
    trigger leaves the PLC a cycle after its data; then comes the drive's reply time, which the
    manual asks for between telegrams to different drives. Source: TOSPBDP001 manual v1.1, 9.
    """
    times = gateway.times
    sent_ms = times.trigger_poll.ms + times.processing.ms + _frame_ms(gateway)
    return 2 * plant.cycle_time_ms + sent_ms + reply_max_ms


def _times_of_the_line(entry: Gateway, series: Iterable[Drive]) -> Iterator[Origin | None]:
    """The entries that times of a line are worked out from."""
    for name in ("processing", "trigger_poll"):
        time = getattr(entry.times, name)
        yield origin(f"{entry.id} {name}", time, time.source or "")
    yield origin(f"{entry.id} subnetwork", entry.subnetwork, entry.subnetwork.source or "")
    for drive in series:
        limit = drive.times.reply_max
        yield origin(f"{drive.id} reply_max", limit, limit.source or "")


def apart_ms(gateway: Gateway, reply_max_ms: float) -> float:
    """How long after a telegram the PLC may send one to another drive of the same line.

    On the line they must be the reply time apart, that of the slowest series. A bus cycle and the
    grid on which the gateway may look at the trigger shift each of them. Source: TOSPBDP001 manual
    v1.1, 9; the bus cycle of 5 ms is a reserve.
    """
    return reply_max_ms + gateway.times.trigger_poll.ms + _BUS_CYCLE_MS


def _longest_telegram_ms(plant: Plant, poll_ms: float, sequences: Iterable[Sequence]) -> float:
    """How long the line is taken by a telegram that has no reply.

    TOS_Telegram tries it three times and perhaps once more for the spacer, and needs some cycles.
    """
    limits = [poll_ms]
    for sequence in sequences:
        own = (getattr(step, "timeout_ms", None) for step in sequence.steps)
        limits += [sequence.reply_timeout_ms, *(limit for limit in own if limit is not None)]
    return 4 * max(limits) + 6 * plant.cycle_time_ms


def _frame_ms(gateway: Gateway) -> float:
    """How long 8 bytes take on the line towards the drives."""
    return 8 * gateway.subnetwork.character_bits / gateway.subnetwork.baud * 1000


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
