"""The generated files of twins (`fbgen.emit.twins`), from what their models are printed as.

The text is that of the model with the words exchanged. The origins of a line are those that stand
in the text's own source where the model's line has its. Where a line was broken, which value stands
in which piece is told by the words in it: there it is worked out anew unless each value stands in
the same pieces as in the model.
"""

from collections.abc import Iterable, Sequence
from itertools import accumulate

from fbgen.dataclass import dataclass
from fbgen.emit.exchanged_words import exchanged, pieces_of
from fbgen.emit.generated import GeneratedFile
from fbgen.emit.twins import Twin
from fbgen.lang import ast
from fbgen.lang.printer import LineOrigins, print_generated
from fbgen.lang.printer.line_origins import line_origins, values_in
from fbgen.source import Source, Span


@dataclass(frozen=True, slots=True)
class _Broken:
    """Lines `start` to `end` that were made from one place, where the values in that stand in the
    source, and which of them stands in which line."""

    start: int
    end: int
    place: Span
    values: Sequence[tuple[int, int]]
    inside: Sequence[bool]


@dataclass(frozen=True, slots=True)
class _Pattern:
    """The text of a model in pieces, its different line origins, which of them each line has, and
    what was broken into several lines."""

    pieces: Sequence[str]
    origins: Sequence[LineOrigins]
    of_line: Sequence[int]
    broken: Sequence[_Broken]


class TwinFiles:
    """The generated files of twins; their models are among `units`."""

    def __init__(self, units: Iterable[ast.File]) -> None:
        self._units = {file.source.name: file for file in units}
        self._patterns: dict[str, _Pattern] = {}

    def file(self, twin: Twin) -> GeneratedFile:
        """That of a twin."""
        name = twin.model.source.name
        if name not in self._patterns:
            self._patterns[name] = _pattern(self._units[name])
        pattern = self._patterns[name]
        text = exchanged(pattern.pieces, twin.words)
        return GeneratedFile(twin.unit.source.name, text, _origins(pattern, twin, text))

    def bodies(self, twins: Iterable[Twin]) -> dict[str, tuple[ast.Statement, ...]]:
        """The code of the models, by the names of the blocks that it stands for."""
        found = {}
        for twin in twins:
            (own,) = self._units[twin.unit.source.name].units
            (model,) = self._units[twin.model.source.name].units
            if isinstance(own, ast.Block) and isinstance(model, ast.Block):
                found[own.name.name] = model.body
        return found


def _pattern(file: ast.File) -> _Pattern:
    printed = print_generated(file)
    known = {origins: number for number, origins in enumerate(dict.fromkeys(printed.origins))}
    lines = printed.text.split("\n")
    starts = accumulate(printed.together, initial=0)
    broken = []
    for start, count in zip(starts, printed.together, strict=False):
        place = printed.places[start]
        if count > 1 and place is not None and (values := values_in(place)):
            end = start + count
            inside = _inside(file.source, values, lines[start:end])
            broken.append(_Broken(start, end, place, values, inside))
    return _Pattern(
        pieces_of(printed.text),
        list(known),
        [known[origins] for origins in printed.origins],
        broken,
    )


def _inside(source: Source, values: Sequence[tuple[int, int]], lines: Sequence[str]) -> list[bool]:
    """Whether the text of each value stands in each of the lines."""
    texts = [source.text[start:end] for start, end in values]
    return [text in line for text in texts for line in lines]


def _origins(pattern: _Pattern, twin: Twin, text: str) -> tuple[LineOrigins, ...]:
    source = twin.unit.source
    own = [tuple([twin.origins[origin] for origin in origins]) for origins in pattern.origins]
    found = [own[number] for number in pattern.of_line]
    lines = text.split("\n")
    for one in pattern.broken:
        pieces = lines[one.start : one.end]
        if _inside(source, one.values, pieces) != one.inside:
            place = Span(source, one.place.start, one.place.end)
            found[one.start : one.end] = line_origins(pieces, place)
    return tuple(found)
