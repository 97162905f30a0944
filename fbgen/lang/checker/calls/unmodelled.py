"""Function blocks that work on hardware: the controller's own, and what a stub stands for.

An instance of one has the inputs and outputs that are known of it. What a call does is up to the
user's stub, or, for those of `point_to_point`, to the communication modules of a plant.
"""

from collections.abc import Sequence
from functools import cache

from fbgen.lang import ast
from fbgen.lang.checked import StandardBlock, Variable, VariableKind
from fbgen.lang.checker.supplied.routines.hardware_blocks import (
    BLOCK_ALIASES,
    HARDWARE_BLOCKS,
    WORDS,
)
from fbgen.lang.checker.supplied.routines.point_to_point import POINT_TO_POINT, TIE
from fbgen.lang.checker.supplied.routines.signature import Direction, Parameter, read_signature
from fbgen.lang.walk import walk
from fbgen.source import Source, Span

_KINDS = {
    Direction.INPUT: VariableKind.INPUT,
    Direction.OUTPUT: VariableKind.OUTPUT,
    Direction.STATIC: VariableKind.INPUT,
}
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
    known = key in HARDWARE_BLOCKS or key in POINT_TO_POINT
    if not known or (key in WORDS and dialect not in ("tia", "step7")):
        return None
    variables = (
        Variable(_NOWHERE, parameter.name, _KINDS[parameter.direction], parameter.types[0])
        for parameter in _parameters(key, dialect)
        if parameter.types
    )
    return StandardBlock(key, tuple(variables))


@cache
def _parameters(key: str, dialect: str) -> tuple[Parameter, ...]:
    text = POINT_TO_POINT.get(key) or HARDWARE_BLOCKS[key]
    for newer, older in _CLASSIC_TYPES if dialect == "step7" else ():
        text = text.replace(newer, older)
    return read_signature(key, f"({text})", modelled=False).parameters


def closed_parameters(name: str) -> tuple[Parameter, ...]:
    """All parameters of a block of which every one is known; empty for other blocks."""
    return _parameters(name, "tia") if name in POINT_TO_POINT else ()


def assigned_members(files: Sequence[ast.File]) -> dict[str, str]:
    """All members that the text assigns (`inst.REQ := TRUE`) as written, by casefolded name.

    And the one that the call of another block writes.
    """
    assigned = {
        node.target.name.casefold(): node.target.name
        for file in files
        for node in walk(file)
        if isinstance(node, ast.Assignment | ast.Chained) and isinstance(node.target, ast.Member)
    }
    return {TIE.casefold(): TIE, **assigned}


@cache
def stubbed_block(name: str) -> StandardBlock:
    """A block of which nothing is known but that a stub stands for it."""
    return StandardBlock(name, ())
