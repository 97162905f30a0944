"""Function blocks without a model: the controller's hardware blocks, and what a stub stands for.

An instance of one has the outputs that are known of it; what a call does is up to the user's stub.
"""

from functools import cache

from fbgen.lang.checked import StandardBlock, Variable, VariableKind
from fbgen.lang.checker.routines.hardware import BLOCK_ALIASES, HARDWARE_BLOCKS
from fbgen.lang.checker.routines.signature import read_signature
from fbgen.source import Source, Span

_NOWHERE = Span(Source("instructions without a model", ""), 0, 0)


@cache
def hardware_block(name: str) -> StandardBlock | None:
    """The hardware block with that name, whatever its case and spelling."""
    key = name.upper()
    key = BLOCK_ALIASES.get(key, key)
    text = HARDWARE_BLOCKS.get(key)
    if text is None:
        return None
    routine = read_signature(key, f"({text})", modelled=False)
    outputs = (
        Variable(_NOWHERE, parameter.name, VariableKind.OUTPUT, parameter.types[0])
        for parameter in routine.parameters
    )
    return StandardBlock(key, tuple(outputs))


@cache
def stubbed_block(name: str) -> StandardBlock:
    """A block of which nothing is known but that a stub stands for it."""
    return StandardBlock(name, ())
