"""Which generated lines a change of the catalogue or the plant file has changed, and through what.

Two sets of files are laid beside each other. A line that is not the same in both belongs to those
changes whose entries its origins name: its own values, and what these were worked out from. The
hash of the inputs, which changes with everything, does not count.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from difflib import SequenceMatcher

from fbgen.catalog.differences import Difference
from fbgen.dataclass import dataclass
from fbgen.emit.generated import GeneratedFile, GeneratedSet
from fbgen.lang.printer import LineOrigins
from fbgen.source import Origin, Span

_NO_HASH = "00000000"


@dataclass(frozen=True, slots=True)
class ChangedLine:
    """A line that is gone (`sign` "-", its number in the old file) or new ("+", in the new one)."""

    file: str
    sign: str
    number: int
    text: str
    origins: LineOrigins

    def as_json(self) -> dict[str, object]:
        """As plain data."""
        return {"file": self.file, "sign": self.sign, "line": self.number, "text": self.text}


@dataclass(frozen=True, slots=True)
class Affected:
    """A difference with the lines that it has changed."""

    difference: Difference
    lines: tuple[ChangedLine, ...]


@dataclass(frozen=True, slots=True)
class Comparison:
    """All differences with their lines, and the changed lines that belong to none of them: what
    follows from an entry that is new or gone, such as the numbers of the steps behind it."""

    affected: tuple[Affected, ...]
    other: tuple[ChangedLine, ...]


@dataclass(slots=True)
class _ByPlace:
    """Changed lines by the places that their origins name."""

    lines: dict[tuple[str, int], list[ChangedLine]] = field(default_factory=dict)

    def add(self, line: ChangedLine) -> None:
        for place in dict.fromkeys(_places(line.origins)):
            self.lines.setdefault(place, []).append(line)

    def of(self, entries: Sequence[Span]) -> list[ChangedLine]:
        """The lines of the innermost entry that has any. The file as a whole does not count: what
        names it is about something else in it."""
        for span in entries[:-1] or entries:
            if found := self.lines.get((span.source.name, span.line)):
                return found
        return []


def compared(differences: Iterable[Difference], old: GeneratedSet, new: GeneratedSet) -> Comparison:
    """The differences with the lines that they have changed."""
    lines = list(_changed_lines(old, new))
    gone, come = _ByPlace(), _ByPlace()
    for line in lines:
        (gone if line.sign == "-" else come).add(line)
    place = {id(line): number for number, line in enumerate(lines)}
    affected: list[Affected] = []
    known: set[int] = set()
    for item in differences:
        found = {place[id(line)] for line in (*gone.of(item.old), *come.of(item.new))}
        known |= found
        affected.append(Affected(item, tuple(lines[number] for number in sorted(found))))
    rest = tuple(line for number, line in enumerate(lines) if number not in known)
    return Comparison(tuple(affected), rest)


def _changed_lines(old: GeneratedSet, new: GeneratedSet) -> Iterator[ChangedLine]:
    before, after = _programs(old), _programs(new)
    for name in dict.fromkeys((*before, *after)):
        first = _lines(before.get(name), old.inputs_hash)
        second = _lines(after.get(name), new.inputs_hash)
        if first == second:
            continue
        matcher = SequenceMatcher(None, first, second, autojunk=False)
        for tag, a, b, c, d in matcher.get_opcodes():
            if tag != "equal":
                yield from _signed("-", first[a:b], a, before.get(name))
                yield from _signed("+", second[c:d], c, after.get(name))


def _signed(
    sign: str, texts: Sequence[str], start: int, file: GeneratedFile | None
) -> Iterator[ChangedLine]:
    if file is not None:
        for number, text in enumerate(texts, start=start):
            yield ChangedLine(file.name, sign, number + 1, text, file.origins[number])


def _programs(files: GeneratedSet) -> Mapping[str, GeneratedFile]:
    return {file.name: file for file in files.files if file.is_program}


def _lines(file: GeneratedFile | None, inputs_hash: str) -> list[str]:
    return [] if file is None else file.text.replace(inputs_hash, _NO_HASH).splitlines()


def _places(origins: Iterable[Origin]) -> Iterator[tuple[str, int]]:
    for origin in origins:
        if not origin.is_template:
            yield origin.file, origin.line
            yield from _places(origin.inputs)
