"""What CODESYS and TwinCAT convert by themselves, written out where the standard wants it written.

The checker says in `twincat` which values become others on the way. Where `iec` would not do that,
the function stands around the same piece of text. A number that becomes an enumeration has no
function, and is refused.
"""

from collections.abc import Iterator, Sequence
from typing import Any, TypeAlias

from fbgen.lang.ast import Argument, ArgumentKind, Binary, Call, Expression, File, Name
from fbgen.lang.checked import Convert, Program
from fbgen.lang.checker import RULES, check_reporting
from fbgen.lang.checker.types.conversions import conversion_between, is_implicit
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.rewriting import Rewriter
from fbgen.lang.types import Enumeration, Type
from fbgen.source import Span

_Key: TypeAlias = tuple[str, int, int]
_LEAVES = frozenset(
    ("span", "type", "syntax", "block", "function", "variable", "overrides", "result")
)


def with_written_conversions(files: Sequence[File], findings: Findings) -> list[File]:
    """The same program of `twincat`, where `iec` has nothing to convert by itself.

    A program with errors comes back as it is.
    """
    program, _ = check_reporting(files, "twincat")
    if program is None:
        return list(files)
    wanted: dict[_Key, list[Convert]] = {}
    for node in _conversions(program):
        if not is_implicit(node.operand.type, node.type, RULES["iec"]):
            wanted.setdefault(_key(node.span), []).append(node)
    rewriter = _Writing(wanted, findings)
    return [
        File(file.source, file.dialect, tuple(map(rewriter.rewrite, file.units)), file.closing)
        for file in files
    ]


def _conversions(program: Program) -> Iterator[Convert]:
    """What the program converts by itself, the innermost of one piece of text first."""
    waiting: list[Any] = list(program.bodies.values())
    found: list[Convert] = []
    while waiting:
        item = waiting.pop()
        if isinstance(item, tuple):
            waiting += item
            continue
        if isinstance(item, Convert) and item.implicit:
            found.append(item)
        for name in getattr(type(item), "__slots__", ()):
            if name not in _LEAVES:
                waiting.append(getattr(item, name))
    return reversed(found)


def _key(span: Span) -> _Key:
    return (span.source.name, span.start, span.end)


class _Writing(Rewriter):
    def __init__(self, wanted: dict[_Key, list[Convert]], findings: Findings) -> None:
        self._wanted = wanted
        self._findings = findings

    def rewrite(self, node: Any) -> Any:
        """What stands in the place of a node; chains are written link by link."""
        written = super().rewrite(node)
        if isinstance(node, Expression) and not isinstance(node, Binary):
            return self._around(node, written)
        return written

    def link(self, node: Binary, left: Expression, right: Expression) -> Expression:
        """One operator with its rewritten operands."""
        return self._around(node, super().link(node, left, right))

    def _around(self, node: Expression, written: Expression) -> Expression:
        for conversion in self._wanted.pop(_key(node.span), ()):
            function = self._function(conversion.operand.type, conversion.type, node.span)
            argument = Argument(node.span, ArgumentKind.POSITIONAL, "", written)
            written = Call(node.span, Name(node.span, function), (argument,))
        return written

    def _function(self, source: Type, target: Type, span: Span) -> str:
        if isinstance(target, Enumeration):
            hint = f"write an enumerator of {target.name}"
            self._findings.refuse("a number that becomes an enumeration", span, hint)
        if isinstance(source, Enumeration):
            return f"TO_{target.name}"
        return conversion_between(source, target) or f"TO_{target.name}"
