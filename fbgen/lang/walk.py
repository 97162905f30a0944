"""Every node of a syntax tree, for rules that look at all of them."""

from collections.abc import Iterator

from fbgen.lang import ast

_PARTS: dict[type, tuple[str, ...]] = {
    kind: tuple(name for name in vars(kind)["__slots__"] if name != "span")
    for kind in vars(ast).values()
    if isinstance(kind, type) and "span" in getattr(kind, "__slots__", ())
} | {ast.File: ("units",)}
"""What hangs on each kind of node."""


def walk(root: object) -> Iterator[object]:
    """The node and everything below it, in no particular order. Deep trees are no problem."""
    waiting = [root]
    while waiting:
        item = waiting.pop()
        kind = type(item)
        if kind is tuple:
            waiting += item  # type: ignore[arg-type]
        elif (parts := _PARTS.get(kind)) is not None:
            if kind is not ast.File:
                yield item
            waiting += [getattr(item, name) for name in parts]
