"""A checked tree as text, without its places: two trees that mean the same have the same."""

from collections.abc import Iterator

from fbgen.lang.checked import AnyBlock, Variable
from harness.verify.mutation.rebuilding import is_node, parts_of


def meaning(item: object) -> list[str]:
    """What a tree says, node after node; the names of variables without regard to the program."""
    return list(_said(item))


def _said(item: object) -> Iterator[str]:
    if isinstance(item, tuple):
        yield f"({len(item)}"
        for part in item:
            yield from _said(part)
    elif is_node(item):
        yield type(item).__name__
        for name in parts_of(item):
            yield from _said(getattr(item, name))
    elif isinstance(item, Variable | AnyBlock):
        yield item.name
    else:
        yield str(item)
