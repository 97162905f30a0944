"""A source line as a terminal can show it, with carets under a place in it.

Files hold anything: lines of a megabyte, tabs, wide characters, and control characters that would
clear the screen or turn the direction of writing. None of that may hide what a message says.
"""

from unicodedata import combining, east_asian_width

from fbgen.dataclass import dataclass
from fbgen.source import Span

_LONGEST = 200
"""Characters of a line that are shown; of a longer one the part around the place."""
_BEFORE = 80
_CUT = "..."

_TURNING = (*range(0x202A, 0x202F), *range(0x2066, 0x206A))
"""Characters that change the direction of what follows."""
_HARMFUL = dict.fromkeys(
    [code for code in (*range(0x20), *range(0x7F, 0xA0), *_TURNING) if chr(code) not in "\t\n"],
    "\N{REPLACEMENT CHARACTER}",
)


@dataclass(frozen=True, slots=True)
class ShownLine:
    """The text of a line, the room in front of the carets, and the carets."""

    text: str
    pad: str
    carets: str


def harmless(text: str) -> str:
    """The text without what a terminal would take for a command."""
    return text.translate(_HARMFUL)


def shown_line(span: Span) -> ShownLine:
    """The first line of a place, cut if it is long."""
    line = harmless(span.source.line_text(span.line))
    start = span.column - 1
    end = span.end_column - 1 if span.end_line == span.line else len(line)
    first = max(0, start - _BEFORE) if len(line) > _LONGEST else 0
    last = first + _LONGEST
    before = _CUT if first else ""
    behind = _CUT if last < len(line) else ""
    pad = " " * len(before) + "".join(map(_blank, line[first:start]))
    marked = sum(map(_columns, line[start : min(end, last)]))
    return ShownLine(f"{before}{line[first:last]}{behind}", pad, "^" * max(1, marked))


def _blank(char: str) -> str:
    return "\t" if char == "\t" else " " * _columns(char)


def _columns(char: str) -> int:
    """How many columns of a terminal a character takes."""
    if combining(char):
        return 0
    return 2 if east_asian_width(char) in {"W", "F"} else 1
