"""Lines as they are printed: indentation, comments, the origin of each line."""

from fbgen.lang.ast import Trivia, TriviaKind, TriviaList
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.printer.line_origins import LineOrigins, origins_of_lines
from fbgen.source import Span

WIDTH = 100
"""Columns that a line may have before it is broken where it can be."""

_COMMENT_GAP = "   "


class Lines:
    """Collects lines. `level` is the depth of indentation of the next one."""

    def __init__(self, dialect: Dialect) -> None:
        self.level = 0
        self._indent = dialect.indent
        self._line_comments = dialect.has(Feature.LINE_COMMENTS)
        self._lines: list[str] = []
        self._places: list[Span | None] = []
        self._together: list[int] = []

    def text(self) -> str:
        """All lines, each with its LF."""
        return "".join(f"{line}\n" for line in self._lines)

    def places(self) -> tuple[Span | None, ...]:
        """What each line was made from."""
        return tuple(self._places)

    def together(self) -> tuple[int, ...]:
        """How many lines were made from one place, one such number after the other."""
        return tuple(self._together)

    def origins(self) -> tuple[LineOrigins, ...]:
        """Where each line came from."""
        return origins_of_lines(self._lines, self._together, self._places)

    def indentation(self) -> str:
        """What stands in front of a line at this level."""
        return self._indent * self.level

    def add(self, text: str, place: Span | None = None, trailing: Trivia | None = None) -> None:
        """One line, or several if `text` has line ends, with the comment that ends the last."""
        if trailing is not None:
            text += _COMMENT_GAP + self.comment(trailing)
            if place is not None and place.end <= trailing.span.start:
                place = place.to(trailing.span)
        first, *rest = text.split("\n")
        self._together.append(1 + len(rest))
        self._append(self.indentation() + first, place)
        for line in rest:
            self._append(line, place)

    def blank(self) -> None:
        """One empty line, unless there is one or the text begins."""
        if self._lines and self._lines[-1]:
            self._together.append(1)
            self._append("", None)

    def trivia(self, trivia: TriviaList) -> None:
        """Comments, pragmas and blank lines, each on lines of its own."""
        for item in trivia:
            if item.kind is TriviaKind.BLANK_LINE:
                self.blank()
            else:
                self.add(self.comment(item), item.span)

    def comment(self, trivia: Trivia) -> str:
        """A comment as this dialect writes it."""
        if trivia.kind is TriviaKind.LINE_COMMENT and not self._line_comments:
            return block_comment(trivia.text[2:])
        return trivia.text

    def _append(self, line: str, place: Span | None) -> None:
        self._lines.append(line.rstrip())
        self._places.append(place)


def block_comment(text: str) -> str:
    """A text as a `(* *)` comment; marks of comments inside it are taken apart."""
    inner = text.strip().replace("(*", "( *").replace("*)", "* )")
    return f"(* {inner} *)" if inner else "(* *)"


def inline_comment(trivia: Trivia) -> str:
    """A comment that can stand inside a line."""
    if trivia.kind is TriviaKind.LINE_COMMENT:
        return block_comment(trivia.text[2:])
    return trivia.text
