"""Structures inside of structures that a stretch of statements keeps in Python locals.

No structure is ever bound anew, so a local with one is always good. `line.request.invNo` reads an
attribute of `line` first each time; with `request = line.request` before, it need not.
"""

from collections.abc import Iterable, Mapping
from typing import NamedTuple, TypeAlias

from fbgen.lang.checked import FieldRef, Variable, VariableRef
from fbgen.lang.types import StructType

Path: TypeAlias = tuple[Variable, tuple[str, ...]]
"""A variable, and the names of fields from there on, in lower case."""

_WORTH = 4.0
"""Weighted uses from which on a local pays: to fill it takes three instructions, each use one."""


class Fields(NamedTuple):
    """A structure variable, and the fields that lead from it to some place, the outermost first."""

    root: VariableRef
    fields: list[FieldRef]

    def paths(self) -> list[tuple[Path, FieldRef]]:
        """The structures on the way, the outermost first."""
        names = [field.name.casefold() for field in self.fields]
        return [
            ((self.root.variable, tuple(names[: number + 1])), field)
            for number, field in enumerate(self.fields)
            if isinstance(field.type, StructType)
        ]


def fields_to(node: FieldRef) -> Fields | None:
    """How a place is reached; None if not through structures only."""
    fields: list[FieldRef] = []
    place = node
    while isinstance(place.base.type, StructType):
        fields.append(place)
        if isinstance(place.base, VariableRef):
            return Fields(place.base, fields[::-1])
        if not isinstance(place.base, FieldRef):
            return None
        place = place.base
    return None


def path_of(node: FieldRef) -> Path | None:
    """The path of a structure; None if it is reached in another way."""
    found = fields_to(node)
    return None if found is None else found.paths()[-1][0]


def worth_naming(weights: Mapping[Path, float]) -> list[Path]:
    """Which structures pay, by how often each one is used; outer ones first."""
    left = dict(weights)
    chosen: list[Path] = []
    for path in sorted(left, key=lambda one: -len(one[1])):
        if left[path] >= _WORTH:
            chosen.append(path)
            for outer in _outer(path):
                if outer in left:
                    left[outer] -= left[path] - 1  # one use remains: to fill this local
    return chosen[::-1]


def _outer(path: Path) -> Iterable[Path]:
    variable, names = path
    return ((variable, names[:length]) for length in range(1, len(names)))
