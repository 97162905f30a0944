"""Cyclic data of a DP slave: configuration identifiers and what lies behind them.

Identifier bytes as EN 50170 defines them for Chk_Cfg: bit 7 consistency over the whole length,
bit 6 words instead of bytes, bits 5-4 direction (00 special format), bits 3-0 length - 1. Special
format: bits 7-6 which length bytes follow (outputs first), bits 3-0 number of manufacturer bytes.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.scalars import Count, EntryId, Flag, Octets, SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic

AccessWay = Literal["per_identifier", "dpxx_dat", "process_image"]


@dataclass(frozen=True, slots=True)
class Identifier:
    """One configuration identifier with its place in the cyclic data (bytes, offsets from 0).

    `unit_length` is 1 for bytes and 2 for words; `consistent` means over the whole length.
    """

    index: int
    code: bytes
    output_offset: int
    output_length: int
    input_offset: int
    input_length: int
    unit_length: int
    consistent: bool


class CyclicField(Located):
    """A field of the cyclic data. A `pad` carries nothing."""

    name: SnakeName
    offset: Count
    length: Count
    title: Text
    pad: Flag = False

    @property
    def end(self) -> int:
        """The offset behind the last byte."""
        return self.offset + self.length


class Layout(Sourced):
    """One reading of the cyclic data. `invented` marks a module that no real GSD file offers."""

    name: EntryId
    title: Text
    identifiers: Octets
    invented: Flag = False
    output: tuple[CyclicField, ...]
    input: tuple[CyclicField, ...]

    @property
    def parsed_identifiers(self) -> tuple[Identifier, ...]:
        """The identifiers one by one. They were checked when the entry was read."""
        return parse_identifiers(self.identifiers)

    @property
    def output_length(self) -> int:
        """Bytes from the PLC to the gateway."""
        return sum(item.output_length for item in self.parsed_identifiers)

    @property
    def input_length(self) -> int:
        """Bytes from the gateway to the PLC."""
        return sum(item.input_length for item in self.parsed_identifiers)

    def output_field(self, name: str) -> CyclicField:
        """A field towards the gateway. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.output, name, "FB1105", f"'{self.name}' has no output field '{name}'")

    def input_field(self, name: str) -> CyclicField:
        """A field from the gateway. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.input, name, "FB1105", f"'{self.name}' has no input field '{name}'")

    @property
    def access_ways(self) -> tuple[AccessWay, ...]:
        """How a PLC can reach the data.

        `dpxx_dat` moves the whole frame with one DPRD_DAT/DPWR_DAT (SFC14/15), which reaches one
        identifier: so one consistent identifier must cover the frame, and then a process image
        or a direct access could not reach 3 or more than 4 bytes of it. Without such an
        identifier the data are reached one identifier at a time, or through the process image.
        """
        first = self.parsed_identifiers[0]
        if len(self.parsed_identifiers) == 1 and first.consistent:
            return ("dpxx_dat",)
        return ("per_identifier", "process_image")

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1106 identifiers and fields that do not agree."""
        yield from super().problems()
        try:
            parsed = parse_identifiers(self.identifiers)
        except ValueError as wrong:
            yield Diagnostic("FB1106", str(wrong), self.span_of("identifiers"))
            return
        for fields, length, name in (
            (self.output, sum(item.output_length for item in parsed), "output"),
            (self.input, sum(item.input_length for item in parsed), "input"),
        ):
            yield from no_duplicates(fields, "name", lambda item: item.name, f"{name} field")
            yield from self._fill(fields, length, name)

    def _fill(
        self, fields: tuple[CyclicField, ...], length: int, name: str
    ) -> Iterable[Diagnostic]:
        position = 0
        for field in fields:
            if field.offset != position:
                yield Diagnostic(
                    "FB1106",
                    f"'{field.name}' begins at byte {field.offset}, "
                    f"but the fields before it end at {position}",
                    field.span_of("offset"),
                    "fields stand in the order of their offsets, without gap or overlap",
                )
            position = field.end
        if position != length:
            yield Diagnostic(
                "FB1106",
                f"the {name} fields fill {position} bytes, the identifiers carry {length}",
                self.key_span_of(name),
                "a byte that carries nothing is a field with pad: true",
            )


def parse_identifiers(code: bytes) -> tuple[Identifier, ...]:
    """The identifiers of a configuration. Raises ValueError for bytes that are none."""
    found: list[Identifier] = []
    output_offset = input_offset = position = 0
    while position < len(code):
        start, head = position, code[position]
        position += 1
        if head & 0x30:
            unit = 2 if head & 0x40 else 1
            length = ((head & 0x0F) + 1) * unit
            output = length if head & 0x20 else 0
            into = length if head & 0x10 else 0
            consistent = bool(head & 0x80)
        else:
            lengths = []
            for wanted in (head & 0x80, head & 0x40):
                if not wanted:
                    lengths.append((0, 1, False))
                    continue
                if position >= len(code):
                    raise ValueError(f"the identifier {head:02X} lacks its length byte")
                byte = code[position]
                position += 1
                unit = 2 if byte & 0x40 else 1
                lengths.append((((byte & 0x3F) + 1) * unit, unit, bool(byte & 0x80)))
            position += head & 0x0F
            if position > len(code):
                raise ValueError(f"the identifier {head:02X} lacks manufacturer bytes")
            (output, out_unit, out_whole), (into, in_unit, in_whole) = lengths
            unit = max(out_unit, in_unit)
            consistent = (out_whole or not output) and (in_whole or not into)
        item = Identifier(
            len(found), code[start:position], output_offset, output, input_offset, into, unit,
            consistent,
        )  # fmt: skip
        found.append(item)
        output_offset += output
        input_offset += into
    if not found:
        raise ValueError("there is no identifier")
    return tuple(found)
