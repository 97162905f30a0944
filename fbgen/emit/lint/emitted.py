"""A generated text as the rules see it: read once, all nodes collected once, by their kinds."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, TypeVar

from fbgen.dataclass import dataclass
from fbgen.lang import ast
from fbgen.plant.families import PlcFamily
from fbgen.source import Source

Node = TypeVar("Node")


@dataclass(frozen=True, slots=True)
class EmittedText:
    """One file. `kinds` are all nodes of its tree by their types, `plc` the family it is for."""

    source: Source
    file: ast.File
    kinds: Mapping[type, Sequence[Any]]
    plc: PlcFamily

    def of(self, kind: type[Node]) -> Sequence[Node]:
        """Every node of a kind, wherever it stands."""
        return self.kinds.get(kind, ())

    def names_longer_than(self, limit: int) -> Iterator[ast.Name | ast.DeclaredName]:
        """Every name with more characters, wherever it stands."""
        yield from (item for item in self.of(ast.Name) if len(item.name) > limit)
        yield from (item for item in self.of(ast.DeclaredName) if len(item.name) > limit)
