"""Where blocks use bits, words and communication numbers, from the checked text itself."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.docs.program import PlantProgram
from fbgen.docs.usage.catalogue_items import BitItem, CatalogueItems, ComNoItem, Item
from fbgen.docs.usage.uses import CHANGES, Unnamed, Use, UseFinder

__all__ = ["NO_USAGE", "BitItem", "ComNoItem", "Unnamed", "Usage", "Use", "usage_of"]


@dataclass(frozen=True, slots=True)
class Usage:
    """All uses, by what is used. Not `known`: no blocks were looked at.

    `devices` are those that the blocks have to do with; `unnamed` are words of which a program sets
    bits that it works out.
    """

    known: bool
    devices: frozenset[str]
    uses: Mapping[Item, tuple[Use, ...]]
    unnamed: tuple[Unnamed, ...] = ()

    def of(self, item: Item) -> tuple[Use, ...]:
        """Where it is used; empty where nowhere."""
        return self.uses.get(item, ())

    def changes(self, item: Item) -> tuple[Use, ...]:
        """Where it is set, cleared or written."""
        return tuple(use for use in self.of(item) if use.does in CHANGES)

    def worked_out(self, device: str, word: str) -> tuple[Unnamed, ...]:
        """Where bits of a word are set from a value."""
        return tuple(one for one in self.unnamed if (one.device, one.word) == (device, word))


NO_USAGE = Usage(False, frozenset(), MappingProxyType({}))


def usage_of(programs: Sequence[PlantProgram], catalog: Catalog) -> Usage:
    """The uses of several programs; a block that two of them have counts in the first."""
    if not programs:
        return NO_USAGE
    items = CatalogueItems(catalog)
    found: dict[Item, list[Use]] = {}
    unnamed: dict[Unnamed, None] = {}
    seen: set[str] = set()
    devices: set[str] = set()
    for program in programs:
        devices |= program.devices
        uses, others = UseFinder(program, catalog, items).find()
        for use in _of_new_blocks(uses, seen):
            found.setdefault(use.item, []).append(use)
        unnamed |= dict.fromkeys(one for one in others if one.block not in seen)
        seen |= {block.name for block in program.program.blocks.values()}
    rows = {item: tuple(uses) for item, uses in found.items()}
    return Usage(True, frozenset(devices), rows, tuple(unnamed))


def _of_new_blocks(uses: Iterable[Use], seen: set[str]) -> Iterator[Use]:
    return (use for use in uses if use.block not in seen)
