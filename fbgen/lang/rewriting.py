"""Trees rebuilt piece by piece: what a conversion changes, and everything else as it was.

A conversion is a `Rewriter` with a rule for each kind of node that it says otherwise. Nodes without
a rule come back themselves where nothing in them changed. A rule for a statement may give several
statements, or none; comments of what falls away go to the statement that follows.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar, TypeAlias, TypeVar

from fbgen.lang import ast
from fbgen.lang.ast import Empty, Expression, Statement, Trivia, TriviaList

Rule: TypeAlias = Callable[[Any, Any], object]
_N = TypeVar("_N")

_PARTS: dict[type, tuple[str, ...]] = {
    kind: tuple(name for name in vars(kind)["__slots__"] if name != "span")
    for kind in vars(ast).values()
    if isinstance(kind, type) and "span" in getattr(kind, "__slots__", ())
}

_LISTS = ("body", "closing")
"""The parts that are a list of statements, which `Rewriter.statements` rewrites together."""

_OTHERS: dict[type, tuple[str, ...]] = {
    kind: tuple(name for name in parts if name not in _LISTS) if "body" in parts else parts
    for kind, parts in _PARTS.items()
}


class Rewriter:
    """Rebuilds trees by `rules`, which are keyed by the kind of node."""

    rules: ClassVar[Mapping[type, Rule]] = {}

    def rewrite(self, node: Any) -> Any:
        """What stands in the place of a node."""
        rule = self.rules.get(type(node))
        return self.inside(node) if rule is None else rule(self, node)

    def inside(self, node: _N) -> _N:
        """The same node with everything in it rewritten; itself if nothing changed."""
        kind = type(node)
        if isinstance(node, ast.Binary):
            return self._chain(node)  # type: ignore[return-value]  # a chain may end as any operand
        changes: dict[str, object] = {}
        for name in _OTHERS[kind]:
            value = getattr(node, name)
            if type(value) is tuple:
                new = self._items(value) if value else value
            else:
                new = self.rewrite(value) if type(value) in _PARTS else value
            if new is not value:
                changes[name] = new
        if _OTHERS[kind] is not _PARTS[kind]:
            before: Any = node
            lists = before.body, before.closing
            for name, old, new in zip(_LISTS, lists, self.statements(*lists), strict=True):
                if new is not old:
                    changes[name] = new
        return replaced(node, **changes) if changes else node

    def statements(
        self, statements: tuple[Statement, ...], closing: TriviaList
    ) -> tuple[tuple[Statement, ...], TriviaList]:
        """A list of statements and the comments behind it."""
        result: list[Statement] = []
        waiting: list[Trivia] = []
        for statement in statements:
            self._one_statement(statement, result, waiting)
        if not result and statements:
            result.append(Empty(statements[-1].span, tuple(waiting)))
            waiting.clear()
        same = len(result) == len(statements) and all(
            new is old for new, old in zip(result, statements, strict=True)
        )
        return statements if same else tuple(result), (*waiting, *closing) if waiting else closing

    def _one_statement(
        self, statement: Statement, result: list[Statement], waiting: list[Trivia]
    ) -> None:
        """Append what stands in the place of a statement; `waiting` comments go to its front."""
        rewritten = self.rewrite(statement)
        if isinstance(rewritten, Inlined):
            waiting += rewritten.opening
            for inner in rewritten.body:
                self._one_statement(inner, result, waiting)
            waiting += rewritten.closing
            return
        pieces = rewritten if isinstance(rewritten, tuple) else (rewritten,)
        for piece in pieces:
            if waiting:
                piece = with_leading(piece, (*waiting, *piece.leading))
                waiting.clear()
            result.append(piece)

    def _items(self, items: tuple[object, ...]) -> tuple[object, ...]:
        """What stands in the place of nodes and others; the same tuple if nothing changed."""
        changed = False
        result: list[object] = []
        for item in items:
            new = self.rewrite(item) if type(item) in _PARTS else item
            changed = changed or new is not item
            result += new if type(new) is tuple else (new,)
        return tuple(result) if changed else items

    def _chain(self, node: ast.Binary) -> Expression:
        """A chain of operands, down its left side without recursion."""
        links: list[ast.Binary] = []
        left: Expression = node
        while type(left) is ast.Binary:
            links.append(left)
            left = left.left
        result: Expression = self.rewrite(left)
        for link in reversed(links):
            result = self.link(link, result, self.rewrite(link.right))
        return result

    def link(self, node: ast.Binary, left: Expression, right: Expression) -> Expression:
        """One operator with its rewritten operands."""
        if left is node.left and right is node.right:
            return node
        return ast.Binary(node.span, node.operator, left, right)


def rewritten(
    files: Sequence[ast.File], dialect: str, rewriter: Callable[[ast.Unit], Rewriter]
) -> list[ast.File]:
    """The files in another dialect, with a rewriter of its own for each unit."""
    return [
        ast.File(
            file.source,
            dialect,
            tuple(rewriter(unit).rewrite(unit) for unit in file.units),
            file.closing,
        )
        for file in files
    ]


class Inlined:
    """In the place of a statement: these, not yet rewritten, and the comments around them."""

    __slots__ = ("body", "closing", "opening")

    def __init__(
        self, opening: TriviaList, body: tuple[Statement, ...], closing: TriviaList
    ) -> None:
        self.opening = opening
        self.body = body
        self.closing = closing


def with_leading(statement: Statement, leading: TriviaList) -> Statement:
    """The same statement with other comments in front."""
    return replaced(statement, leading=leading)


def replaced(node: _N, **changes: object) -> _N:
    """The same node with other parts."""
    kind: Any = type(node)
    parts = {name: getattr(node, name) for name in ("span", *_PARTS[kind])}
    rebuilt: _N = kind(**{**parts, **changes})
    return rebuilt
