"""Control and status words as templates see them: masks and shifts by the catalogue's names."""

from collections.abc import Iterable
from dataclasses import replace

from fbgen.blocks.literals import SclText, word
from fbgen.catalog import Word, origin
from fbgen.dataclass import dataclass
from fbgen.source import Origin


@dataclass(frozen=True, slots=True)
class WordView:
    """A word of the catalogue. Unknown names raise the catalogue's own diagnostic."""

    entry: Word
    device: str

    def mask(self, *names: str) -> SclText:
        """The bits of the named fields as ones."""
        value = 0
        for name in names:
            value |= self.entry.field(name).mask
        return word(value, bits_origin(self.device, self.entry, names))

    def shift(self, name: str) -> SclText:
        """By how many places the field stands left of bit 0."""
        field = self.entry.field(name)
        return SclText(str(field.low), origin(f"{self.device}.{self.entry.name} {name}", field))

    def complement(self, *names: str) -> SclText:
        """All bits but those of the named fields as ones."""
        mask = self.mask(*names)
        return SclText(f"16#{0xFFFF ^ int(mask.text[3:], 16):04X}", mask.origin)

    def masked(self, value: int, *names: str) -> SclText:
        """A value of the whole word without the named fields."""
        complement = self.complement(*names)
        keep = int(complement.text[3:], 16)
        what = f"{self.device}.{self.entry.name}"
        source = self.entry.source or ""
        return word(value & keep, origin(what, self.entry, source, [complement.origin]))


def bits_origin(device: str, entry: Word, names: Iterable[str]) -> Origin | None:
    """Where a value made of these bits is from: the first of them, with the others as inputs."""
    first, *others = (
        origin(f"{device}.{entry.name} {name}", field, entry.source_of(field))
        for name in names
        for field in (entry.field(name),)
    )
    return replace(first, inputs=tuple(item for item in others if item)) if first else None
