"""The texts for people in a template, its comments, title and messages, in another language.

A template stays plain SCL with English comments. Its texts are found by their form:

* comments on lines of their own, which are one text where they follow each other;
* comments behind code;
* `TITLE = ...`;
* texts that the code gives a variable, such as `#text := 'unknown trip';`.

A text in another language has as many lines as the English one, so every line of the result keeps
its line of the template. What Jinja fills in (`{{ ... }}`) may stand elsewhere in the text.
"""

import re
from collections.abc import Callable, Iterator

from fbgen.dataclass import dataclass

Translation = Callable[[str], str]
"""A text of a template in another language."""

_OWN_LINE = re.compile(r"( *// ?)(.*)")
_BEHIND = re.compile(r"(.*\S.*? +// )(.*)")
_TITLE = re.compile(r"(TITLE = )(.*)")
_MESSAGE = re.compile(r"(.*:= ')([^']*)(';.*)")
_SECTION = re.compile(r"( *// --- )(.*?)( -+)")
_JINJA = re.compile(r"\{\{.*?\}\}|\{%.*?%\}|\{#.*?#\}")
_LETTER = re.compile(r"[A-Za-z]")


@dataclass(frozen=True, slots=True)
class _Piece:
    """One text: the lines that it takes, and what stands around it on each of them."""

    first: int
    around: tuple[tuple[str, str], ...]
    text: str


def texts_of(template: str) -> list[str]:
    """All texts of a template, in their order."""
    return [piece.text for piece in _pieces(template.split("\n"))]


def translated(template: str, translation: Translation) -> str:
    """The template with its texts in another language, line for line."""
    lines = template.split("\n")
    for piece in _pieces(lines):
        parts = translation(piece.text).split("\n")
        for number, (before, behind) in enumerate(piece.around):
            part = parts[number] if number < len(parts) else ""
            lines[piece.first + number] = _joined(before, part, behind, len(lines[piece.first]))
    return "\n".join(lines)


def _joined(before: str, text: str, behind: str, width: int) -> str:
    """A line; the heading of a section is filled up with dashes as before."""
    if behind.startswith(" --"):
        return f"{before}{text} ".ljust(width, "-")
    return f"{before}{text}{behind}".rstrip()


def _pieces(lines: list[str]) -> Iterator[_Piece]:
    at = 0
    while at < len(lines):
        end = at
        while end < len(lines) and _is_comment(lines[end], lines[at]):
            end += 1
        if end > at:
            found = [_OWN_LINE.fullmatch(line) for line in lines[at:end]]
            parts = [one for one in found if one is not None]
            text = "\n".join(one[2] for one in parts)
            piece = _Piece(at, tuple((one[1], "") for one in parts), text)
            at = end
        else:
            single = _single(lines[at], at)
            at += 1
            if single is None:
                continue
            piece = single
        if _LETTER.search(_JINJA.sub("", piece.text)):
            yield piece


def _is_comment(line: str, first: str) -> bool:
    """Whether a line goes on with the comment that the first one begins: same indent, some text."""
    found, begin = _OWN_LINE.fullmatch(line), _OWN_LINE.fullmatch(first)
    if found is None or begin is None or found[1] != begin[1] or not found[2]:
        return False
    alone = line is first or not (_stands_alone(found[2]) or _stands_alone(begin[2]))
    return alone and not (found[2].startswith("---"))


def _stands_alone(text: str) -> bool:
    """A line that Jinja fills in whole."""
    return not _LETTER.search(_JINJA.sub("", text))


def _single(line: str, at: int) -> _Piece | None:
    if line.lstrip().startswith(("{%", "{#", "{ ")):
        return None
    for found in (_SECTION.fullmatch(line), _TITLE.fullmatch(line), _BEHIND.fullmatch(line)):
        if found is not None:
            behind = found[3] if found.re.groups > 2 else ""
            return _Piece(at, ((found[1], behind),), found[2])
    message = _MESSAGE.fullmatch(line)
    return _Piece(at, ((message[1], message[3]),), message[2]) if message else None
