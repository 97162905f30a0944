"""A page for each word: its bits, what they mean at 0 and 1, who writes and reads them, a decoder.

The decoder also shows the bytes that carry the word: in the cyclic data of the gateways that serve
the series, and in the binary frame of the inverters' line.
"""

from collections.abc import Iterator, Mapping

from fbgen.catalog import BitField, ComNo, Drive, Gateway, Layout, TelegramGateway, Word
from fbgen.docs.bit_picture import bit_picture
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
    Tool,
    spaced,
)
from fbgen.docs.page_names import comno_link, device_page, word_page
from fbgen.docs.sources import UNVERIFIED, Sources
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code, listed
from fbgen.docs.usage import NO_USAGE, BitItem, Usage
from fbgen.docs.usage.phrases import by_block

GROUP = "Words"
_PARTIES = {"plc": "the PLC", "gateway": "the gateway", "drive": "the inverter"}
_ENDS = {
    "cleared": "it is 0 again",
    "power_off": "power off",
    "reset": "a reset",
    "factory_setting": "the factory setting",
}


def word_pages(subject: Subject, usage: Usage = NO_USAGE) -> Iterator[Page]:
    """The pages of all words of all devices."""
    for device in subject.devices:
        for item in device.words:
            yield _page(device, item, subject, usage)


def _page(device: Gateway | Drive, item: Word, subject: Subject, usage: Usage) -> Page:
    sources = Sources()
    cells = _cells(device, item)
    numbers = ", ".join(cell.hex for cell in cells)
    name = f"{device.id}.{item.name}"
    blocks: list[Block] = [Facts(_facts(device, item, cells, sources))]
    if item.remark:
        blocks.append(Paragraph((item.remark,)))
    blocks.append(Figure(bit_picture(item), f"The bits of {name}"))
    blocks.append(_bit_table(device, item, sources, usage))
    decoder = Tool("decoder", _decoder(device, item, cells, subject))
    sections = [
        Section("Decoder", (decoder,), "decoder"),
        Section("Bits", tuple(blocks), "bits"),
        *_examples(item, sources),
        *sources.sections(),
    ]
    return Page(
        word_page(device.id, item.name),
        f"{name} {numbers}".strip(),
        GROUP,
        (item.title,),
        tuple(sections),
        f"{name} {numbers} {item.title}",
    )


def _examples(item: Word, sources: Sources) -> Iterator[Section]:
    """Values that manuals show, each with a link that puts it into the decoder."""
    rows = []
    for example in item.examples:
        names = [one.field.name for one in item.decode(example.value) if one.value]
        bits = listed(code(name) for name in names)
        link = Link(f"{example.value:04X}", "", "decoder", f"v={example.value:04X}")
        source = sources.of(example.source, example.status)
        rows.append(Row(((link,), (example.title,), bits, source)))
    if rows:
        table = Table(
            ("Value", "What the manual says", "Bits that are not 0", "Source"), tuple(rows)
        )
        yield Section("Worked examples", (table,), "examples")


def _cells(device: Gateway | Drive, item: Word) -> list[ComNo]:
    """The ComNos that hold this word."""
    if isinstance(device, Gateway):
        return []
    return [cell for cell in device.comnos if cell.word == item.name]


def _facts(
    device: Gateway | Drive, item: Word, cells: list[ComNo], sources: Sources
) -> tuple[tuple[str, Phrase], ...]:
    rows: list[tuple[str, Phrase]] = [
        ("Device", (Link(device.title, device_page(device.id)),)),
        ("Written by", (_PARTIES[item.written_by],)),
        ("Read by", (_PARTIES[item.read_by],)),
    ]
    if cells:
        links = [(comno_link(device.id, cell), f" {cell.title}") for cell in cells]
        rows.append(("ComNo", listed(links)))
    if item.needs is not None:
        needs: Phrase = ("acts while ", Code(item.needs), " is 1, apart from bits that always act")
        rows.append(("Needs", needs))
    if item.overridden_by:
        names = listed(code(name) for name in item.overridden_by)
        rows.append(("Terminals", ("these terminal functions have priority: ", *names)))
    rows.append(("Source", sources.of(item.source, item.status)))
    return tuple(rows)


def _bit_table(device: Gateway | Drive, item: Word, sources: Sources, usage: Usage) -> Table:
    columns = ["Bit", "Name", "Meaning", "0", "1 or value", "Source"]
    used = device.id in usage.devices
    if used:
        columns.insert(5, "Used by")
    rows = []
    for field in sorted(item.bits, key=lambda field: -field.low):
        low, high = _meanings(field)
        cells: list[Phrase] = [
            code(str(field.bit)),
            code(field.name),
            _meaning(field),
            low,
            high,
            sources.of(item.source_of(field), item.status_of(field)),
        ]
        if used:
            cells.insert(5, by_block(usage.of(BitItem(device.id, item.name, field.name))))
        found = f"{device.id}.{item.name}.{field.name} bit {field.bit} {field.title}"
        rows.append(Row(tuple(cells), f"bit-{field.name}", found))
    for bit in _unnamed(item):
        cells = [code(bit), ("-",), ("no document gives it a meaning",), (), (), (UNVERIFIED,)]
        if used:
            cells.insert(5, ())
        rows.append(Row(tuple(cells)))
    rows.sort(key=lambda row: -_highest(row))
    return Table(tuple(columns), tuple(rows))


def _highest(row: Row) -> int:
    first = row.cells[0][0]
    assert isinstance(first, Code)
    return int(first.text.partition("..")[0])


def _meanings(field: BitField) -> tuple[Phrase, Phrase]:
    """What 0 and the other values mean."""
    low = field.values.get(0, "")
    others = [
        (text if field.maximum == 1 else f"{value:X}: {text}",)
        for value, text in sorted(field.values.items())
        if value
    ]
    return (low,) if low else (), listed(others)


def _meaning(field: BitField) -> Phrase:
    """The title, and behind it in sentences what else there is to know."""
    acts = _acts(field)
    return spaced((f"{field.title}.",), acts) if acts else (field.title,)


def _acts(field: BitField) -> Phrase:
    """How the bit of a command acts, and what somebody ought to know."""
    texts = []
    if field.always:
        texts.append("Always acts.")
    if field.stays_until:
        texts.append(f"Stays until {' or '.join(_ENDS[end] for end in field.stays_until)}.")
    if field.ored_with:
        texts.append(f"ORed with {', '.join(field.ored_with)}.")
    texts += [f"{value}: {', '.join(names)}." for value, names in field.parameters.items()]
    if not field.answered:
        texts.append("No reply comes.")
    if field.remark:
        texts.append(field.remark)
    return (" ".join(texts),) if texts else ()


def _unnamed(item: Word) -> Iterator[str]:
    """Bits without a meaning, rows of them as `7..4`."""
    bits = [bit for bit in range(16) if not item.defined >> bit & 1]
    while bits:
        high = low = bits.pop()
        while bits and bits[-1] == low - 1:
            low = bits.pop()
        yield str(high) if high == low else f"{high}..{low}"


def _decoder(
    device: Gateway | Drive, item: Word, cells: list[ComNo], subject: Subject
) -> dict[str, object]:
    """What the decoder's script needs."""
    fields = [
        {
            "name": field.name,
            "high": field.high,
            "low": field.low,
            "title": field.title,
            "values": {str(value): text for value, text in field.values.items()},
        }
        for field in sorted(item.bits, key=lambda field: -field.low)
    ]
    data: dict[str, object] = {"word": f"{device.id}.{item.name}", "fields": fields}
    if isinstance(device, Drive) and cells:
        data["comnos"] = [cell.hex for cell in cells]
        data["writes"] = item.written_by == "plc"
        data["telegrams"] = list(_telegrams(device, item, subject))
    return data


def _telegrams(device: Drive, item: Word, subject: Subject) -> Iterator[Mapping[str, object]]:
    """The cyclic data in which gateways carry a telegram of this series."""
    for gateway in subject.gateways.values():
        if isinstance(gateway, TelegramGateway) and device.id in gateway.series:
            layout = gateway.layout(gateway.default_layout)
            yield {
                "gateway": gateway.id,
                "layout": layout.name,
                "fields": _places(layout, item.written_by == "plc"),
            }


def _places(layout: Layout, output: bool) -> list[list[object]]:
    fields = layout.output if output else layout.input
    return [[field.name, field.offset, field.length] for field in fields]
