"""The generated files of twins (`fbgen.emit.twins`), from what their models are printed as.

The text is that of the model with the words exchanged. The origins of a line are those that stand
in the text's own source where the model's line has its. Where a line was broken, which value stands
in which piece is told by the words in it, so there it is worked out anew.
"""

from collections.abc import Iterable, Sequence
from itertools import accumulate

from fbgen.dataclass import dataclass
from fbgen.emit.exchanged_words import exchanged, pieces_of
from fbgen.emit.generated import GeneratedFile
from fbgen.emit.twins import Twin
from fbgen.lang import ast
from fbgen.lang.printer import LineOrigins, print_generated
from fbgen.lang.printer.line_origins import line_origins
from fbgen.source import Span


@dataclass(frozen=True, slots=True)
class _Pattern:
    """The text of a model in pieces, its different line origins, which of them each line has, and
    where lines begin that were made from one place together: first line, how many, the place."""

    pieces: Sequence[str]
    origins: Sequence[LineOrigins]
    of_line: Sequence[int]
    broken: Sequence[tuple[int, int, Span]]


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
    starts = accumulate(printed.together, initial=0)
    broken = [
        (start, count, place)
        for start, count in zip(starts, printed.together, strict=False)
        if count > 1
        and (place := printed.places[start]) is not None
        and not all(one.is_template for line in printed.origins[start:][:count] for one in line)
    ]
    return _Pattern(
        pieces_of(printed.text),
        list(known),
        [known[origins] for origins in printed.origins],
        broken,
    )


def _origins(pattern: _Pattern, twin: Twin, text: str) -> tuple[LineOrigins, ...]:
    source = twin.unit.source
    own = [tuple([twin.origins[origin] for origin in origins]) for origins in pattern.origins]
    found = [own[number] for number in pattern.of_line]
    lines = text.split("\n")
    for start, count, place in pattern.broken:
        end = start + count
        found[start:end] = line_origins(lines[start:end], Span(source, place.start, place.end))
    return tuple(found)
