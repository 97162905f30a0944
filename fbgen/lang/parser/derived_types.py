"""Types made of others: enumerations, subranges, unions, names in namespaces.

Source: IEC 61131-3 third edition, user-defined data types; CODESYS and TwinCAT help,
"Enumerations" and "Unions": there the base type of an enumeration stands behind.
"""

from abc import ABC, abstractmethod

from fbgen.lang.ast import (
    Declaration,
    Enumerator,
    EnumSpec,
    Expression,
    NamedType,
    SubrangeSpec,
    TypeSpec,
    UnionSpec,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.parser.expressions import ExpressionParser
from fbgen.lang.parser.places import NAMES

_BASES = words("SINT INT DINT LINT USINT UINT UDINT ULINT BYTE WORD DWORD LWORD")
"""What an enumeration or a subrange can be made of, without naming a type of one's own."""


class DerivedTypeParser(ExpressionParser, ABC):
    """Reads types that begin with a name or with '('."""

    @abstractmethod
    def type_spec(self) -> TypeSpec:
        """Any type."""

    @abstractmethod
    def fields(self, end: str, first: int) -> tuple[Declaration, ...]:
        """The declarations up to the word `end`, which is not read."""

    def named_type(self) -> NamedType:
        """The name of a type, in a namespace or not."""
        at = self.at
        name = self.block_name()
        if self.kinds[self.at] != ".":
            return NamedType(name.span, name.name, name.quoted)
        parts = [name.name]
        while self.accept("."):
            parts.append(self.name().name)
        return NamedType(self.span(at), ".".join(parts))

    def type_with_more(self) -> TypeSpec:
        """A type that begins with a name and is not only a name."""
        at = self.at
        word, following = self.texts[at].upper(), self.kinds[at + 1]
        if word == "UNION" and (following in NAMES or self.word(at + 1)):
            return self._union()
        base = self.named_type()
        if self.kinds[self.at] == "<":
            return self._generic(base)
        if self.kinds[self.at] == "(":
            if word in _BASES and self.kinds[self.at + 1] == "name":
                if self.kinds[self.at + 2] in (",", ")", ":="):
                    return self.enumeration(base)
            elif word not in _BASES and ".." not in self.kinds[self.at : self.at + 4]:
                return base
            return self._subrange(base)
        return base

    def _generic(self, base: NamedType) -> NamedType:
        """`Buffer<6, true>` of CODESYS: a block with values for its VAR_GENERIC."""
        first = self.at
        self.need(Feature.OBJECTS, first)
        while self.kinds[self.at] not in (">", ";", ":=", "end"):
            self.at += 1
        values = "".join(self.texts[first + 1 : self.at]).replace(",", ", ")
        self.expect(">", "'>'", "values for VAR_GENERIC look like Buffer<6>")
        return NamedType(base.span.to(self.span(first)), f"{base.name}<{values}>")

    def _union(self) -> UnionSpec:
        first = self.at
        self.at += 1
        self.need(Feature.UNIONS, first)
        opening = self.take_same_line()
        self.deeper()
        fields = self.fields("END_UNION", first)
        self.depth -= 1
        closing = self.take_leading()
        self.end_section("END_UNION", first)
        return UnionSpec(self.span(first), fields, closing, opening)

    @abstractmethod
    def end_section(self, end: str, first: int) -> None:
        """Read the word `end`, or report that what began with token `first` lacks it."""

    def _subrange(self, base: NamedType) -> SubrangeSpec:
        opening = self.expect("(")
        low = self.expression()
        self.expect("..", "'..'", "a subrange looks like INT (0..100)")
        high = self.expression()
        self.expect(")", "')'", "a subrange looks like INT (0..100)")
        self.need(Feature.SUBRANGES, opening)
        return SubrangeSpec(base.span.to(self.span(opening)), base, low, high)

    def enumeration(self, base: NamedType | None = None) -> EnumSpec:
        """`(red, green := 5)`, with its base type in front (read already) or behind."""
        opening = self.expect("(")
        self.deeper()
        enumerators: list[Enumerator] = []
        while self.kinds[self.at] != ")":
            enumerator, more = self._enumerator()
            enumerators.append(enumerator)
            if not more:
                break
        closing = self.take_leading()
        self.expect(")", "')' or ','", "an enumeration looks like (red, green := 5, blue)")
        self.depth -= 1
        self.need(Feature.ENUMERATIONS, opening)
        place = self.span(opening)
        if base is not None:
            place = base.span.to(place)
        elif self.kinds[self.at] == "name":
            base = self.named_type()
            place = place.to(base.span)
        return EnumSpec(place, tuple(enumerators), base, closing)

    def _enumerator(self) -> tuple[Enumerator, bool]:
        leading = self.take_leading()
        first = self.at
        if not self.word(first):
            raise self.failed("the name of an enumerator")
        self.at += 1
        value: Expression | None = self.expression() if self.accept(":=") else None
        place = self.span(first)
        more = self.accept(",")
        leading, trailing = self.settle(leading)
        return Enumerator(place, self.texts[first], value, leading, trailing), more
