"""16-bit words made of named bits: command words, status words, control words."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import combinations
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog.located import Located
from fbgen.catalog.scalars import BitRange, Flag, HexWord, Number, SnakeName, Text
from fbgen.catalog.sourced import Sourced, Status
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note, error
from fbgen.nearest import nearest

Party = Literal["plc", "gateway", "drive"]
End = Literal["cleared", "power_off", "reset", "factory_setting"]
"""What ends the effect of a bit that stays."""

BitName = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*(\.[a-z][a-z0-9_]*)?$", max_length=120)]
"""A bit of the same word, or `word.bit` for one of another word of the same device."""


class BitField(Located):
    """One bit or a row of bits of a word. `source` and `status` default to the word's.

    How a bit of a command acts: `always`, even where the bit that the word `needs` is 0; it
    `stays_until` one of these once it was set; it is combined by OR with those in `ored_with`; at a
    value the `parameters` count, by the names of their ComNos; a word with a bit that is not
    `answered` gets no reply.
    """

    name: SnakeName
    bit: BitRange
    title: Text
    values: dict[Number, Text] = Field(default_factory=dict)
    always: Flag = False
    stays_until: tuple[End, ...] = ()
    ored_with: tuple[BitName, ...] = ()
    parameters: dict[Number, tuple[SnakeName, ...]] = Field(default_factory=dict)
    answered: Flag = True
    remark: Text | None = None
    source: Text | None = None
    status: Status | None = None

    @property
    def high(self) -> int:
        """The highest bit."""
        return self.bit.high

    @property
    def low(self) -> int:
        """The lowest bit."""
        return self.bit.low

    @property
    def mask(self) -> int:
        """The field's bits as ones in the word."""
        return self.bit.mask

    @property
    def maximum(self) -> int:
        """The greatest value the field can hold."""
        return self.bit.mask >> self.bit.low

    def extract(self, word: int) -> int:
        """The field's value in a word."""
        return (word & self.mask) >> self.low

    def problems(self) -> Iterable[Diagnostic]:
        """FB1104: a meaning for a value that does not fit."""
        for key, values in (("values", self.values), ("parameters", self.parameters)):
            for value in values:
                if value > self.maximum:
                    yield Diagnostic(
                        "FB1104",
                        f"the value {value} does not fit into bit {self.bit} of '{self.name}'",
                        self.span_of(key),
                        f"the greatest value is {self.maximum}",
                    )


@dataclass(frozen=True, slots=True)
class DecodedField:
    """A field's value in one word and what it means (empty where the catalogue does not say)."""

    field: BitField
    value: int
    meaning: str


class WordExample(Sourced):
    """A value of a word that a manual shows, and what it says that it does."""

    value: HexWord
    title: Text


class Word(Sourced):
    """A word with its bit table. `name` is unique within its drive or gateway.

    `needs` is the bit that gives a command word priority: while it is 0, only bits that act
    `always` do. `overridden_by` names terminal functions that have priority over the word.
    """

    name: SnakeName
    title: Text
    comno: HexWord | None = None
    written_by: Party
    read_by: Party
    bits: tuple[BitField, ...]
    needs: BitName | None = None
    overridden_by: tuple[SnakeName, ...] = ()
    remark: Text | None = None
    examples: tuple[WordExample, ...] = ()

    def problems(self) -> Iterable[Diagnostic]:
        """FB1101 overlapping bits or one name twice; FB1103 no source."""
        yield from super().problems()
        for first, second in combinations(self.bits, 2):
            if first.mask & second.mask:
                yield Diagnostic(
                    "FB1101",
                    f"'{second.name}' (bit {second.bit}) overlaps '{first.name}' "
                    f"(bit {first.bit}) in the word '{self.name}'",
                    second.span_of("bit"),
                    "give each bit to one field",
                    (Note("first given here", first.span_of("bit")),),
                )
            if first.name == second.name:
                yield Diagnostic(
                    "FB1102",
                    f"the name '{second.name}' stands twice in the word '{self.name}'",
                    second.span_of("name"),
                    "",
                    (Note("first here", first.span_of("name")),),
                )

        yield from self._wrong_examples()

    def _wrong_examples(self) -> Iterable[Diagnostic]:
        """FB1104: an example with bits that the word does not have."""
        for example in self.examples:
            if rest := example.value & ~self.defined:
                yield Diagnostic(
                    "FB1104",
                    f"the example {example.value:04X} sets bits that '{self.name}' does not have "
                    f"({rest:04X})",
                    example.span_of("value"),
                    f"the bits of the word are {self.defined:04X}",
                )

    def source_of(self, field: BitField) -> str:
        """Where the meaning of a field is documented; empty where nowhere."""
        return field.source or self.source or ""

    def status_of(self, field: BitField) -> Status:
        """Whether the meaning of a field rests on a document."""
        return field.status or self.status

    @property
    def defined(self) -> int:
        """All bits that have a meaning, as ones."""
        return sum(field.mask for field in self.bits)

    def field(self, name: str) -> BitField:
        """The field of this name. Raises DiagnosticError FB1202 with the nearest names."""
        for field in self.bits:
            if field.name == name:
                return field
        names = [field.name for field in self.bits]
        raise error("FB1202", f"the word '{self.name}' has no '{name}'", help=nearest(name, names))

    def encode(self, values: Mapping[str, int] | Iterable[str]) -> int:
        """The word with the named bits set, or the named fields at their values.

        Raises DiagnosticError with FB1202 for unknown names and FB1203 for values that do not
        fit, all of them together.
        """
        wanted = values if isinstance(values, Mapping) else dict.fromkeys(values, 1)
        word = 0
        found: list[Diagnostic] = []
        for name, value in wanted.items():
            try:
                field = self.field(name)
            except DiagnosticError as unknown:
                found.extend(unknown.diagnostics)
                continue
            if not 0 <= value <= field.maximum:
                message = f"{value} does not fit into '{name}' (bit {field.bit})"
                found.append(Diagnostic("FB1203", message, help=f"use 0 to {field.maximum}"))
            else:
                word |= value << field.low
        if found:
            raise DiagnosticError(found)
        return word

    def decode(self, word: int) -> tuple[DecodedField, ...]:
        """Every field with its value in `word`, highest bit first."""
        return tuple(self._decode(word))

    def _decode(self, word: int) -> Iterator[DecodedField]:
        for field in sorted(self.bits, key=lambda item: -item.low):
            value = field.extract(word)
            yield DecodedField(field, value, field.values.get(value, ""))

    def undefined(self, word: int) -> int:
        """Those set bits of `word` that have no meaning."""
        return word & 0xFFFF & ~self.defined
