"""The cyclic data of a gateway for `fbgen decode` and `fbgen encode`: field by field.

A gateway may have several layouts; without `layout=` it is the usual one if the number of bytes
fits, else one that it fits, without the bytes that mean nothing too, as manuals print telegrams.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from fbgen.catalog import Catalog, CyclicField, Layout, ProfibusGateway, Word
from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_fields import Fields
from fbgen.cli.frames.frame_reading import Part, Reading, size_of
from fbgen.cli.frames.toshiba_answers import address_text
from fbgen.cli.frames.toshiba_reading import command_text
from fbgen.diagnostics import error

WAYS = ("output", "input")


class TelegramKind(NamedTuple):
    """The data of a gateway to ("output") or from it, as the PLC sees them."""

    gateway: ProfibusGateway
    way: str


def telegram_kind(known: Catalog, word: str) -> TelegramKind | None:
    """What `tospbdp001.output` stands for; None for a word of the catalogue."""
    device, _, way = word.lower().partition(".")
    gateway = known.profibus_gateways.get(device)
    return TelegramKind(gateway, way) if gateway is not None and way in WAYS else None


def cells_of(kind: TelegramKind, series: str | None, known: Catalog) -> CellTexts:
    """The ComNos of a series; without one those of the gateway's, if it has only one."""
    names = kind.gateway.series
    wanted = series or (names[0] if len(names) == 1 else None)
    return CellTexts(None if wanted is None else known.drive(wanted))


def telegram_reading(kind: TelegramKind, data: bytes, cells: CellTexts) -> Reading:
    """What the bytes say. Raises DiagnosticError FB9041 if they fit no layout."""
    layout, fields = _fitting(kind, data)
    return _reading(kind, layout, fields, data, cells)


def written_telegram(kind: TelegramKind, arguments: Sequence[str], cells: CellTexts) -> Reading:
    """The reading of data that are made of fields; what is not given is 0.

    Raises DiagnosticError FB9042 and FB9043 with everything that is wrong with the fields.
    """
    given = Fields(arguments, cells)
    layouts = {layout.name: layout for layout in kind.gateway.layouts}
    layout = layouts[given.choice("layout", layouts, kind.gateway.default_layout)]
    data = bytearray(_length(layout, kind.way))
    com_no = 0
    for field in _fields(layout, kind.way):
        if field.pad:
            continue
        if field.name == "comno":
            com_no = given.com_no("comno") if given.has("comno") else 0
            value = com_no
        elif field.name == "cmd":
            text = given.text("cmd", "R")
            value = ord(text) if len(text) == 1 else int(_hexadecimal(given, "cmd", 1), 16)
        elif field.name == "data" and given.has("value"):
            value = given.word("data", com_no)
        elif field.name == "inv_no":
            value = given.number("inv_no", range(256), 0)
        else:
            value = int(_hexadecimal(given, field.name, field.length), 16)
        data[field.offset : field.end] = value.to_bytes(field.length)
    given.close()
    return _reading(kind, layout, _fields(layout, kind.way), bytes(data), cells)


def _hexadecimal(given: Fields, name: str, length: int) -> str:
    text = given.text(name, "0").upper().removeprefix("16#").removeprefix("0X")
    if not text or len(text) > 2 * length or not set(text) <= set("0123456789ABCDEF"):
        given.wrong(name, "is no such number", f"write up to {2 * length} hexadecimal digits")
        return "0"
    return text


def _fitting(kind: TelegramKind, data: bytes) -> tuple[Layout, tuple[CyclicField, ...]]:
    """The layout, and its fields at the places where they stand in these bytes."""
    gateway = kind.gateway
    layouts = sorted(gateway.layouts, key=lambda one: one.name != gateway.default_layout)
    for layout in layouts:
        if _length(layout, kind.way) == len(data):
            return layout, _fields(layout, kind.way)
    for layout in layouts:
        fields = _without_pads(_fields(layout, kind.way))
        if fields and fields[-1].end == len(data):
            return layout, fields
    wanted = sorted({_length(layout, kind.way) for layout in layouts})
    raise error(
        "FB9041",
        f"this is no {kind.way} of {gateway.id}: it has {size_of(len(data))}",
        help=f"its layouts have {', '.join(map(str, wanted))} bytes",
    )


def _reading(
    kind: TelegramKind,
    layout: Layout,
    fields: Sequence[CyclicField],
    data: bytes,
    cells: CellTexts,
) -> Reading:
    title = f"{kind.gateway.id}, layout {layout.name}, {kind.way} of the PLC"
    parts = tuple(_parts(kind, fields, data, cells))
    return Reading(title, kind.way, data, None, parts, ())


def _parts(
    kind: TelegramKind, fields: Sequence[CyclicField], data: bytes, cells: CellTexts
) -> Iterator[Part]:
    words = {word.name: word for word in kind.gateway.words}
    com_no = _number(fields, data, ("comno",))
    for field in fields:
        raw = data[field.offset : field.end]
        value = int.from_bytes(raw)
        word = words.get(field.name) or words.get(field.name.rpartition("_")[2])
        if field.pad:
            text = "means nothing"
        elif word is not None and field.length == 2:
            text = set_bits(word, value)
        elif field.name == "inv_no":
            text = address_text(value)
        elif field.name == "cmd":
            text = command_text(value)
        elif field.name == "comno":
            text = cells.name(value)
        elif field.name == "data" and com_no is not None:
            text = cells.value(com_no, value)
        else:
            text = f"{field.title}: {value}" if field.length <= 2 else field.title
        yield Part(raw, field.name, text)


def _number(fields: Sequence[CyclicField], data: bytes, names: Sequence[str]) -> int | None:
    found = next((one for one in fields if one.name in names), None)
    return None if found is None else int.from_bytes(data[found.offset : found.end])


def set_bits(word: Word, value: int) -> str:
    """The bits of a word that are 1 by their names, and wider fields with their values."""
    shown_bits = [
        item.field.name if item.field.maximum == 1 else f"{item.field.name}={item.value:X}"
        for item in word.decode(value)
        if item.value
    ]
    return ", ".join(shown_bits) or "no bit set"


def _fields(layout: Layout, way: str) -> tuple[CyclicField, ...]:
    return layout.output if way == "output" else layout.input


def _length(layout: Layout, way: str) -> int:
    return layout.output_length if way == "output" else layout.input_length


def _without_pads(fields: Sequence[CyclicField]) -> tuple[CyclicField, ...]:
    """The fields moved together, as a manual prints a telegram."""
    found: list[CyclicField] = []
    for field in fields:
        if not field.pad:
            offset = found[-1].end if found else 0
            found.append(field.model_copy(update={"offset": offset}))
    return tuple(found)
