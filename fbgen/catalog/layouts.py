"""Cyclic data of a DP slave: configuration identifiers and the fields they carry."""

from collections.abc import Iterable, Sequence
from functools import cache
from typing import Literal, Protocol

from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.scalars import Count, EntryId, Flag, Octets, SnakeName, Text
from fbgen.catalog.sourced import Sourced, unknown_fields
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.source import Span
from fbgen.wire.profibus import (
    Consistency,
    IdentifierError,
    Slot,
    decode_identifiers,
    input_length,
    output_length,
    slot_table,
)

AccessWay = Literal["per_identifier", "dpxx_dat", "process_image"]


@dataclass(frozen=True, slots=True)
class PlacedIdentifier:
    """One configuration identifier with its place in the cyclic data (bytes, offsets from 0).

    `unit_length` is 1 for bytes and 2 for words; `consistent` means over the whole length in each
    direction that the identifier has. A direction that it does not have is 0 bytes long.
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
    """One reading of the cyclic data. `invented` marks a module that no real GSD file offers.

    `unverified` lists those fields that rest on no document although the module itself does.
    """

    name: EntryId
    title: Text
    identifiers: Octets
    invented: Flag = False
    unverified: tuple[SnakeName, ...] = ()
    output: tuple[CyclicField, ...]
    input: tuple[CyclicField, ...]

    @property
    def parsed_identifiers(self) -> tuple[PlacedIdentifier, ...]:
        """The identifiers one by one. They were checked when the entry was read."""
        return placed_identifiers(self.identifiers)

    @property
    def output_length(self) -> int:
        """Bytes from the PLC to the gateway."""
        return output_length(decode_identifiers(self.identifiers))

    @property
    def input_length(self) -> int:
        """Bytes from the gateway to the PLC."""
        return input_length(decode_identifiers(self.identifiers))

    def output_field(self, name: str) -> CyclicField:
        """A field towards the gateway. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.output, name, "FB1105", f"'{self.name}' has no output field '{name}'")

    @property
    def consistent(self) -> bool:
        """Whether one identifier that is consistent over its whole length carries everything."""
        return covers_all(self.parsed_identifiers)

    @property
    def access_ways(self) -> tuple[AccessWay, ...]:
        """How a PLC can reach the data."""
        return access_ways(self.parsed_identifiers)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1106 identifiers and fields that do not agree."""
        yield from super().problems()
        yield from unknown_fields(self, self.unverified)
        try:
            decoded = decode_identifiers(self.identifiers)
        except IdentifierError as wrong:
            yield Diagnostic("FB1106", str(wrong), self.span_of("identifiers"))
            return
        if not decoded:
            yield Diagnostic("FB1106", "there is no identifier", self.span_of("identifiers"))
            return
        for fields, length, name in (
            (self.output, output_length(decoded), "output"),
            (self.input, input_length(decoded), "input"),
        ):
            yield from no_duplicates(fields, "name", lambda item: item.name, f"{name} field")
            yield from self._fill(fields, length, name)

    def _fill(
        self, fields: tuple[CyclicField, ...], length: int, name: str
    ) -> Iterable[Diagnostic]:
        yield from gaps(fields)
        position = fields[-1].end if fields else 0
        if position != length:
            yield Diagnostic(
                "FB1106",
                f"the {name} fields fill {position} bytes, the identifiers carry {length}",
                self.key_span_of(name),
                "a byte that carries nothing is a field with pad: true",
            )


class PlacedField(Protocol):
    """A field with its place in a row of bytes."""

    @property
    def name(self) -> str:
        """How it is called."""

    @property
    def offset(self) -> int:
        """Its first byte, from 0."""

    @property
    def length(self) -> int:
        """How many bytes it has."""

    def span_of(self, key: str) -> Span | None:
        """Where a value of it stands."""


def gaps(fields: Iterable[PlacedField]) -> Iterable[Diagnostic]:
    """FB1106: fields that do not begin where the one before ends."""
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
        position = field.offset + field.length


def covers_all(identifiers: Sequence[PlacedIdentifier]) -> bool:
    """Whether one identifier that is consistent over its whole length carries everything.

    Empty places beside it do not count.
    """
    carrying = [one for one in identifiers if one.output_length or one.input_length]
    return len(carrying) == 1 and carrying[0].consistent


def access_ways(identifiers: Sequence[PlacedIdentifier]) -> tuple[AccessWay, ...]:
    """How a PLC can reach the data of these identifiers.

    One DPRD_DAT/DPWR_DAT (SFC14/15) reaches one identifier, so `dpxx_dat` needs one consistent
    identifier over the whole frame; without it the data are reached identifier by identifier. The
    process image is there in both cases.
    """
    first: AccessWay = "dpxx_dat" if covers_all(identifiers) else "per_identifier"
    return (first, "process_image")


@cache
def placed_identifiers(identifiers: bytes) -> tuple[PlacedIdentifier, ...]:
    """Identifiers that can be decoded, one by one, each with its place in the cyclic data."""
    return tuple(_placed(slot) for slot in slot_table(decode_identifiers(identifiers)))


def _placed(slot: Slot) -> PlacedIdentifier:
    identifier = slot.identifier
    extents = [item for item in (identifier.outputs, identifier.inputs) if item is not None]
    return PlacedIdentifier(
        index=slot.number - 1,
        code=identifier.code,
        output_offset=slot.output_offset or 0,
        output_length=identifier.output_length,
        input_offset=slot.input_offset or 0,
        input_length=identifier.input_length,
        unit_length=max((item.unit_bytes for item in extents), default=1),
        consistent=all(item.consistency is Consistency.WHOLE for item in extents),
    )
