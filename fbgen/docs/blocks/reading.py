"""The interface of a block and what its comments say about it."""

import re
from collections.abc import Iterable, Iterator

from fbgen.dataclass import dataclass
from fbgen.lang import ast

_HEAD = re.compile(r"(\w+): (.*)", re.DOTALL)
_NOTES = {
    "Timing": "Timing",
    "Zeit": "Timing",
    "Zeiten": "Timing",
    "Limits": "Limits",
    "Grenzen": "Limits",
}
_SOURCES = ("Facts", "Quelle")
"""How the lines of a head begin, in the languages that blocks are generated in."""
_DIRECTIONS = {"VAR_INPUT": "in", "VAR_OUTPUT": "out", "VAR_IN_OUT": "in and out"}
_COMMENTS = (ast.TriviaKind.LINE_COMMENT, ast.TriviaKind.BLOCK_COMMENT)


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter, or what the block keeps: `direction` is "in", "out", "in and out" or "kept"."""

    direction: str
    name: str
    type: str
    default: str
    meaning: str


@dataclass(frozen=True, slots=True)
class BlockText:
    """A block as a person reads it; `notes` are the rows `Timing` and `Limits` of its head."""

    title: str
    notes: tuple[tuple[str, str], ...]
    facts: tuple[str, ...]
    behaviour: tuple[str, ...]
    parameters: tuple[Parameter, ...]
    kept: tuple[Parameter, ...]


def read_block(block: ast.Block) -> BlockText:
    """From its head, its declarations and the comment at its beginning."""
    head = [found for text in _joined(block.leading) if (found := _HEAD.fullmatch(text))]
    title = next((item.text for item in block.header if item.keyword == "TITLE"), "")
    parameters, kept = [], []
    for section in block.sections:
        rows = list(_rows(section))
        if section.keyword in _DIRECTIONS:
            parameters += rows
        elif section.keyword == "VAR":
            kept += rows
    notes = tuple((_NOTES[one[1]], one[2]) for one in head if one[1] in _NOTES)
    facts = tuple(dict.fromkeys(one[2] for one in head if one[1] in _SOURCES))
    first = block.body[0] if block.body else None
    leading = (*block.body_comments, *(first.leading if first is not None else ()))
    return BlockText(
        title.strip(), notes, facts, tuple(_paragraphs(leading)), tuple(parameters), tuple(kept)
    )


def comment_text(trivia: ast.Trivia) -> str:
    """A comment without its delimiters."""
    text = trivia.text
    if trivia.kind is ast.TriviaKind.LINE_COMMENT:
        return text.removeprefix("//").strip()
    return text.removeprefix("(*").removeprefix("/*").removesuffix("*)").removesuffix("*/").strip()


def _rows(section: ast.VarSection) -> Iterator[Parameter]:
    direction = _DIRECTIONS.get(section.keyword, "kept")
    for number, declaration in enumerate(section.declarations):
        meaning = " ".join(_meaning(section, number))
        default = declaration.initial.span.text if declaration.initial is not None else ""
        for name in declaration.names:
            kind = declaration.type.span.text.replace('"', "")
            yield Parameter(direction, name.name, kind, default, meaning)


def _meaning(section: ast.VarSection, number: int) -> Iterator[str]:
    """The comment behind a declaration, which goes on in the lines below it."""
    declaration = section.declarations[number]
    if declaration.trailing is None:
        return
    yield comment_text(declaration.trailing)
    last = number + 1 == len(section.declarations)
    below = section.closing if last else section.declarations[number + 1].leading
    for trivia in below:
        if trivia.kind not in _COMMENTS or trivia.span.column < declaration.trailing.span.column:
            return
        yield comment_text(trivia)


def _joined(trivia: Iterable[ast.Trivia]) -> Iterator[str]:
    """Lines of a head, those that go on in the next line as one."""
    found: list[str] = []
    for one in trivia:
        if one.kind is not ast.TriviaKind.LINE_COMMENT:
            continue
        raw = one.text.removeprefix("//")
        if found and (raw.startswith("   ") or not _HEAD.fullmatch(raw.strip())):
            found[-1] += f" {raw.strip()}"
        else:
            found.append(raw.strip())
    yield from found


def _paragraphs(trivia: Iterable[ast.Trivia]) -> Iterator[str]:
    """Comment lines up to a blank line, as paragraphs: an empty comment line parts them."""
    lines: list[str] = []
    for one in trivia:
        text = comment_text(one) if one.kind in _COMMENTS else ""
        if text.startswith("---"):
            break
        if text:
            lines.append(text)
        elif lines:
            yield " ".join(lines)
            lines = []
            if one.kind is ast.TriviaKind.BLANK_LINE:
                return
    if lines:
        yield " ".join(lines)
