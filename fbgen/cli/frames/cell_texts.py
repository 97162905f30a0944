"""ComNos and their values in words, as far as a series of inverters is known."""

from collections.abc import Sequence
from pathlib import Path

from fbgen.catalog import ComNo, Drive, load_catalog
from fbgen.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class CellTexts:
    """What the catalogue says of the ComNos of a series; of none if there is no series."""

    drive: Drive | None = None

    def name(self, com_no: int) -> str:
        """The ComNo with its name and title."""
        known = self.comno(com_no)
        if known is not None:
            return f"{com_no:04X}, {known.name}: {known.title}"
        if self.drive is None:
            return f"{com_no:04X}"
        return f"{com_no:04X}, which the catalogue does not know of {self.drive.id}"

    def short(self, com_no: int) -> str:
        """The ComNo with its name."""
        known = self.comno(com_no)
        return f"{com_no:04X}" if known is None else f"{com_no:04X} {known.name}"

    def value(self, com_no: int, word: int) -> str:
        """The word, and what it means: set bits, a physical value, a trip."""
        known = self.comno(com_no)
        meaning = "" if known is None or self.drive is None else _meaning(self.drive, known, word)
        return f"{word:04X} = {meaning}" if meaning else f"{word:04X}"

    def comno(self, com_no: int) -> ComNo | None:
        """The entry of the catalogue, if there is one."""
        if self.drive is None:
            return None
        return next((item for item in self.drive.comnos if item.number == com_no), None)

    def resets(self, com_no: int, word: int) -> bool:
        """True if this word resets a fault, which an inverter does not answer."""
        known = self.comno(com_no)
        if known is None or self.drive is None or known.name != self.drive.link.command:
            return False
        fields = self.drive.word(known.word).decode(word) if known.word else ()
        return any(item.field.name == "fault_reset" and item.value for item in fields)


def cell_texts(series: str | None, catalog: Sequence[Path] | None) -> CellTexts:
    """Those of a series. Raises DiagnosticError FB1205 if the catalogue has none of this name."""
    if series is None:
        return CellTexts()
    return CellTexts(load_catalog(catalog or ()).drive(series))


def _meaning(drive: Drive, known: ComNo, word: int) -> str:
    if known.word is not None:
        fields = [item for item in drive.word(known.word).decode(word) if item.value]
        return ", ".join(item.field.name for item in fields) or "no bit set"
    if known.name == drive.link.trip:
        trip = drive.trip(word)
        return "" if trip is None else f"{trip.display}, {trip.meaning}"
    decimals = max(0, len(f"{known.resolution:g}".partition(".")[2]))
    value = f"{known.to_value(word):.{decimals}f} {known.unit}".rstrip()
    return f"{value}, {known.values[word]}" if word in known.values else value
