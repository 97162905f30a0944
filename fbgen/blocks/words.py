"""Control and status words as templates see them: masks and shifts by the catalogue's names."""

from dataclasses import dataclass

from fbgen.blocks.literals import SclText, word
from fbgen.catalog import Word, origin


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
        field = self.entry.field(names[0])
        source = self.entry.source_of(field)
        return word(value, origin(f"{self.device}.{self.entry.name} {names[0]}", field, source))

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
        keep = int(self.complement(*names).text[3:], 16)
        return word(value & keep, origin(f"{self.device}.{self.entry.name}", self.entry))
