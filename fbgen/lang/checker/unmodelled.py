"""Function blocks without a model: the controller's hardware blocks, and what a stub stands for.

An instance of one has the inputs and outputs that are known of it; what a call does is up to the
user's stub.
"""

from collections.abc import Sequence
from functools import cache

from fbgen.lang import ast
from fbgen.lang.checked import StandardBlock, Variable, VariableKind
from fbgen.lang.checker.routines.hardware_blocks import (
    BLOCK_ALIASES,
    HARDWARE_BLOCKS,
    WORDS,
)
from fbgen.lang.checker.routines.signature import Direction, read_signature
from fbgen.lang.walk import walk
from fbgen.source import Source, Span

_KINDS = {Direction.INPUT: VariableKind.INPUT, Direction.OUTPUT: VariableKind.OUTPUT}
_CLASSIC_TYPES = (
    ("ID UINT", "ID DWORD"),
    ("ID => UINT", "ID => DWORD"),
    ("INDEX DINT", "INDEX INT"),
    ("UDINT", "INT"),
    ("UINT", "INT"),
    ("USINT", "INT"),
)
_NOWHERE = Span(Source("instructions without a model", ""), 0, 0)


@cache
def hardware_block(name: str, dialect: str = "tia") -> StandardBlock | None:
    """The hardware block with that name, whatever its case and spelling.

    In `step7` it has that system's types, which has none without a sign.
    """
    key = name.upper()
    key = BLOCK_ALIASES.get(key, key)
    text = HARDWARE_BLOCKS.get(key)
    if text is None or (key in WORDS and dialect not in ("tia", "step7")):
        return None
    for newer, older in _CLASSIC_TYPES if dialect == "step7" else ():
        text = text.replace(newer, older)
    routine = read_signature(key, f"({text})", modelled=False)
    variables = (
        Variable(_NOWHERE, parameter.name, _KINDS[parameter.direction], parameter.types[0])
        for parameter in routine.parameters
    )
    return StandardBlock(key, tuple(variables))


def assigned_members(files: Sequence[ast.File]) -> dict[str, str]:
    """All members that the text assigns (`inst.REQ := TRUE`) as written, by casefolded name."""
    return {
        node.target.name.casefold(): node.target.name
        for file in files
        for node in walk(file)
        if isinstance(node, ast.Assignment | ast.Chained) and isinstance(node.target, ast.Member)
    }


@cache
def stubbed_block(name: str) -> StandardBlock:
    """A block of which nothing is known but that a stub stands for it."""
    return StandardBlock(name, ())
