"""Which bit or communication number of the catalogue a value in PLC text is."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence

from fbgen.catalog import BitField, Catalog, Drive, Gateway, Located, ToshibaProtocol, Word
from fbgen.dataclass import dataclass
from fbgen.source import Origin


@dataclass(frozen=True, slots=True)
class BitItem:
    """A named bit, or row of bits, of a word."""

    device: str
    word: str
    bit: str


@dataclass(frozen=True, slots=True)
class ComNoItem:
    """A communication number of a series."""

    series: str
    number: int


Item = BitItem | ComNoItem


class CatalogueItems:
    """The bits, numbers and commands of a catalogue, by the places that their marks name."""

    def __init__(self, catalog: Catalog) -> None:
        self._bits: defaultdict[tuple[str, int], list[tuple[BitItem, BitField]]] = defaultdict(list)
        self._comnos: defaultdict[tuple[str, int], list[ComNoItem]] = defaultdict(list)
        self._writes: dict[tuple[str, int], bool] = {}
        self._held: dict[ComNoItem, tuple[str, str]] = {}
        self.words: dict[tuple[str, str], Word] = {}
        devices: tuple[Gateway | Drive, ...] = (
            *catalog.gateways.values(),
            *catalog.drives.values(),
        )
        for device in devices:
            for word in device.words:
                self.words[device.id, word.name] = word
                for field in word.bits:
                    self._bits[_place(field)].append(
                        (BitItem(device.id, word.name, field.name), field)
                    )
        for series in catalog.drives.values():
            for cell in series.comnos:
                item = ComNoItem(series.id, cell.number)
                self._comnos[_place(cell)].append(item)
                if cell.word is not None:
                    self._held[item] = series.id, cell.word
        for protocol in catalog.protocols.values():
            if isinstance(protocol, ToshibaProtocol):
                self._writes |= {_place(one): one.writes for one in protocol.commands}

    def in_line(
        self, origins: Iterable[Origin], value: int, devices: Collection[str]
    ) -> tuple[Item, ...]:
        """What a value stands for in a line with these origins; nothing for any other number.

        Only `devices` count: series that are like another share its entries.
        """
        found: dict[Item, None] = {}
        for origin in origins:
            key = origin.file, origin.line
            found |= {item: None for item in self._comnos.get(key, ()) if item.number == value}
            if key in self._bits:
                found |= dict.fromkeys(self._named(origin, value))
        return tuple(item for item in found if _owner(item) in devices)

    def writes(self, origins: Iterable[Origin]) -> bool | None:
        """Whether the command of a telegram that a line names writes; None if it names none."""
        return next(
            (
                self._writes[origin.file, origin.line]
                for origin in origins
                if (origin.file, origin.line) in self._writes
            ),
            None,
        )

    def of_mask(self, device: str, word: str, mask: int) -> tuple[BitItem, ...]:
        """The bits of a word that a mask of the user's touches."""
        entry = self.words[device, word]
        return tuple(BitItem(device, word, one.name) for one in entry.bits if one.mask & mask)

    def word_of(self, item: Item) -> tuple[str, str] | None:
        """The word that a communication number holds, as device and name."""
        return self._held.get(item) if isinstance(item, ComNoItem) else None

    def of_number(self, series: Sequence[str], number: int, known: Catalog) -> Iterator[ComNoItem]:
        """The communication number of the user's in these series."""
        for name in series:
            if any(cell.number == number for cell in known.drives[name].comnos):
                yield ComNoItem(name, number)

    def _named(self, origin: Origin, value: int) -> Iterator[BitItem]:
        """The bits that a mark names with its inputs, if the value is made of them."""
        rows = [
            self._bits[one.file, one.line]
            for one in (origin, *origin.inputs)
            if (one.file, one.line) in self._bits
        ]
        mask = 0
        for row in rows:
            mask |= row[0][1].mask
        low = rows[0][0][1].low
        if value in (0xFFFF ^ mask, low) or (value and value & ~mask == 0):
            for row in rows:
                yield from (item for item, _ in row)


def _owner(item: Item) -> str:
    return item.device if isinstance(item, BitItem) else item.series


def _place(entry: Located) -> tuple[str, int]:
    span = entry.span
    return (span.source.name, span.line) if span is not None else ("", 0)
