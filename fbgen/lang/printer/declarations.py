"""Types, declarations and sections as lines."""

from fbgen.lang.ast import (
    ArrayLiteral,
    Declaration,
    DeclaredName,
    DirectAddress,
    EnumSpec,
    LabelSection,
    NamedType,
    StructSpec,
    Trivia,
    TypeSpec,
    UnionSpec,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.printer.derived_types import TypePrinter
from fbgen.source import Span


def _last(place: Span) -> Span:
    return place._replace(start=max(place.start, place.end - 1))


class DeclarationPrinter(TypePrinter):
    """Writes what is declared."""

    def section(self, section: VarSection) -> None:
        """VAR ... END_VAR, or CONST ... END_CONST."""
        self.lines.trivia(section.leading)
        keyword, end = " ".join((section.keyword, *section.qualifiers)), "END_VAR"
        if section.qualifiers == ("CONSTANT",) and self.dialect.has(Feature.CONST_SECTIONS):
            keyword, end = "CONST", "END_CONST"
        start = section.span._replace(end=section.span.start)
        self.lines.add(keyword, start, section.opening)
        self.lines.level += 1
        for declaration in section.declarations:
            self.declaration(declaration)
        self.lines.trivia(section.closing)
        self.lines.level -= 1
        self.lines.add(end, _last(section.span), section.trailing)

    def label_section(self, section: LabelSection) -> None:
        """LABEL ... END_LABEL."""
        self.lines.trivia(section.leading)
        start = section.span._replace(end=section.span.start)
        self.lines.add("LABEL", start)
        self.lines.level += 1
        if section.names:
            self.lines.add(f"{', '.join(map(self.name, section.names))};", section.span)
        self.lines.trivia(section.closing)
        self.lines.level -= 1
        self.lines.add("END_LABEL", _last(section.span), section.trailing)

    def declaration(self, declaration: Declaration) -> None:
        """One declaration; a structure takes several lines."""
        self.lines.trivia(declaration.leading)
        names = ", ".join(_declared(name) for name in declaration.names)
        at = declaration.at
        located = ""
        if at is not None:
            place = self.expression(at) if isinstance(at, DirectAddress) else self.name(at)
            located = f" AT {place}"
        attributes = f" {declaration.type_attributes}" if declaration.type_attributes else ""
        more = f" {declaration.edge}" if declaration.edge else ""
        if declaration.arguments:
            text = self.arguments(declaration.arguments)
            for_each = isinstance(declaration.arguments[0].value, ArrayLiteral)
            more += text if for_each else f"({text})"
        if declaration.initial is not None:
            more += f" {declaration.operator} {self.expression(declaration.initial)}"
        if isinstance(declaration.type, NamedType) and not declaration.type.name:
            self.lines.add(f"{names}{more};", declaration.span, declaration.trailing)
            return
        self.typed(
            f"{names}{located} :{attributes} ",
            declaration.type,
            f"{more};",
            declaration.span,
            declaration.trailing,
        )

    def typed(
        self, before: str, spec: TypeSpec, after: str, place: Span, trailing: Trivia | None
    ) -> None:
        """A line, or lines, around a type."""
        inner, outside = self.innermost(spec)
        text = before + outside
        if isinstance(inner, EnumSpec):
            self.enumeration(text, inner, after, place, trailing)
            return
        if not isinstance(inner, StructSpec | UnionSpec):
            self.lines.add(f"{text}{self.type_text(inner)}{after}", place, trailing)
            return
        word = "STRUCT" if isinstance(inner, StructSpec) else "UNION"
        self.lines.add(f"{text}{word}", place._replace(end=inner.span.start), inner.opening)
        self.lines.level += 1
        for field in inner.fields:
            self.declaration(field)
        self.lines.trivia(inner.closing)
        self.lines.level -= 1
        self.lines.add(f"END_{word}{after}", _last(place), trailing)


def _declared(name: DeclaredName) -> str:
    text = f'"{name.name}"' if name.quoted else name.name
    return f"{text} {name.attributes}" if name.attributes else text
