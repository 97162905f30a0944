"""The Python of one block, as it is compiled and loaded."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, NamedTuple

from fbgen.dataclass import dataclass
from fbgen.lang.types import Type
from harness.engine.compiled.code import Listing

if TYPE_CHECKING:
    from harness.engine.compiled.data.placement import Bytes


class Link(NamedTuple):
    """Something that refers to the memory of one controller, and is made for each of them."""

    make: Callable[["Bytes", Type], object]
    kind: Type

    def on(self, data: "Bytes") -> object:
        """What it is on a controller."""
        return self.make(data, self.kind)


@dataclass(frozen=True, slots=True)
class Written:
    """The Python of one block, and what its source refers to by name: objects, and links."""

    listing: Listing
    tables: Mapping[str, object]
    links: Mapping[str, Link]

    def names(self, data: "Bytes") -> dict[str, object]:
        """All that the source refers to, on one controller."""
        return {**self.tables, **{name: link.on(data) for name, link in self.links.items()}}
