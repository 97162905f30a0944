"""A checked tree with one of its nodes exchanged. The rest is shared with the tree it came from."""

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import Any, TypeAlias

from fbgen.lang import checked
from fbgen.lang.checked import Branch, CaseArm, Expression, Statement

Node: TypeAlias = Expression | Statement | Branch | CaseArm

_LEAVES = (
    checked.Variable,
    checked.Block,
    checked.StandardBlock,
    checked.Address,
    checked.Program,
    checked.Task,
    checked.BlockMembers,
)
_NODES = tuple(
    kind
    for name in checked.__all__
    if isinstance(kind := getattr(checked, name), type)
    and "span" in getattr(kind, "__slots__", ())
    and kind not in _LEAVES
)
"""What the statements of a block are made of."""


def is_node(item: object) -> bool:
    """True for a statement, an expression, or a part of one of them."""
    return isinstance(item, _NODES)


_PARTS: dict[type, tuple[str, ...]] = {
    kind: tuple(one.name for one in fields(kind) if one.name != "span") for kind in _NODES
}


def parts_of(item: object) -> tuple[str, ...]:
    """The fields of a node, but for its place."""
    return _PARTS[type(item)]


def with_nodes(
    body: Sequence[Statement], exchanged: dict[Node, tuple[Node, ...]]
) -> tuple[Statement, ...]:
    """The statements with some nodes exchanged.

    What takes the place of a statement may be several, or none; what takes the place of anything
    else is one. What stands inside of an exchanged node is left as it is.
    """
    by_identity = {id(old): new for old, new in exchanged.items()}
    rebuilt: tuple[Statement, ...] = _rebuilt(tuple(body), by_identity)
    return rebuilt


def _rebuilt(item: Any, exchanged: dict[int, tuple[Node, ...]]) -> Any:
    if type(item) is tuple:
        parts: list[object] = []
        changed = False
        for part in item:
            new = exchanged.get(id(part))
            if new is not None:
                parts += new
                changed = True
                continue
            other = _rebuilt(part, exchanged)
            changed = changed or other is not part
            parts.append(other)
        return tuple(parts) if changed else item
    if not is_node(item):
        return item
    changes: dict[str, object] = {}
    for name in parts_of(item):
        part = getattr(item, name)
        new = exchanged.get(id(part))
        other = _rebuilt(part, exchanged) if new is None else new[0]
        if other is not part:
            changes[name] = other
    return replace(item, **changes) if changes else item
