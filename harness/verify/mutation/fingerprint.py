"""Whether two programs have the same block: the same variables, statements and constants."""

import hashlib
from collections.abc import Iterator, Sequence

from fbgen.lang.checked import AnyBlock, Block, Constant, Statement, Variable
from harness.engine.compiled.generation import room_for_generation
from harness.verify.mutation.rebuilding import is_node, parts_of


def fingerprint(block: Block, body: Sequence[Statement]) -> str:
    """The same for two blocks exactly if they have the same mutants, that do the same."""
    with room_for_generation():
        parts = [block.name, *_variables(block), *_written(tuple(body))]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def text_of(item: object) -> str:
    """The same for two statements exactly if they do the same with the same variables."""
    return "\n".join(_written(item))


def _variables(block: Block) -> Iterator[str]:
    for variable in block.variables:
        yield f"{variable.name} {variable.kind.value} {variable.type} {variable.initial}"


def _written(item: object) -> Iterator[str]:
    if isinstance(item, tuple):
        yield f"({len(item)}"
        for part in item:
            yield from _written(part)
    elif is_node(item):
        yield type(item).__name__
        if isinstance(item, Constant):
            yield item.span.text
        for name in parts_of(item):
            yield from _written(getattr(item, name))
    elif isinstance(item, Variable):
        yield f"{item.name} {item.kind.value}"
    elif isinstance(item, AnyBlock):
        yield item.name
    else:
        yield str(item)
