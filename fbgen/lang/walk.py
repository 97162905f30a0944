"""Every node of a syntax tree, for rules that look at all of them; two trees side by side."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from enum import Enum
from operator import attrgetter
from typing import Any

from fbgen.lang import ast

_VALUES = (str, bool, int, float, bool | int | float | str, tuple[str, ...])
"""Annotations of fields that hold no nodes; fields with members of an Enum do not, either."""


def _holds_nodes(annotation: object) -> bool:
    is_member = isinstance(annotation, type) and issubclass(annotation, Enum)
    return not is_member and annotation not in _VALUES


def _getter(names: Sequence[str]) -> Callable[[Any], tuple[Any, ...]]:
    if len(names) > 1:
        return attrgetter(*names)
    if names:
        only = attrgetter(names[0])
        return lambda item: (only(item),)
    return lambda item: ()


_PARTS: dict[type, Callable[[Any], tuple[Any, ...]]] = {
    kind: _getter(
        [
            name
            for name in vars(kind)["__slots__"]
            if name != "span" and _holds_nodes(kind.__annotations__[name])
        ]
    )
    for kind in vars(ast).values()
    if isinstance(kind, type) and "span" in getattr(kind, "__slots__", ())
} | {ast.File: _getter(["units"])}
"""What hangs on each kind of node: nodes, tuples of them, None."""


def walk(root: object) -> Iterator[object]:
    """The node and everything below it, in no particular order. Deep trees are no problem."""
    waiting: list[Any] = [root]
    while waiting:
        item = waiting.pop()
        kind = type(item)
        if kind is tuple:
            waiting += item
        elif (parts := _PARTS.get(kind)) is not None:
            if kind is not ast.File:
                yield item
            waiting += parts(item)


def by_kind(root: object) -> Mapping[type, Sequence[Any]]:
    """What `walk` finds, by the types of the nodes, in one go."""
    kinds: defaultdict[type, list[Any]] = defaultdict(list)
    waiting: list[Any] = [root]
    while waiting:
        item = waiting.pop()
        kind = type(item)
        if kind is tuple:
            waiting += item
        elif (parts := _PARTS.get(kind)) is not None:
            kinds[kind].append(item)
            waiting += parts(item)
    kinds.pop(ast.File, None)
    return dict(kinds)


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
            waiting += zip(parts(one), parts(other), strict=True)


def _without_blank_lines(items: tuple[object, ...]) -> tuple[object, ...]:
    return tuple(
        item
        for item in items
        if not (isinstance(item, ast.Trivia) and item.kind is ast.TriviaKind.BLANK_LINE)
    )
