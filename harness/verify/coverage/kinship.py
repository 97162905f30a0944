"""What the parts of a generated block are called, the same in each text of one template.

A plant, a dialect or a layout makes another text of the same template. A statement is the same one
in two of them if it comes from the same line of the template, is of the same kind, stands in the
same way on from the same branching, and is the same one of those that the line makes there: the
second drive's in a loop over the drives, whatever the drive is called. What a dialect adds, such as
copies of structures, is a statement of its own.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from fbgen.lang.checked import (
    Case,
    Expression,
    For,
    Guarded,
    If,
    Repeat,
    Statement,
    Try,
    While,
)
from fbgen.source import Source
from harness.engine.compiled.walk import Node

Body = Sequence[Statement]
TemplateLines = Mapping[int, tuple[str, int]]
"""File and line of the template by the lines of a text."""


class Kinship:
    """The names of the parts of one block. `template` is "" for a text that a person wrote."""

    def __init__(self, lines: TemplateLines, first_line: int, body: Body) -> None:
        self._lines = lines
        self.template = lines.get(first_line, ("", 0))[0]
        self._names: dict[int, str] = {}
        self._taken: Counter[str] = Counter()
        if self.template:
            self._name_all(body)

    def of(self, node: Node) -> str:
        """The name of a statement, or of a condition of IF; "" for what is inside of expressions.

        It is "" for everything in a text that a person wrote.
        """
        return self._names.get(id(node), "")

    def below(self, owner: str, node: Expression) -> str:
        """A name for an expression that belongs to `owner`; each call gives another one."""
        return self._numbered(f"{owner}:{self._place(node.span.line)}")

    def _name_all(self, body: Body) -> None:
        waiting: list[tuple[str, Body]] = [("", body)]
        while waiting:
            parent, statements = waiting.pop()
            for node in statements:
                inner = node.statement if isinstance(node, Guarded) else node
                kind = _LETTERS.get(type(inner), type(inner).__name__)
                name = self._numbered(f"{parent}{self._place(node.span.line)}{kind}")
                self._names[id(node)] = self._names[id(inner)] = name
                if isinstance(inner, If):
                    for number, branch in enumerate(inner.branches):
                        self._names[id(branch)] = f"{name}?{number}"
                waiting += [(f"{name}>{way}/", inside) for way, inside in _ways(inner)]

    def _numbered(self, name: str) -> str:
        """The first one has the plain name, the others of it are counted."""
        self._taken[name] += 1
        return name if self._taken[name] == 1 else f"{name}*{self._taken[name]}"

    def _place(self, line: int) -> str:
        """A line of the template, with its file if that is another one than the block's."""
        file, number = self._lines.get(line, ("", 0))
        return str(number) if file == self.template else f"{file}:{number}"


_LETTERS: Mapping[type, str] = {If: "I", Case: "C", For: "F", While: "W", Repeat: "R"}


def _ways(node: Statement) -> Iterator[tuple[str, Body]]:
    """The statements inside of a statement, each list with a name."""
    match node:
        case If():
            yield from ((str(number), branch.body) for number, branch in enumerate(node.branches))
            yield "else", node.otherwise
        case Case():
            for arm in node.arms:
                yield ",".join(f"{first}..{last}" for first, last in arm.ranges), arm.body
            yield "else", node.otherwise
        case For() | While() | Repeat():
            yield "", node.body
        case Try():
            yield from (("try", node.body), ("catch", node.catch), ("final", node.final))


def template_lines(source: Source) -> TemplateLines:
    """Where the lines of a generated file are from; it may be XML with the text inside."""
    return {
        source.line_column(offset)[0]: (origin.file, origin.line)
        for offset, origin in source.origins
        if origin is not None and origin.is_template
    }
