"""Lines of a GSD file -> statements and the blocks they stand in.

    Keyword = value           Keyword(3) = value           Keyword value
    Module = "name" 0x30,0x70 ... EndModule                and the other blocks of `keywords`

What no keyword is needed for is kept as it stands. A block ends at its last line, or where another
one begins that cannot stand in it.
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.source import Span
from fbgen.wire.gsd.keywords import BLOCKS, MAY_STAND_ALONE, NESTED
from fbgen.wire.gsd.lines import Kind, Line, Token, unreadable

_NUMBER = re.compile(r"0[xX][0-9A-Fa-f]+|[0-9]+")
_LONGEST_NUMBER = 20
_ENDS = {end.lower(): begin for begin, end in BLOCKS.items()}


@dataclass(frozen=True, slots=True)
class Statement:
    """A line: its keyword, the numbers in parentheses behind that, its value.

    A line that is a number alone, the reference of a module, has no keyword ("").
    """

    keyword: str
    keyword_span: Span
    index: tuple[int, ...]
    value: tuple[Token, ...]

    @property
    def key(self) -> str:
        """The keyword in small letters: upper and lower case are the same."""
        return self.keyword.lower()

    @property
    def span(self) -> Span:
        """The whole line."""
        return self.keyword_span.to(self.value[-1].span) if self.value else self.keyword_span

    @property
    def value_span(self) -> Span:
        """The value, or the keyword where there is none."""
        return self.value[0].span.to(self.value[-1].span) if self.value else self.keyword_span


@dataclass(frozen=True, slots=True)
class Block:
    """Statements between the line that begins a block and the one that ends it."""

    head: Statement
    statements: tuple[Statement, ...]
    blocks: tuple["Block", ...]


@dataclass(slots=True)
class _Open:
    head: Statement | None
    statements: list[Statement] = field(default_factory=list)
    blocks: list[Block] = field(default_factory=list)

    @property
    def key(self) -> str:
        return self.head.key if self.head is not None else ""


@dataclass(frozen=True, slots=True)
class Tree:
    """A file: what stands outside of all blocks, and the blocks. `findings` are FB1302, FB1304."""

    statements: tuple[Statement, ...]
    blocks: tuple[Block, ...]
    findings: tuple[Diagnostic, ...]

    def blocks_of(self, keyword: str) -> Iterator[Block]:
        """The blocks that begin with a keyword."""
        return (block for block in self.blocks if block.head.key == keyword.lower())


def gsd_tree(lines: Iterable[Line]) -> Tree:
    """The statements of a file in their blocks."""
    builder = _Builder()
    for line in lines:
        builder.add(line)
    return builder.finished()


def number_of(text: str) -> int | None:
    """`12`, `0x0C` -> 12; None for what is no number."""
    if len(text) > _LONGEST_NUMBER or not _NUMBER.fullmatch(text):
        return None
    return int(text, 16) if text[1:2] in ("x", "X") else int(text)


@dataclass(slots=True)
class _Builder:
    stack: list[_Open] = field(default_factory=lambda: [_Open(None)])
    findings: list[Diagnostic] = field(default_factory=list)

    def add(self, line: Line) -> None:
        first = line.tokens[0]
        if first.kind is not Kind.WORD:
            self.findings.append(unreadable(line, f"no keyword begins with {first.span.text[:1]}"))
            return
        self.findings += [_open_text(one) for one in line.tokens if one.kind is Kind.OPEN]
        statement = _statement(line)
        key = statement.key
        if key in _ENDS:
            self._end(statement, _ENDS[key])
        elif key in BLOCKS:
            self._begin(statement)
        else:
            self.stack[-1].statements.append(statement)

    def finished(self) -> Tree:
        while len(self.stack) > 1:
            self._not_ended("the file ends")
        outside = self.stack[0]
        return Tree(tuple(outside.statements), tuple(outside.blocks), tuple(self.findings))

    def _begin(self, head: Statement) -> None:
        outer = NESTED.get(head.key, "")
        while len(self.stack) > 1 and self.stack[-1].key != outer:
            self._not_ended(f"{head.keyword} begins")
        self.stack.append(_Open(head))

    def _end(self, statement: Statement, wanted: str) -> None:
        if all(one.key != wanted for one in self.stack):
            self.findings.append(
                Diagnostic(
                    "FB1304",
                    f"{statement.keyword} ends nothing",
                    statement.keyword_span,
                    f"what it ends begins with {_spelled(wanted)}",
                )
            )
            return
        while self.stack[-1].key != wanted:
            self._not_ended(f"{statement.keyword} comes")
        self._close()

    def _not_ended(self, reason: str) -> None:
        head = self.stack[-1].head
        assert head is not None, "the outermost is never closed"
        if head.key in MAY_STAND_ALONE:
            closed = self.stack.pop()
            self.stack[-1].statements += [head, *closed.statements]
            self.stack[-1].blocks += closed.blocks
            return
        self.findings.append(
            Diagnostic(
                "FB1304",
                f"{head.keyword} has no {BLOCKS[head.key]}: {reason} before it",
                head.keyword_span,
                f"write {BLOCKS[head.key]} behind its last line; a file that was cut off while it "
                "was copied has to be copied anew",
            )
        )
        self._close()

    def _close(self) -> None:
        closed = self.stack.pop()
        assert closed.head is not None, "the outermost is never closed"
        block = Block(closed.head, tuple(closed.statements), tuple(closed.blocks))
        self.stack[-1].blocks.append(block)


def _statement(line: Line) -> Statement:
    keyword, *rest = line.tokens
    if number_of(keyword.text) is not None and not (rest and rest[0].text == "="):
        return Statement("", keyword.span, (), line.tokens)
    index: tuple[int, ...] = ()
    if rest and rest[0].text == "(":
        close = next((at for at, one in enumerate(rest) if one.text == ")"), None)
        if close is not None:
            found = [number_of(one.text) for one in rest[1:close]]
            index = tuple(one for one in found if one is not None)
            rest = rest[close + 1 :]
    if rest and rest[0].text == "=" and rest[0].kind is Kind.SIGN:
        rest = rest[1:]
    return Statement(keyword.text, keyword.span, index, tuple(rest))


def _spelled(begin: str) -> str:
    """`module` -> Module: the block that an end belongs to, as its end spells it."""
    return BLOCKS[begin].removeprefix("End").removeprefix("_").removesuffix("_End")


def _open_text(token: Token) -> Diagnostic:
    return Diagnostic(
        "FB1303",
        "the text has no second quote",
        token.span,
        'write " behind it; a text goes on in the next line behind a backslash',
    )
