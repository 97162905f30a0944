"""Types, declarations and sections as lines."""

from fbgen.lang.ast import (
    ArraySpec,
    Bounds,
    Declaration,
    DeclaredName,
    DirectAddress,
    LabelSection,
    NamedType,
    ReferenceSpec,
    StringSpec,
    StructSpec,
    Trivia,
    TypeSpec,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.printer.statements import StatementPrinter
from fbgen.source import Span


class DeclarationPrinter(StatementPrinter):
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
        self.lines.add(end, start, section.trailing)

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
        self.lines.add("END_LABEL", start, section.trailing)

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
        initial = declaration.initial
        value = f" := {self.expression(initial)}" if initial is not None else ""
        if isinstance(declaration.type, NamedType) and not declaration.type.name:
            self.lines.add(f"{names}{value};", declaration.span, declaration.trailing)
            return
        self.typed(
            f"{names}{located} :{attributes} ",
            declaration.type,
            f"{value};",
            declaration.span,
            declaration.trailing,
        )

    def typed(
        self, before: str, spec: TypeSpec, after: str, place: Span, trailing: Trivia | None
    ) -> None:
        """A line, or lines, around a type."""
        inner, outside = _innermost(spec)
        text = before + "".join(self._array_text(array) for array in outside)
        if not isinstance(inner, StructSpec):
            self.lines.add(f"{text}{self.type_text(inner)}{after}", place, trailing)
            return
        self.lines.add(f"{text}STRUCT", place._replace(end=inner.span.start), inner.opening)
        self.lines.level += 1
        for field in inner.fields:
            self.declaration(field)
        self.lines.trivia(inner.closing)
        self.lines.level -= 1
        self.lines.add(f"END_STRUCT{after}", place._replace(end=place.start), trailing)

    def type_text(self, spec: TypeSpec) -> str:
        """A type on one line; a structure has none."""
        if isinstance(spec, NamedType):
            return f'"{spec.name}"' if spec.quoted else spec.name
        if isinstance(spec, StringSpec):
            name = "WSTRING" if spec.wide else "STRING"
            return name if spec.length is None else f"{name}[{self.expression(spec.length)}]"
        if isinstance(spec, ArraySpec):
            return self._array_text(spec) + self.type_text(spec.element)
        if isinstance(spec, ReferenceSpec):
            return f"{spec.keyword} {self.type_text(spec.target)}"
        raise ValueError("a structure does not fit on one line")

    def _array_text(self, array: ArraySpec) -> str:
        bounds = ", ".join(self._bounds(one) for one in array.bounds)
        return f"ARRAY[{bounds}] OF "

    def _bounds(self, bounds: Bounds) -> str:
        if bounds.first is None or bounds.last is None:
            return "*"
        return f"{self.expression(bounds.first)}..{self.expression(bounds.last)}"


def _innermost(spec: TypeSpec) -> tuple[TypeSpec, list[ArraySpec]]:
    """The element of arrays of arrays, and the arrays around it."""
    outside: list[ArraySpec] = []
    while isinstance(spec, ArraySpec):
        outside.append(spec)
        spec = spec.element
    return spec, outside


def _declared(name: DeclaredName) -> str:
    text = f'"{name.name}"' if name.quoted else name.name
    return f"{text} {name.attributes}" if name.attributes else text
