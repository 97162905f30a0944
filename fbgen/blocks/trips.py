"""What the blocks are told of a series: its trips in words, and how it says who commands it."""

from fbgen.blocks.literals import SclText, comno, one_line, word
from fbgen.catalog import Catalog, Drive, Trip, origin
from fbgen.dataclass import dataclass

SERIAL_COMMANDS = "serial communication"
"""What the value of a command source is called in the catalogue that stands for the network."""
_LONGEST_TRIP_TEXT = 40


@dataclass(frozen=True, slots=True)
class TripTexts:
    """The trips of one series; `suffix` is its part of the function's name."""

    series: str
    suffix: str
    trips: tuple[dict[str, SclText], ...]


def trip_texts(series: str, catalog: Catalog) -> TripTexts:
    """What the template of a function with the trips of a series in words needs."""
    trips = tuple(map(trip_literals, catalog.drive(series).trips))
    return TripTexts(series, series.replace("-", "_"), trips)


def command_source(drive: Drive) -> dict[str, SclText] | None:
    """The ComNo that says who commands, and its value for the network; None if there is none."""
    if drive.link.command_source is None:
        return None
    source = drive.comno(drive.link.command_source)
    values = [value for value, text in source.values.items() if text == SERIAL_COMMANDS]
    if not values:
        return None
    place = origin(f"ComNo {source.hex}", source, source.source or "")
    return {"number": comno(source), "network": word(int(values[0]), place)}


def trip_literals(trip: Trip) -> dict[str, SclText]:
    """A trip code and its text of at most 40 characters, as literals."""
    place = origin(f"trip {trip.display}", trip, trip.source or "")
    words = one_line(f"{trip.display}: {trip.meaning}")[:_LONGEST_TRIP_TEXT]
    quoted = words.replace("$", "$$").replace("'", "$'")
    return {"code": SclText(str(trip.code), place), "text": SclText(f"'{quoted}'", place)}
