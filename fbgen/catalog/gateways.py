"""A fieldbus gateway: its cyclic layouts, words, handshake, status codes, times and lamps."""

from collections.abc import Iterable
from typing import Literal

from pydantic import Field

from fbgen.catalog.layouts import Layout
from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.options import Option
from fbgen.catalog.scalars import Count, EntryId, Flag, HexByte, HexWord, SnakeName, Text
from fbgen.catalog.settings import Switch
from fbgen.catalog.sourced import Duration, Sourced
from fbgen.catalog.words import Word
from fbgen.diagnostics import Diagnostic
from fbgen.nearest import nearest


class Profibus(Sourced):
    """The gateway as a PROFIBUS DP slave. Addresses are those the switches can set."""

    ident_number: HexWord
    gsd_file: Text
    minimum_address: Count
    maximum_address: Count
    default_address: Count
    sync: Flag
    freeze: Flag
    fail_safe: Flag
    auto_baud: Flag
    set_slave_address: Flag
    max_diagnosis_bytes: Count
    min_slave_interval_us: Count
    max_tsdr_bits: dict[str, Count]


class SubNetwork(Sourced):
    """The serial line towards the drives. `wires`: 4 separates the directions, 2 does not."""

    baud: Count
    data_bits: Literal[7, 8]
    parity: Literal["none", "even", "odd"]
    stop_bits: Literal[1, 2]
    wires: Literal[2, 4]
    typical_drives: Count

    @property
    def character_bits(self) -> int:
        """Bits of one character on the line, start bit included."""
        return 1 + self.data_bits + (self.parity != "none") + self.stop_bits


class Trigger(Sourced):
    """The byte whose change makes the gateway send. The PLC counts `first` .. `last`, `first`."""

    field: SnakeName
    power_on: HexByte
    first: HexByte
    last: HexByte


class Handshake(Sourced):
    """Which bits of control and status word answer each other, by the bits' names.

    The gateway toggles `status_changed` (status word) for new status information; the PLC copies
    it to `status_taken` (control word). The PLC toggles `command_new` (control word) for a new
    control command; the gateway copies it to `command_done` (status word).
    """

    status_changed: SnakeName
    status_taken: SnakeName
    command_new: SnakeName
    command_done: SnakeName


class StatusCode(Sourced):
    """A value of the status word's code field. `data` says what the data field then holds."""

    code: HexByte
    name: SnakeName
    kind: Literal["none", "warning", "error"]
    title: Text
    data: Text | None = None


class GatewayTimes(Located):
    """The times of a gateway, in milliseconds.

    `processing`: in each direction. `heartbeat`: period of the safety telegram. `trigger_poll`:
    period at which the trigger byte is looked at where that option is on. `total_min` and
    `total_max`: from sending on PROFIBUS to the answer, as the manual sums it up.
    """

    processing: Duration
    heartbeat: Duration
    trigger_poll: Duration
    total_min: Duration
    total_max: Duration


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
    """One type of gateway. The words `control` and `status` lie at the start of the frames."""

    version: Literal[1]
    id: EntryId
    title: Text
    vendor: Text
    description: Text | None = None
    protocol: EntryId
    series: tuple[EntryId, ...]
    profibus: Profibus
    subnetwork: SubNetwork
    default_layout: EntryId
    layouts: tuple[Layout, ...] = Field(min_length=1)
    words: tuple[Word, ...]
    power_on_status: HexWord
    trigger: Trigger
    handshake: Handshake
    status_codes: tuple[StatusCode, ...]
    times: GatewayTimes
    leds: tuple[Led, ...]
    options: tuple[Option, ...]
    switches: tuple[Switch, ...] = ()

    def layout(self, name: str) -> Layout:
        """The layout of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.layouts, name, "FB1105", f"'{self.id}' has no layout '{name}'")

    def word(self, name: str) -> Word:
        """The word of a name. Raises DiagnosticError FB1201 with the nearest names."""
        return pick(self.words, name, "FB1201", f"'{self.id}' has no word '{name}'")

    @property
    def control(self) -> Word:
        """The bit table of the control word, which the PLC writes."""
        return self.word("control")

    @property
    def status_word(self) -> Word:
        """The bit table of the status word, which the gateway writes."""
        return self.word("status")

    def option(self, name: str) -> Option:
        """The option of an id. Raises KeyError for an id that the catalogue does not know."""
        return next(option for option in self.options if option.id == name)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1105 a name that is not there."""
        yield from super().problems()
        yield from no_duplicates(self.layouts, "name", lambda item: item.name, "layout")
        yield from no_duplicates(self.words, "name", lambda item: item.name, "word")
        yield from no_duplicates(self.options, "id", lambda item: item.id, "option")
        yield from no_duplicates(self.leds, "name", lambda item: item.name, "LED")
        codes = self.status_codes
        yield from no_duplicates(codes, "code", lambda item: f"{item.code:02X}", "status code")
        yield from _known(self, "default_layout", self.default_layout, self.layouts)
        words = {word.name: word for word in self.words}
        if missing := [name for name in ("control", "status") if name not in words]:
            yield Diagnostic(
                "FB1105", f"a gateway needs the word '{missing[0]}'", self.key_span_of("words")
            )
            return
        shake = self.handshake
        for bit in ("status_changed", "command_done"):
            yield from _known(shake, bit, getattr(shake, bit), words["status"].bits)
        for bit in ("status_taken", "command_new"):
            yield from _known(shake, bit, getattr(shake, bit), words["control"].bits)
        for layout in self.layouts:
            yield from _known(self.trigger, "field", self.trigger.field, layout.output)


def _known(owner: Located, field: str, name: str, items: Iterable[object]) -> Iterable[Diagnostic]:
    known = [str(getattr(item, "name", "")) for item in items]
    if name not in known:
        yield Diagnostic(
            "FB1105",
            f"there is no '{name}' to which {field} could refer",
            owner.span_of(field),
            nearest(name, known),
        )
