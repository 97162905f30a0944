"""Every node of a syntax tree, for rules that look at all of them; two trees side by side."""

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


def side_by_side(first: object, second: object) -> Iterator[tuple[object, object]]:
    """The nodes of two trees, each with the one in its place. Where they differ in kind or number
    nothing below is looked at; empty lines do not count."""
    waiting = [(first, second)]
    while waiting:
        one, other = waiting.pop()
        if type(one) is not type(other):
            continue
        if isinstance(one, tuple) and isinstance(other, tuple) and type(one) is tuple:
            if len(one) != len(other):
                one, other = _without_blank_lines(one), _without_blank_lines(other)
            if len(one) == len(other):
                waiting += zip(one, other, strict=True)
        elif (parts := _PARTS.get(type(one))) is not None:
            yield one, other
            waiting += [(getattr(one, name), getattr(other, name)) for name in parts]


def _without_blank_lines(items: tuple[object, ...]) -> tuple[object, ...]:
    return tuple(
        item
        for item in items
        if not (isinstance(item, ast.Trivia) and item.kind is ast.TriviaKind.BLANK_LINE)
    )
