"""A generated text as the rules see it: read once, all nodes collected once."""

from collections.abc import Iterator
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

    def names_longer_than(self, limit: int) -> Iterator[ast.Name | ast.DeclaredName]:
        """Every name with more characters, wherever it stands."""
        for item in self.nodes:
            if isinstance(item, ast.Name | ast.DeclaredName) and len(item.name) > limit:
                yield item
