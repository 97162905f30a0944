"""A gateway whose cyclic data carry telegrams: one at a time, sent when a trigger byte changes."""

from collections.abc import Iterable
from typing import Literal

from fbgen.catalog.gateways import unknown_name
from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates
from fbgen.catalog.profibus_gateways import ProfibusGateway, PublishedProfibus
from fbgen.catalog.scalars import Count, HexByte, HexWord, SnakeName, Text
from fbgen.catalog.sourced import Duration, Sourced
from fbgen.catalog.words import Word
from fbgen.diagnostics import Diagnostic


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


class TelegramTimes(Located):
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


class TelegramGateway(ProfibusGateway):
    """A gateway for telegrams. The words `control` and `status` lie at the start of the frames."""

    kind: Literal["telegrams"] = "telegrams"
    profibus: PublishedProfibus
    subnetwork: SubNetwork
    power_on_status: HexWord
    trigger: Trigger
    handshake: Handshake
    status_codes: tuple[StatusCode, ...]
    times: TelegramTimes

    @property
    def control(self) -> Word:
        """The bit table of the control word, which the PLC writes."""
        return self.word("control")

    @property
    def status_word(self) -> Word:
        """The bit table of the status word, which the gateway writes."""
        return self.word("status")

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1105 a name that is not there."""
        yield from super().problems()
        codes = self.status_codes
        yield from no_duplicates(codes, "code", lambda item: f"{item.code:02X}", "status code")
        words = {word.name: word for word in self.words}
        if missing := [name for name in ("control", "status") if name not in words]:
            yield Diagnostic(
                "FB1105", f"a gateway needs the word '{missing[0]}'", self.key_span_of("words")
            )
            return
        shake = self.handshake
        for bit in ("status_changed", "command_done"):
            yield from unknown_name(shake, bit, getattr(shake, bit), words["status"].bits)
        for bit in ("status_taken", "command_new"):
            yield from unknown_name(shake, bit, getattr(shake, bit), words["control"].bits)
        for layout in self.layouts:
            yield from unknown_name(self.trigger, "field", self.trigger.field, layout.output)
