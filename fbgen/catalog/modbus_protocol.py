"""MODBUS-RTU as the catalogue describes it: functions, exceptions, silence between frames.

What one series can do of it stands in the drive's file (`communication`).
"""

from collections.abc import Iterable, Iterator
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.protocols import NumberRange, Protocol
from fbgen.catalog.scalars import Count, Flag, HexByte, HexWord, Real, SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic


class ModbusFunction(Sourced):
    """A function. `most_read` and `most_written` are the words that one request can ask for."""

    name: SnakeName
    code: HexByte
    title: Text
    most_read: Count = 0
    most_written: Count = 0
    broadcast: Flag = False


class ModbusException(Sourced):
    """The code of an exception: the reply to a request that cannot be served."""

    name: SnakeName
    code: HexByte
    title: Text


class Silence(Sourced):
    """Silence on the line, in characters; above `fixed_above` bit/s in microseconds instead."""

    characters: Annotated[Real, Field(gt=0)]
    fixed_above: Count
    fixed_us: Count


class Crc(Sourced):
    """The checksum over all bytes before it, low byte first."""

    polynomial: HexWord
    start: HexWord


class ModbusLimits(Located):
    """`frame_gap` ends a frame; more than `character_gap` within one makes it invalid."""

    max_frame_bytes: Count
    frame_gap: Silence
    character_gap: Silence


class ModbusProtocol(Protocol):
    """MODBUS-RTU. `exception_bit` is set in the function code of an exception."""

    kind: Literal["modbus"]
    inv_numbers: NumberRange
    crc: Crc
    functions: tuple[ModbusFunction, ...]
    exception_bit: HexByte
    exceptions: tuple[ModbusException, ...]
    limits: ModbusLimits

    def function(self, name: str) -> ModbusFunction:
        """The function of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.functions, name, "FB1105", f"'{self.id}' has no function '{name}'")

    def exception(self, name: str) -> ModbusException:
        """The exception of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.exceptions, name, "FB1105", f"'{self.id}' has no exception '{name}'")

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1103 no source."""
        yield from super().problems()
        yield from _told_apart(self.functions, "function")
        yield from _told_apart(self.exceptions, "exception")


def _told_apart(
    items: tuple[ModbusFunction | ModbusException, ...], kind: str
) -> Iterator[Diagnostic]:
    yield from no_duplicates(items, "name", lambda item: item.name, kind)
    yield from no_duplicates(items, "code", lambda item: f"{item.code:02X}", f"{kind} code")
