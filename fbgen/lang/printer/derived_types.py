"""Enumerations, subranges, unions and references as text."""

from fbgen.lang.ast import (
    ArraySpec,
    Bounds,
    Enumerator,
    EnumSpec,
    NamedType,
    ReferenceSpec,
    StringSpec,
    SubrangeSpec,
    Trivia,
    TypeSpec,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.printer.statements import StatementPrinter
from fbgen.source import Span


class TypePrinter(StatementPrinter):
    """Writes types that need no lines of their own, and enumerations."""

    def type_text(self, spec: TypeSpec) -> str:
        """A type on one line; a structure and a union have none."""
        if isinstance(spec, NamedType):
            return f'"{spec.name}"' if spec.quoted else spec.name
        if isinstance(spec, StringSpec):
            name = "WSTRING" if spec.wide else "STRING"
            if spec.length is None:
                return name
            length = self.expression(spec.length)
            round_ones = self.dialect.has(Feature.ROUND_LENGTHS)
            return f"{name}({length})" if round_ones else f"{name}[{length}]"
        if isinstance(spec, ArraySpec | ReferenceSpec):
            inner, outside = self.innermost(spec)
            return outside + self.type_text(inner)
        if isinstance(spec, SubrangeSpec):
            bounds = f"{self.expression(spec.first)}..{self.expression(spec.last)}"
            return f"{self.type_text(spec.base)} ({bounds})"
        if isinstance(spec, EnumSpec):
            before, after = self._around_enumerators(spec)
            return f"{before}({', '.join(map(self._enumerator, spec.enumerators))}){after}"
        raise ValueError("a structure does not fit on one line")

    def innermost(self, spec: TypeSpec) -> tuple[TypeSpec, str]:
        """The type inside of arrays and references, and what is written in front of it."""
        outside: list[str] = []
        while True:
            if isinstance(spec, ArraySpec):
                bounds = ", ".join(self._bounds(one) for one in spec.bounds)
                outside.append(f"ARRAY[{bounds}] OF ")
                spec = spec.element
            elif isinstance(spec, ReferenceSpec):
                outside.append(f"{spec.keyword} ")
                spec = spec.target
            else:
                return spec, "".join(outside)

    def _bounds(self, bounds: Bounds) -> str:
        if bounds.first is None or bounds.last is None:
            return "*"
        return f"{self.expression(bounds.first)}..{self.expression(bounds.last)}"

    def enumeration(
        self, before: str, spec: EnumSpec, after: str, place: Span, trailing: Trivia | None
    ) -> None:
        """A line around an enumeration, or one a name if it is long or has comments."""
        text = f"{before}{self.type_text(spec)}{after}"
        if not _has_comments(spec) and self._fits(text):
            self.lines.add(text, place, trailing)
            return
        base_before, base_after = self._around_enumerators(spec)
        start = place._replace(end=place.start)
        self.lines.add(f"{before}{base_before}(", start)
        self.lines.level += 1
        last = len(spec.enumerators) - 1
        for number, one in enumerate(spec.enumerators):
            self.lines.trivia(one.leading)
            comma = "," if number < last else ""
            self.lines.add(self._enumerator(one) + comma, one.span, one.trailing)
        self.lines.trivia(spec.closing)
        self.lines.level -= 1
        self.lines.add(f"){base_after}{after}", start, trailing)

    def _around_enumerators(self, spec: EnumSpec) -> tuple[str, str]:
        """What stands in front of the list and behind it."""
        if spec.base is None:
            return "", ""
        base = self.type_text(spec.base)
        return ("", f" {base}") if self.dialect.has(Feature.BASE_BEHIND) else (f"{base} ", "")

    def _enumerator(self, one: Enumerator) -> str:
        return one.name if one.value is None else f"{one.name} := {self.expression(one.value)}"


def _has_comments(spec: EnumSpec) -> bool:
    return bool(spec.closing) or any(
        one.trailing is not None or any(item.text for item in one.leading)
        for one in spec.enumerators
    )
