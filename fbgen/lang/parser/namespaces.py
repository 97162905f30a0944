"""NAMESPACE and USING.

Source: IEC 61131-3 third edition, namespaces.
"""

from abc import ABC, abstractmethod

from fbgen.lang.ast import Namespace, Unit, Using
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.parser.members import MemberParser


class NamespaceParser(MemberParser, ABC):
    """Reads namespaces and what opens them."""

    @abstractmethod
    def units_until(self, end: str) -> list[Unit]:
        """All units up to the word `end`, or the end of the text."""

    def namespace(self) -> Namespace:
        """NAMESPACE ... END_NAMESPACE."""
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.NAMESPACES, first)
        modifiers = self.modifiers()
        name = self._dotted_name()
        self.deeper()
        units = self.units_until("END_NAMESPACE")
        self.depth -= 1
        closing = self.take_leading()
        if not self.accept("END_NAMESPACE"):
            self.missing_end("END_NAMESPACE", first)
        self.accept(";")
        return Namespace(self.span(first), name, modifiers, tuple(units), leading, closing)

    def using(self) -> Using:
        """USING a.b, c;"""
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.NAMESPACES, first)
        names = [self._dotted_name()]
        while self.accept(","):
            names.append(self._dotted_name())
        if not self.accept(";"):
            self.missing_semicolon("USING")
        place = self.span(first)
        leading, trailing = self.settle(leading)
        return Using(place, tuple(names), leading, trailing)

    def usings(self) -> tuple[Using, ...]:
        """All USING at the cursor, behind the name of a block."""
        found: list[Using] = []
        while self.kinds[self.at] == "USING":
            found.append(self.using())
        return tuple(found)

    def _dotted_name(self) -> str:
        parts = [self.name().name]
        while self.accept("."):
            parts.append(self.name().name)
        return ".".join(parts)
