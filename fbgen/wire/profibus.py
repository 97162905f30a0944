"""PROFIBUS DP configuration identifiers: what a Chk_Cfg telegram says about the cyclic data.

One identifier describes one module. Normal format, one byte: bit 7 consistency over the whole
length (else per unit), bit 6 words instead of bytes, bits 5-4 = 01 inputs, 10 outputs, 11 both,
bits 3-0 length - 1 in units. Special format, where bits 5-4 are 00: bits 7-6 = 01 inputs, 10
outputs, 11 both, 00 empty place, bits 3-0 the number of manufacturer bytes; then a length byte for
the outputs, then one for the inputs: bit 7 consistency, bit 6 words, bits 5-0 length - 1; then the
manufacturer bytes (EN 50170 volume 2, service Chk_Cfg). Inputs and outputs are seen from the PLC.
"""

from collections.abc import Iterable
from enum import Enum

from fbgen.dataclass import dataclass

_NORMAL_DIRECTION = 0x30
_INPUTS = 0x10
_OUTPUTS = 0x20
_SPECIAL_OUTPUTS = 0x80
_SPECIAL_INPUTS = 0x40
_WORDS = 0x40
_WHOLE = 0x80
_LONGEST_NORMAL = 16
_LONGEST_SPECIAL = 64
_NOT_COMPARED = 15
"""Number of manufacturer bytes that stands for "none, and do not check"."""


class Consistency(Enum):
    """How far the bytes of one direction belong together."""

    UNIT = "unit"
    WHOLE = "whole"


class IdentifierError(ValueError):
    """Bytes that are no identifiers, or a length that no identifier can say."""


@dataclass(frozen=True, slots=True)
class Extent:
    """One direction of a module: `units` of `unit_bytes` (1 byte, 2 word) each."""

    units: int
    unit_bytes: int = 1
    consistency: Consistency = Consistency.UNIT

    @property
    def length(self) -> int:
        """Length in bytes."""
        return self.units * self.unit_bytes

    @property
    def consistent_bytes(self) -> int:
        """So many bytes that follow each other are always of the same moment."""
        return self.length if self.consistency is Consistency.WHOLE else self.unit_bytes


@dataclass(frozen=True, slots=True)
class Identifier:
    """One configuration identifier. A direction that the module does not have is None."""

    code: bytes
    outputs: Extent | None
    inputs: Extent | None
    manufacturer: bytes = b""

    @property
    def output_length(self) -> int:
        """Bytes from the PLC to the slave."""
        return self.outputs.length if self.outputs else 0

    @property
    def input_length(self) -> int:
        """Bytes from the slave to the PLC."""
        return self.inputs.length if self.inputs else 0


@dataclass(frozen=True, slots=True)
class Slot:
    """A module in its place. `number` counts from 1.

    Offsets are those in the slave's output and input data, addresses those in the PLC; both count
    bytes, and are None in a direction that the module does not have.
    """

    number: int
    identifier: Identifier
    output_offset: int | None
    input_offset: int | None
    output_address: int | None
    input_address: int | None


def encode_identifier(
    outputs: Extent | None, inputs: Extent | None, manufacturer: bytes = b""
) -> Identifier:
    """The identifier for a module, in normal format where that can say it.

    Raises IdentifierError for a length or a unit that neither format can say.
    """
    for extent in (outputs, inputs):
        if extent and not (1 <= extent.units <= _LONGEST_SPECIAL and extent.unit_bytes in (1, 2)):
            raise IdentifierError(
                f"{extent.units} units of {extent.unit_bytes} bytes: an identifier says 1 to "
                f"{_LONGEST_SPECIAL} bytes or words"
            )
    if len(manufacturer) >= _NOT_COMPARED:
        raise IdentifierError(f"{len(manufacturer)} manufacturer bytes: 14 is the most")
    extent = outputs or inputs
    same = outputs is None or inputs is None or outputs == inputs
    if extent and same and not manufacturer and extent.units <= _LONGEST_NORMAL:
        direction = (_OUTPUTS if outputs else 0) | (_INPUTS if inputs else 0)
        code = bytes((direction | _form(extent) | extent.units - 1,))
        return Identifier(code, outputs, inputs)
    head = (_SPECIAL_OUTPUTS if outputs else 0) | (_SPECIAL_INPUTS if inputs else 0)
    lengths = bytes(_form(part) | part.units - 1 for part in (outputs, inputs) if part)
    code = bytes((head | len(manufacturer),)) + lengths + manufacturer
    return Identifier(code, outputs, inputs, manufacturer)


def decode_identifiers(code: bytes) -> tuple[Identifier, ...]:
    """The identifiers of a configuration one after the other.

    Raises IdentifierError where bytes that an identifier announces are missing.
    """
    found: list[Identifier] = []
    rest = code
    while rest:
        identifier = _first(rest)
        found.append(identifier)
        rest = rest[len(identifier.code) :]
    return tuple(found)


def slot_table(
    identifiers: Iterable[Identifier], output_address: int = 0, input_address: int = 0
) -> tuple[Slot, ...]:
    """The modules in their places, with addresses that follow each other without a gap."""
    slots: list[Slot] = []
    output = into = 0
    for number, identifier in enumerate(identifiers, start=1):
        has_outputs, has_inputs = identifier.outputs is not None, identifier.inputs is not None
        slots.append(
            Slot(
                number,
                identifier,
                output if has_outputs else None,
                into if has_inputs else None,
                output_address + output if has_outputs else None,
                input_address + into if has_inputs else None,
            )
        )
        output += identifier.output_length
        into += identifier.input_length
    return tuple(slots)


def output_length(identifiers: Iterable[Identifier]) -> int:
    """Bytes from the PLC to the slave in one Data_Exchange."""
    return sum(identifier.output_length for identifier in identifiers)


def input_length(identifiers: Iterable[Identifier]) -> int:
    """Bytes from the slave to the PLC in one Data_Exchange."""
    return sum(identifier.input_length for identifier in identifiers)


def _first(code: bytes) -> Identifier:
    head = code[0]
    direction = head & _NORMAL_DIRECTION
    if direction:
        extent = _extent(head, 0x0F)
        outputs = extent if direction & _OUTPUTS else None
        inputs = extent if direction & _INPUTS else None
        return Identifier(code[:1], outputs, inputs)
    at = 1
    parts: list[Extent | None] = []
    for wanted in (head & _SPECIAL_OUTPUTS, head & _SPECIAL_INPUTS):
        if wanted and at >= len(code):
            raise IdentifierError(f"the identifier {head:02X} lacks a length byte")
        parts.append(_extent(code[at], 0x3F) if wanted else None)
        at += 1 if wanted else 0
    count = head & 0x0F
    end = at if count == _NOT_COMPARED else at + count
    if end > len(code):
        missing = end - len(code)
        raise IdentifierError(f"the identifier {head:02X} lacks {missing} manufacturer bytes")
    return Identifier(code[:end], parts[0], parts[1], code[at:end])


def _extent(byte: int, length_mask: int) -> Extent:
    consistency = Consistency.WHOLE if byte & _WHOLE else Consistency.UNIT
    return Extent((byte & length_mask) + 1, 2 if byte & _WORDS else 1, consistency)


def _form(extent: Extent) -> int:
    whole = _WHOLE if extent.consistency is Consistency.WHOLE else 0
    return whole | (_WORDS if extent.unit_bytes == 2 else 0)
