"""A page for each gateway: what it is, its cyclic data, status codes, lamps, times, switches."""

from collections.abc import Iterator

from fbgen.catalog import (
    DeviceNetGateway,
    Gateway,
    Layout,
    ProcessDataGateway,
    ProfibusGateway,
    TelegramGateway,
)
from fbgen.docs.document import (
    Block,
    Code,
    Facts,
    Figure,
    Link,
    Page,
    Paragraph,
    Phrase,
    Row,
    Section,
    Table,
)
from fbgen.docs.frame_picture import frame_picture
from fbgen.docs.handshake import handshake_picture
from fbgen.docs.page_names import device_page, protocol_page, word_page
from fbgen.docs.pages.device_parts import (
    options_section,
    switches_section,
    times_section,
    word_table,
)
from fbgen.docs.pages.devicenet import devicenet_sections, node_facts
from fbgen.docs.pages.plant_gateways import in_this_plant
from fbgen.docs.sources import Sources
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code, octets

GROUP = "Gateways"
_WAYS = {
    "per_identifier": "one access for each identifier",
    "dpxx_dat": "DPRD_DAT and DPWR_DAT (SFC14, SFC15)",
    "process_image": "process image",
}


def gateway_pages(subject: Subject) -> Iterator[Page]:
    """One page each."""
    for gateway in subject.gateways.values():
        yield _gateway(gateway, subject)


def _gateway(gateway: Gateway, subject: Subject) -> Page:
    sources = Sources()
    sections = [
        Section("In short", (_gateway_facts(gateway, subject, sources),), "facts"),
        Section("Words", (word_table(gateway),), "words"),
    ]
    if isinstance(gateway, ProfibusGateway):
        sections += [_layout(gateway, layout, sources) for layout in gateway.layouts]
    sections += in_this_plant(gateway, subject)
    if isinstance(gateway, DeviceNetGateway):
        sections += devicenet_sections(gateway, sources)
    sections += _handshake(gateway, subject)
    if isinstance(gateway, TelegramGateway):
        sections.append(_status_codes(gateway, sources))
    if isinstance(gateway, ProcessDataGateway):
        sections += _parameter_channel(gateway, sources)
    sections += [_lamps(gateway, sources), times_section(gateway, sources)]
    if gateway.connectors:
        sections.append(_wiring(gateway, sources))
    if gateway.switches:
        sections.append(switches_section(gateway.switches, sources))
    sections += [options_section(gateway.options, sources), *sources.sections()]
    lead: Phrase = (gateway.description or gateway.title,)
    found = f"{gateway.id} {gateway.title}"
    return Page(device_page(gateway.id), gateway.title, GROUP, lead, tuple(sections), found)


def _gateway_facts(gateway: Gateway, subject: Subject, sources: Sources) -> Facts:
    rows: list[tuple[str, Phrase]] = [
        ("Made by", (gateway.vendor,)),
        ("Inverters", _those(gateway.series, subject)),
    ]
    if isinstance(gateway, ProfibusGateway):
        rows += _profibus(gateway, sources)
    if isinstance(gateway, DeviceNetGateway):
        rows += node_facts(gateway, sources)
    if isinstance(gateway, TelegramGateway):
        rows += _line(gateway, sources)
    return Facts(tuple(rows))


def _profibus(gateway: ProfibusGateway, sources: Sources) -> list[tuple[str, Phrase]]:
    bus = gateway.profibus
    yes_no = {True: "yes", False: "no"}
    return [
        ("Protocol", (Link(gateway.protocol, protocol_page(gateway.protocol)),)),
        ("PROFIBUS address", (f"{bus.minimum_address} to {bus.maximum_address}",)),
        ("Sync", (yes_no[bus.sync],)),
        ("Freeze", (yes_no[bus.freeze],)),
        ("Finds the baud rate", (yes_no[bus.auto_baud],)),
        ("PROFIBUS", sources.of(bus.source, bus.status)),
    ]


def _line(gateway: TelegramGateway, sources: Sources) -> list[tuple[str, Phrase]]:
    line = gateway.subnetwork
    text = (
        f"{line.baud} bit/s, {line.data_bits} data bits, parity {line.parity}, "
        f"{line.stop_bits} stop bit, {line.wires} wires, "
        f"usually {line.typical_drives} inverters "
    )
    ident = gateway.profibus
    return [
        ("Line", (text, *sources.of(line.source, line.status))),
        ("GSD file", (ident.gsd_file, ", ident number ", Code(f"{ident.ident_number:04X}"))),
    ]


def _those(series: tuple[str, ...], subject: Subject) -> Phrase:
    row: Phrase = ()
    for name in series:
        part: Phrase = (Link(name, device_page(name)),) if name in subject.drives else (name,)
        row += (", ", *part) if row else part
    return row


def _layout(gateway: ProfibusGateway, layout: Layout, sources: Sources) -> Section:
    named = {word.name for word in gateway.words}
    blocks: list[Block] = [
        Paragraph((f"{layout.title}. ", *sources.of(layout.source, layout.status))),
        Facts(
            (
                ("Identifiers", code(octets(layout.identifiers))),
                ("Out", (f"{layout.output_length} bytes, from the PLC",)),
                ("In", (f"{layout.input_length} bytes, to the PLC",)),
                ("Reached by", ("; ".join(_WAYS[way] for way in layout.access_ways),)),
            )
        ),
        Figure(frame_picture(layout), f"The cyclic data of {gateway.id} with {layout.name}"),
        _fields(gateway, layout, named),
        _identifiers(layout),
    ]
    if layout.invented:
        warning: Phrase = ("No GSD file offers this module: it is made up, to try blocks with.",)
        blocks.insert(0, Paragraph(warning, "warning"))
    title = f"Layout {layout.name}"
    if layout.name == gateway.default_layout:
        title += " (usual)"
    return Section(title, tuple(blocks), f"layout-{layout.name}")


def _handshake(gateway: Gateway, subject: Subject) -> Iterator[Section]:
    """What a simulated run has shown."""
    for seen in subject.handshakes:
        if seen.gateway == gateway.id:
            note = Paragraph(
                (
                    f"{seen.text} Recorded in a simulated run of the example plant {seen.plant}, "
                    "with the generated blocks; the simulated gateway follows the manuals.",
                )
            )
            title = f"The handshake of {gateway.id} in time"
            rows = tuple(
                Row(((str(number),), (f"{one.start_ms:.1f} ms",), code(one.text)))
                for number, one in enumerate(seen.frames, start=1)
            )
            table = Table(("Frame", "Begins at", "Bytes"), rows)
            figure = Figure(handshake_picture(seen), title)
            blocks = (note, figure, table) if rows else (note, figure)
            yield Section("Handshake in time", blocks, "handshake")


def _fields(gateway: Gateway, layout: Layout, named: set[str]) -> Table:
    rows = []
    for direction, fields in (("out", layout.output), ("in", layout.input)):
        for field in fields:
            last = field.end - 1
            place = str(field.offset) if last == field.offset else f"{field.offset} to {last}"
            word = field.name.rpartition("_")[2] if field.name not in named else field.name
            title: Phrase = (field.title,)
            if word in named:
                title = (Link(field.title, word_page(gateway.id, word)),)
            anchor = f"{layout.name}-{direction}-{field.name}"
            rows.append(Row(((direction,), (place,), code(field.name), title), anchor))
    return Table(("Direction", "Bytes from 0", "Field", "What it is"), tuple(rows))


def _identifiers(layout: Layout) -> Table:
    rows = []
    for item in layout.parsed_identifiers:
        consistency = "whole" if item.consistent else "byte or word"
        out = f"{item.output_length} at {item.output_offset}" if item.output_length else "-"
        into = f"{item.input_length} at {item.input_offset}" if item.input_length else "-"
        rows.append(
            Row(((str(item.index + 1),), code(octets(item.code)), (out,), (into,), (consistency,)))
        )
    columns = ("Slot", "Identifier", "Bytes out, from", "Bytes in, from", "Consistent over")
    return Table(columns, tuple(rows), "Configuration identifiers")


def _status_codes(gateway: TelegramGateway, sources: Sources) -> Section:
    rows = tuple(
        Row(
            (
                code(f"{item.code:02X}"),
                (item.kind,),
                (item.title,),
                (item.data or "",),
                sources.of(item.source, item.status),
            ),
            f"status-code-{item.code:02X}",
            f"{gateway.id} status code {item.code:02X} {item.title}",
        )
        for item in gateway.status_codes
    )
    table = Table(("Code", "Kind", "Meaning", "Status data", "Source"), rows)
    return Section("Status codes", (table,), "status-codes")


def _parameter_channel(gateway: ProcessDataGateway, sources: Sources) -> Iterator[Section]:
    channel = gateway.parameter_channel
    rows = [
        Row(
            (
                (direction,),
                code(f"{item.code:02b}"),
                (item.title,),
                sources.of(item.source, item.status),
            )
        )
        for direction, items in (("request", channel.requests), ("response", channel.responses))
        for item in items
    ]
    errors = tuple(
        Row(
            (code(f"{item.code:04X}"), (item.title,), sources.of(item.source, item.status)),
            f"access-error-{item.name}",
            f"{gateway.id} error {item.code:04X} {item.title}",
        )
        for item in channel.errors
    )
    yield Section(
        "Parameter channel",
        (
            Table(("Direction", "Bits", "Meaning", "Source"), tuple(rows)),
            Table(("Code", "Error", "Source"), errors, "Error codes"),
        ),
        "parameter-channel",
    )


def _wiring(gateway: Gateway, sources: Sources) -> Section:
    blocks: list[Block] = []
    for connector in gateway.connectors:
        rows = tuple(
            Row((code(item.pin), (item.signal,), (item.wire or "",))) for item in connector.pins
        )
        blocks.append(Table(("Pin", "Signal", "Wire"), rows, connector.title))
        note: Phrase = (connector.remark or "Pins that are not named are not connected.", " ")
        blocks.append(Paragraph((*note, *sources.of(connector.source, connector.status))))
    return Section("Wiring", tuple(blocks), "wiring")


def _lamps(gateway: Gateway, sources: Sources) -> Section:
    rows = []
    for led in gateway.leds:
        if not led.states:
            rows.append(Row(((str(led.number),), (led.title,), (), ("unused",), (), ())))
        for state in led.states:
            light = state.light.replace("_", " ")
            normal = "yes" if state.normal else ""
            cells: tuple[Phrase, ...] = (
                *((str(led.number),), (led.title,), (light,), (state.meaning,), (normal,)),
                sources.of(state.source, state.status),
            )
            rows.append(Row(cells, f"led-{led.name}-{state.name}"))
    columns = ("Lamp", "Name", "Light", "Meaning", "Normal", "Source")
    return Section("Lamps", (Table(columns, tuple(rows)),), "lamps")
