"""The protocols of inverters: what every one has, and the Toshiba inverter protocol.

There are two kinds, which say in `kind` which they are: the Toshiba inverter protocol with its
frame layouts, commands and error codes, and MODBUS-RTU (`modbus_protocol`).
"""

from collections.abc import Iterable
from typing import Literal

from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.scalars import Count, EntryId, Flag, HexByte, HexWord, SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic

Mode = Literal["binary", "ascii"]
FrameField = Literal[
    "start", "inv_no", "command", "comno", "data", "error", "sum_mark", "sum", "end", "return",
    "write_groups", "read_groups", "status", "write_data", "read_data",
]  # fmt: skip


class Character(Sourced):
    """A character on the line: what the drive receives and what it sends."""

    data_bits: Literal[7, 8]
    parities: tuple[Literal["none", "even", "odd"], ...]
    default_parity: Literal["none", "even", "odd"]
    received_stop_bits: Literal[1, 2]
    sent_stop_bits: Literal[1, 2]


class NumberRange(Sourced):
    """Inverter numbers of one mode; `broadcast` as it stands in a frame."""

    minimum: Count
    maximum: Count
    broadcast: Text


class Checksum(Sourced):
    """How the sum is made: low byte of the sum of all bytes from `first` to `last` included."""

    first: FrameField
    last: FrameField
    optional: Flag


class Frame(Sourced):
    """One kind of frame: its fields in order. `lengths` counts bytes on the line."""

    name: SnakeName
    mode: Mode
    direction: Literal["request", "reply"]
    fields: tuple[FrameField, ...]
    optional: tuple[FrameField, ...] = ()
    lengths: tuple[Count, ...]
    title: Text


class Command(Sourced):
    """A command. `frame` and `reply` name frames per mode; no `reply` means it is not answered."""

    name: SnakeName
    code: HexByte
    title: Text
    modes: tuple[Mode, ...]
    writes: Flag
    keeps: Literal["ram", "eeprom", "nothing"]
    reply_code: HexByte | None = None
    tripped_reply_code: HexByte | None = None
    broadcast: Flag

    @property
    def letter(self) -> str:
        """The command as an ASCII character."""
        return chr(self.code)


class ErrorCode(Sourced):
    """The code of an error reply."""

    code: HexWord
    name: SnakeName
    title: Text
    modes: tuple[Mode, ...]


class Protocol(Sourced):
    """What every protocol says: the characters on the line and the rates it is known with."""

    version: Literal[1]
    id: EntryId
    title: Text
    description: Text | None = None
    character: Character
    baud_rates: tuple[Count, ...]


class ToshibaProtocol(Protocol):
    """Error replies use `error_reply_code`, `tripped_error_reply_code` if tripped."""

    kind: Literal["toshiba"] = "toshiba"
    start_codes: dict[Mode, HexByte]
    inv_numbers: dict[Mode, NumberRange]
    checksums: dict[Mode, Checksum]
    frames: tuple[Frame, ...]
    commands: tuple[Command, ...]
    error_reply_code: HexByte
    tripped_error_reply_code: HexByte
    errors: tuple[ErrorCode, ...]

    def command(self, name: str) -> Command:
        """The command of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.commands, name, "FB1105", f"'{self.id}' has no command '{name}'")

    def error(self, name: str) -> ErrorCode:
        """The error of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.errors, name, "FB1105", f"'{self.id}' has no error '{name}'")

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1103 no source."""
        yield from super().problems()
        yield from no_duplicates(self.frames, "name", lambda item: item.name, "frame")
        yield from no_duplicates(self.commands, "name", lambda item: item.name, "command")
        codes = self.commands
        yield from no_duplicates(codes, "code", lambda item: f"{item.code:02X}", "command code")
        yield from no_duplicates(self.errors, "code", lambda item: f"{item.code:04X}", "error")
