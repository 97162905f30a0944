"""The cross-reference: which block reads or changes which bit and which communication number."""

from collections.abc import Iterator

from fbgen.catalog import Drive, Gateway, Word
from fbgen.docs.document import (
    Block,
    Bullets,
    Code,
    Link,
    Page,
    Paragraph,
    Phrase,
    Row,
    Section,
    Table,
)
from fbgen.docs.page_names import comno_link, word_page
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code, listed
from fbgen.docs.usage import BitItem, ComNoItem, Usage
from fbgen.docs.usage.phrases import by_block, places

GROUP = "Blocks"
PAGE = "usage"
_LEAD = (
    "Which block reads or changes which bit, and asks for which communication number, in which "
    "line. It is taken from the generated text, parsed and checked, so it cannot be out of date: "
    "the numbers are lines of the files that fbgen generate writes."
)


def usage_pages(subject: Subject, usage: Usage) -> Iterator[Page]:
    """One page, if there are blocks."""
    if not usage.known:
        return
    devices = [device for device in subject.devices if device.id in usage.devices]
    sections = [
        *(section for device in devices for section in _words(device, usage)),
        *_numbers(subject, usage),
        _unused(devices, usage),
        _twice(devices, usage),
    ]
    yield Page(PAGE, "Cross-reference", GROUP, (_LEAD,), tuple(sections), "cross-reference usage")


def _words(device: Gateway | Drive, usage: Usage) -> Iterator[Section]:
    for word in device.words:
        rows = []
        for field in sorted(word.bits, key=lambda field: -field.low):
            uses = usage.of(BitItem(device.id, word.name, field.name))
            link = Link(field.name, word_page(device.id, word.name), f"bit-{field.name}")
            rows.append(Row((code(str(field.bit)), (link,), by_block(uses))))
        if not any(row.cells[2] for row in rows):
            continue
        blocks: list[Block] = [Table(("Bit", "Name", "Used by"), tuple(rows))]
        blocks += _worked_out(device, word, usage)
        name = f"{device.id}.{word.name}"
        yield Section(name, tuple(blocks), name)


def _worked_out(device: Gateway | Drive, word: Word, usage: Usage) -> Iterator[Paragraph]:
    found = usage.worked_out(device.id, word.name)
    if found:
        lines = listed((Code(f"{one.file}:{one.line}"),) for one in found)
        yield Paragraph(("Further bits are set from a value that is worked out: ", *lines, "."))


def _numbers(subject: Subject, usage: Usage) -> Iterator[Section]:
    rows = []
    for series in subject.drives.values():
        for cell in sorted(series.comnos, key=lambda cell: cell.number):
            uses = usage.of(ComNoItem(series.id, cell.number))
            if uses:
                link = comno_link(series.id, cell)
                rows.append(Row(((series.id,), (link,), code(cell.name), by_block(uses))))
    if rows:
        yield Section(
            "ComNos", (Table(("Series", "ComNo", "Name", "Used by"), tuple(rows)),), "comnos"
        )


def _unused(devices: list[Gateway | Drive], usage: Usage) -> Section:
    items: list[Phrase] = []
    for device in devices:
        for word in device.words:
            unused = [
                field.name
                for field in sorted(word.bits, key=lambda field: -field.low)
                if not usage.of(BitItem(device.id, word.name, field.name))
            ]
            if unused:
                link = Link(f"{device.id}.{word.name}", word_page(device.id, word.name))
                more = ""
                if usage.worked_out(device.id, word.name):
                    more = " (some of them may be set from a value that is worked out)"
                items.append((link, ": ", *listed(code(name) for name in unused), more))
    text = "Bits that no block names. Words of which all bits stand here are not used bit by bit."
    return Section("Bits that are never used", (Paragraph((text,)), Bullets(tuple(items))), "never")


def _twice(devices: list[Gateway | Drive], usage: Usage) -> Section:
    rows = []
    for device in devices:
        for word in device.words:
            for field in word.bits:
                found = usage.changes(BitItem(device.id, word.name, field.name))
                if len({(use.file, use.line) for use in found}) < 2:
                    continue
                name = f"{device.id}.{word.name}.{field.name}"
                link = Link(name, word_page(device.id, word.name), f"bit-{field.name}")
                rows.append(Row(((link,), places(found))))
    text = (
        "Each of these bits is set, cleared or written in more than one line. That is right where "
        "one block puts a word together, and worth a look where two blocks do."
    )
    table = Table(("Bit", "Where"), tuple(rows))
    return Section("Bits that are written in several places", (Paragraph((text,)), table), "twice")
