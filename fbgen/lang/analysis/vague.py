"""Variables of statements with errors: nobody knows what these statements do to them.

The same goes for what methods, properties and actions mention, which are no part of the body.
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from fbgen.lang import ast
from fbgen.lang.checked import Variable
from fbgen.lang.other_languages import bodies, is_foreign
from fbgen.lang.walk import walk

if TYPE_CHECKING:
    from fbgen.lang.checker.context import Context

_BODIES = frozenset(("body", "branches", "otherwise", "arms"))


def vague_variables(ctx: "Context", block: ast.Block, errors: Sequence[int]) -> frozenset[Variable]:
    """The variables in what has an error at one of these offsets, and in methods and actions."""
    if any(is_foreign(body) for body in bodies(block)):
        return frozenset(one for one in ctx.scope.entries.values() if isinstance(one, Variable))
    unclear: list[object] = [*_with_error(block.body, errors), *block.members]
    unclear += [
        declaration
        for section in block.sections
        for declaration in section.declarations
        if any(declaration.span.start <= one < declaration.span.end for one in errors)
    ]
    found: set[Variable] = set()
    for part in unclear:
        for node in walk(part):
            if isinstance(node, ast.Name | ast.DeclaredName):
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
