"""Every node of a syntax tree, for rules that look at all of them."""

from collections.abc import Iterator

from fbgen.lang import ast
from fbgen.source import Span

_NODES = tuple(
    kind
    for kind in vars(ast).values()
    if isinstance(kind, type) and "span" in getattr(kind, "__slots__", ())
)


def walk(root: object) -> Iterator[object]:
    """The node and everything below it, in no particular order. Deep trees are no problem."""
    waiting = [root]
    while waiting:
        item = waiting.pop()
        if isinstance(item, tuple):
            if not isinstance(item, Span):
                waiting += item
        elif isinstance(item, _NODES):
            yield item
            waiting += [getattr(item, name) for name in item.__slots__ if name != "span"]  # type: ignore[attr-defined]
        elif isinstance(item, ast.File):
            waiting.append(item.units)
