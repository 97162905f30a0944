"""A generated text as the rules see it: read once, all nodes collected once."""

from dataclasses import dataclass

from fbgen.lang import ast
from fbgen.plant.families import PlcFamily
from fbgen.source import Source


@dataclass(frozen=True, slots=True)
class EmittedText:
    """One file. `nodes` are all nodes of its tree, `plc` the family it is made for."""

    source: Source
    file: ast.File
    nodes: tuple[object, ...]
    plc: PlcFamily
