"""A word with its bits, as a table for a person and as plain data: decode, encode, catalog show."""

from collections.abc import Iterable

from fbgen.catalog import BitField, DecodedField, Word
from fbgen.catalog.sourced import Sourced
from fbgen.cli.table import table


def decoded_text(path: str, word: Word, value: int) -> str:
    """The value in the usual spellings, each field with what it means, and the sources."""
    sources: list[str] = []
    rows = [
        [
            str(item.field.bit),
            item.field.name,
            _value(item),
            _source(word, item.field, sources),
            f"{item.field.title}: {item.meaning}" if item.meaning else item.field.title,
        ]
        for item in word.decode(value)
    ]
    rows += [
        [str(bit), "-", "1", "", "the catalogue knows no meaning of this bit"]
        for bit in range(15, -1, -1)
        if word.undefined(value) >> bit & 1
    ]
    rows.sort(key=lambda row: -int(row[0].partition("..")[0]))
    head = f"{path} = {value:04X}   {spellings(value)}\n{word.title}"
    body = table(["bit", "name", "value", "source", "meaning"], rows)
    return f"{head}\n\n{body}\n\n{source_list(sources)}"


def bits_text(path: str, word: Word) -> str:
    """All fields of a word with the meanings of their values, and the sources."""
    sources: list[str] = []
    rows = [
        [
            str(field.bit),
            field.name,
            _source(word, field, sources),
            "; ".join(
                [field.title, *(f"{key} = {text}" for key, text in _values(field)), *_acts(field)]
            ),
        ]
        for field in sorted(word.bits, key=lambda item: -item.low)
    ]
    head = f"{path}\n{word.title}, from {word.written_by} to {word.read_by}"
    notes = [word.remark] if word.remark else []
    if word.needs is not None:
        notes.append(f"Acts while {word.needs} is set, apart from bits that always act.")
    if word.overridden_by:
        notes.append(f"Terminals have priority over it by {', '.join(word.overridden_by)}.")
    remark = "".join(f"\n{note}" for note in notes)
    body = table(["bit", "name", "source", "meaning"], rows)
    return f"{head}{remark}\n\n{body}\n\n{source_list(sources)}"


def decoded_json(path: str, word: Word, value: int) -> dict[str, object]:
    """The same as plain data."""
    return {
        "word": path,
        "title": word.title,
        "value": value,
        "hex": f"{value:04X}",
        "undefined": f"{word.undefined(value):04X}",
        "fields": [_field_json(word, item) for item in word.decode(value)],
    }


def spellings(value: int) -> str:
    """A word as SCL, in binary and decimal."""
    binary = "_".join(f"{value >> shift & 15:04b}" for shift in (12, 8, 4, 0))
    return f"16#{value:04X}, 2#{binary}, {value}"


def source_list(sources: Iterable[str]) -> str:
    """The sources with the numbers that the tables refer to."""
    lines = [f"[{number}] {source}" for number, source in enumerate(sources, start=1)]
    return "\n".join(["Sources:", *lines])


class Sources:
    """The sources of one text, numbered as they appear."""

    def __init__(self) -> None:
        self.found: list[str] = []

    def of(self, item: Sourced) -> str:
        """How a table refers to the source of an entry."""
        return source_number(item.source or "", item.status, self.found)


def source_number(source: str, status: str, sources: list[str]) -> str:
    """How a table refers to a source, which is added to the list if it is new."""
    if not source:
        return status
    if source not in sources:
        sources.append(source)
    mark = f"[{sources.index(source) + 1}]"
    return mark if status == "verified" else f"{mark} {status}"


def _source(word: Word, field: BitField, sources: list[str]) -> str:
    return source_number(word.source_of(field), word.status_of(field), sources)


def _value(item: DecodedField) -> str:
    return str(item.value) if item.field.maximum == 1 else f"16#{item.value:X}"


def _values(field: BitField) -> Iterable[tuple[str, str]]:
    for value, text in field.values.items():
        yield (str(value) if field.maximum == 1 else f"16#{value:X}"), text


def _acts(field: BitField) -> Iterable[str]:
    """How a bit of a command acts."""
    if field.always:
        yield "always acts"
    if field.stays_until:
        yield f"stays until {', '.join(field.stays_until)}"
    if field.ored_with:
        yield f"ORed with {', '.join(field.ored_with)}"
    for value, names in field.parameters.items():
        yield f"{value} uses {', '.join(names)}"
    if not field.answered:
        yield "no reply"


def _field_json(word: Word, item: DecodedField) -> dict[str, object]:
    return {
        "name": item.field.name,
        "high": item.field.high,
        "low": item.field.low,
        "value": item.value,
        "title": item.field.title,
        "meaning": item.meaning,
        "source": word.source_of(item.field),
        "status": word.status_of(item.field),
    }
