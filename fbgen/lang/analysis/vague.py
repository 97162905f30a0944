"""Variables of statements with errors: nobody knows what these statements do to them."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from fbgen.lang import ast
from fbgen.lang.checked import Variable
from fbgen.lang.walk import walk

if TYPE_CHECKING:
    from fbgen.lang.checker.context import Context

_BODIES = frozenset(("body", "branches", "otherwise", "arms"))


def vague_variables(ctx: "Context", block: ast.Block, errors: Sequence[int]) -> frozenset[Variable]:
    """The variables in statements of the block that have an error at one of these offsets."""
    found: set[Variable] = set()
    for statement in _with_error(block.body, errors):
        for node in walk(statement):
            if isinstance(node, ast.Name):
                entry = ctx.scope.entries.get(node.name.casefold())
                if isinstance(entry, Variable):
                    found.add(entry)
    return frozenset(found)


def _with_error(body: Sequence[Any], errors: Sequence[int]) -> Iterator[Any]:
    """The smallest statements, or heads of statements, with an error in them.

    A FOR with an error in its head is left out as a whole, so all of it counts.
    """
    for statement in body:
        inside = [one for one in errors if statement.span.start <= one < statement.span.end]
        if not inside:
            continue
        parts = [
            getattr(statement, name, None)
            for name in _BODIES
            if getattr(statement, name, None) is not None
        ]
        if not parts:
            yield statement
            continue
        nested: list[Any] = []
        for part in parts:
            nested += part if isinstance(part, tuple) else (part,)
        left = [
            one
            for one in inside
            if not any(inner.span.start <= one < inner.span.end for inner in nested)
        ]
        if left:
            yield statement
        else:
            yield from _with_error(nested, inside)
