"""What every fieldbus gateway has: the inverters behind it, words, lamps, options, switches.

There are three kinds, which say in `kind` what their cyclic data carry: telegrams of the inverters'
protocol (`telegram_gateways`), process data on PROFIBUS (`process_data_gateways`), or assemblies on
DeviceNet (`devicenet_gateways`).
"""

from collections.abc import Iterable
from typing import Literal

from fbgen.catalog.connectors import Connector
from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.options import Option
from fbgen.catalog.scalars import Count, EntryId, Flag, SnakeName, Text
from fbgen.catalog.settings import Switch
from fbgen.catalog.sourced import Sourced
from fbgen.catalog.words import Word
from fbgen.diagnostics import Diagnostic
from fbgen.nearest import nearest


class LedState(Sourced):
    """One state of a lamp. `normal` marks what it shows in trouble-free operation."""

    light: Literal[
        "off", "green", "red", "green_flashing", "red_flashing", "red_1hz", "red_2hz", "red_4hz",
        "red_green_alternating",
    ]  # fmt: skip
    name: SnakeName
    meaning: Text
    normal: Flag = False


class Led(Located):
    """A lamp with its states; an unused one has none."""

    number: Count
    name: SnakeName
    title: Text
    states: tuple[LedState, ...] = ()


class Gateway(Sourced):
    """One type of gateway, of whatever kind. `series`: the inverters that it serves."""

    version: Literal[1]
    id: EntryId
    title: Text
    vendor: Text
    description: Text | None = None
    series: tuple[EntryId, ...]
    words: tuple[Word, ...]
    leds: tuple[Led, ...]
    options: tuple[Option, ...]
    switches: tuple[Switch, ...] = ()
    connectors: tuple[Connector, ...] = ()

    def word(self, name: str) -> Word:
        """The word of a name. Raises DiagnosticError FB1201 with the nearest names."""
        return pick(self.words, name, "FB1201", f"'{self.id}' has no word '{name}'")

    def option(self, name: str) -> Option:
        """The option of an id. Raises KeyError for an id that the catalogue does not know."""
        return next(option for option in self.options if option.id == name)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice."""
        yield from super().problems()
        yield from no_duplicates(self.words, "name", lambda item: item.name, "word")
        yield from no_duplicates(self.options, "id", lambda item: item.id, "option")
        yield from no_duplicates(self.leds, "name", lambda item: item.name, "LED")
        yield from no_duplicates(self.connectors, "name", lambda item: item.name, "connector")


def unknown_name(
    owner: Located, field: str, name: str, items: Iterable[object]
) -> Iterable[Diagnostic]:
    """FB1105: a field that names none of the items."""
    known = [str(getattr(item, "name", "")) for item in items]
    if name not in known:
        yield Diagnostic(
            "FB1105",
            f"there is no '{name}' to which {field} could refer",
            owner.span_of(field),
            nearest(name, known),
        )
