"""Types, declarations and VAR sections.

Source: IEC 61131-3, variables and data types; TIA Portal help, "Block interface"; published
sources for attributes in odd places, END_STRUCT without semicolon and reserved words as names.
"""

from fbgen.diagnostics import Note
from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    ArraySpec,
    Bounds,
    Declaration,
    DeclaredName,
    DirectAddress,
    Expression,
    LabelSection,
    Name,
    NamedType,
    ReferenceSpec,
    StringSpec,
    StructSpec,
    TriviaList,
    TypeSpec,
    UnionSpec,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.parser.addresses import read_area
from fbgen.lang.parser.cursor import Unexpected
from fbgen.lang.parser.derived_types import DerivedTypeParser
from fbgen.lang.parser.meant_words import CONSTANT_SECTIONS
from fbgen.lang.parser.places import NAMES
from fbgen.lang.parser.set_assignments import SetAssignmentParser

SECTIONS = words(
    "VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_STAT VAR_INST VAR_GLOBAL VAR_EXTERNAL CONST "
    "VAR_GENERIC VAR_CONFIG"
)
_QUALIFIERS = words(
    "CONSTANT RETAIN NON_RETAIN PERSISTENT DB_SPECIFIC R_EDGE F_EDGE "
    "PUBLIC PRIVATE PROTECTED INTERNAL"
)
MEMBERS = words("METHOD PROPERTY ACTION")
"""Keywords that begin a member of a block."""

UNITS = MEMBERS | words(
    "FUNCTION_BLOCK FUNCTION ORGANIZATION_BLOCK PROGRAM DATA_BLOCK TYPE CONFIGURATION "
    "CLASS INTERFACE NAMESPACE USING"
)
"""Keywords that begin a unit of a file."""

BLOCK_ENDS = words(
    "END_FUNCTION_BLOCK END_FUNCTION END_ORGANIZATION_BLOCK END_PROGRAM END_DATA_BLOCK END_TYPE"
)
"""Ends of units that stand in no other one but a namespace."""

_UNIT_ENDS = frozenset(
    {f"END_{unit}" for unit in UNITS} | words("END_RESOURCE BEGIN end END_REGION END_GET END_SET")
)
_INNER_ENDS = words("END_VAR END_STRUCT END_UNION END_CONST END_LABEL")
_SECTION_ENDS = SECTIONS | _UNIT_ENDS | _INNER_ENDS | {"LABEL"}
_ENDS_WITH_SEMICOLON = words("END_IF END_CASE END_FOR END_WHILE END_REPEAT END_STRUCT")
_REFERENCES = {"REF_TO": "", "REFERENCE": "TO", "POINTER": "TO"}
"""Words in front of the type that is referred to, with the word that may follow them."""
_EDGES = words("R_EDGE F_EDGE")


class DeclarationParser(DerivedTypeParser, SetAssignmentParser):
    """Reads what is declared."""

    _in_const_section = False
    _has_paths = False

    # --- types --------------------------------------------------------------------------------

    def type_spec(self) -> TypeSpec:
        """A type where one is used."""
        at = self.at
        kind = self.kinds[at]
        if kind == "ARRAY":
            return self._array_type()
        if kind == "STRUCT":
            return self.struct_type()
        if kind == '"':
            name = self.name()
            return NamedType(name.span, name.name, True)
        if kind == "name":
            word = self.texts[at].upper()
            if word in ("STRING", "WSTRING"):
                return self._string_type(word == "WSTRING")
            following = self.kinds[at + 1]
            if word in _REFERENCES and (not _REFERENCES[word] or following == _REFERENCES[word]):
                return self._reference_type(word)
            if following not in (";", ":="):
                return self.type_with_more()
            self.at = at + 1
            if self.dialect.absent_types:
                self.check_type(word, self.token_span(at))
            return NamedType(self.token_span(at), self.texts[at])
        if kind == "(":
            return self.enumeration()
        raise self.failed("a type", "a type is BOOL, INT, ARRAY[0..7] OF BYTE, STRUCT or a name")

    def _reference_type(self, word: str) -> ReferenceSpec:
        first = self.at
        self.at += 2 if _REFERENCES[word] else 1
        self.need(Feature.REFERENCES, first)
        self.deeper()
        target = self.type_spec()
        self.depth -= 1
        return ReferenceSpec(self.span(first), f"{word} {_REFERENCES[word]}".rstrip(), target)

    def _string_type(self, wide: bool) -> StringSpec:
        first = self.at
        self.check_type("WSTRING" if wide else "STRING", self.token_span(first))
        self.at += 1
        length: Expression | None = None
        for opening, closing in (("[", "]"), ("(", ")")):
            if self.accept(opening):
                length = self.expression()
                self.expect(closing)
                break
        return StringSpec(self.span(first), wide, length)

    def _array_type(self) -> ArraySpec:
        first = self.at
        self.at += 1
        self.expect("[", "'['", "an array type looks like ARRAY[0..7] OF BYTE")
        bounds = [self._bounds()]
        while self.accept(","):
            bounds.append(self._bounds())
        self.expect("]", "']' or ','")
        self.expect("OF", "OF", "an array type looks like ARRAY[0..7] OF BYTE")
        self.deeper()
        element = self.type_spec()
        self.depth -= 1
        return ArraySpec(self.span(first), tuple(bounds), element)

    def _bounds(self) -> Bounds:
        first = self.at
        if self.accept("*"):
            return Bounds(self.span(first), None, None)
        low = self.expression()
        self.expect("..", "'..'", "bounds look like 0..7")
        high = self.expression()
        return Bounds(self.span(first), low, high)

    def struct_type(self) -> StructSpec:
        """STRUCT ... END_STRUCT, without the semicolon behind it."""
        first = self.expect("STRUCT")
        opening = self.take_same_line()
        self.deeper()
        fields = self.fields("END_STRUCT", first)
        self.depth -= 1
        closing = self.take_leading()
        self.end_section("END_STRUCT", first)
        return StructSpec(self.span(first), fields, closing, opening)

    # --- sections -----------------------------------------------------------------------------

    def section(self) -> VarSection:
        """VAR ... END_VAR of any kind."""
        leading = self.take_leading()
        first = self.at
        keyword = self.kinds[first]
        self.at = first + 1
        qualifiers: list[str] = []
        while self.kinds[self.at] == "name" and self.texts[self.at].upper() in _QUALIFIERS:
            if self.kinds[self.at + 1] in (":", ","):
                break
            qualifiers.append(self.texts[self.at].upper())
            self.at += 1
        if "CONSTANT" in qualifiers:
            self.need(Feature.VAR_CONSTANT, first)
        elif self.texts[first].upper() in CONSTANT_SECTIONS:
            qualifiers.append("CONSTANT")
        opening = self.take_same_line()
        self._has_paths = keyword == "VAR_CONFIG"
        declarations = self.fields("END_VAR", first)
        self._has_paths = False
        closing = self.take_leading()
        self.end_section("END_VAR", first)
        if not self.starts_line(self.at):
            self.accept(";")
        span = self.span(first)
        leading, trailing = self.settle(leading)
        return VarSection(
            span, keyword, tuple(qualifiers), declarations, leading, trailing, closing, opening
        )

    def word_for_constants(self) -> str:
        """What to write for a section of constants."""
        return self.dialect.advice.get(Feature.VAR_CONSTANT, "write VAR CONSTANT")

    def const_section(self) -> VarSection:
        """CONST name := value; ... END_CONST: the constants have the types of their values."""
        leading = self.take_leading()
        first = self.at
        self.at = first + 1
        opening = self.take_same_line()
        self._in_const_section = True
        try:
            declarations = self.fields("END_CONST", first)
        finally:
            self._in_const_section = False
        closing = self.take_leading()
        self.end_section("END_CONST", first)
        self.accept(";")
        span = self.span(first)
        leading, trailing = self.settle(leading)
        return VarSection(
            span, "VAR", ("CONSTANT",), declarations, leading, trailing, closing, opening
        )

    def label_section(self) -> LabelSection:
        """LABEL a, b; END_LABEL."""
        leading = self.take_leading()
        first = self.at
        self.at = first + 1
        names: list[Name] = []
        while self.kinds[self.at] not in _SECTION_ENDS:
            try:
                names.append(self.name())
                if not self.accept(",") and self.kinds[self.at] != "END_LABEL":
                    self.expect(";", "',' or ';'", "write LABEL first, second; END_LABEL")
            except Unexpected:
                self._skip_declaration(self.at)
        self.end_section("END_LABEL", first)
        self.accept(";")
        span = self.span(first)
        leading, trailing = self.settle(leading)
        return LabelSection(span, tuple(names), leading, trailing)

    def end_section(self, end: str, first: int) -> None:
        """Read the word `end`, or report that what began with token `first` lacks it."""
        if not self.accept(end):
            self.missing_end(end, first)

    def missing_end(self, end: str, first: int, hint: str = "") -> None:
        """Report that what began with token `first` has no end before the next token.

        Behind a comment that swallows the rest of the text nothing is missing but its end.
        """
        if self.at == self._last_finding_at:
            return
        self._last_finding_at = self.at
        if self.kinds[self.at] == "end" and self.is_cut_off:
            return
        opener = self.token_span(first)
        found = self.texts[self.at].strip() or "the end of the file"
        semicolon = ";" if end in _ENDS_WITH_SEMICOLON else ""
        self.report(
            "FB3007",
            f"{opener.text.split()[0].upper()} has no {end} before {found}",
            opener,
            hint or f"write {end}{semicolon} where it ends",
            (Note(f"{end} is missing at the latest here", self.token_span(self.at)),),
        )

    def fields(self, end: str, first: int) -> tuple[Declaration, ...]:
        """Everything up to `end`, which is not read."""
        declarations: list[Declaration] = []
        depth = self.depth
        while True:
            kind = self.kinds[self.at]
            if kind == end:
                break
            if kind in _SECTION_ENDS and not self._is_declared_keyword():
                if kind in _INNER_ENDS and depth == 0 and end in ("END_VAR", "END_CONST"):
                    self.unexpected(f"a declaration or {end}")
                    self.at += 1
                    self.accept(";")
                    continue
                break
            if kind == ";":
                self.at += 1
                continue
            start = self.at
            try:
                declarations.append(self._declaration())
            except Unexpected:
                self.depth = depth
                self._skip_declaration(start)
        return tuple(declarations)

    def _is_declared_keyword(self) -> bool:
        """Whether the keyword here is used as the name of a variable."""
        return self.word(self.at) and self.kinds[self.at + 1] in (":", ",")

    def _skip_declaration(self, start: int) -> None:
        """Go to the next place where a declaration can begin."""
        if self.at == start and self.kinds[self.at] not in _SECTION_ENDS:
            self.at += 1
        while True:
            kind = self.kinds[self.at]
            if kind == ";":
                self.at += 1
                return
            if kind in _SECTION_ENDS:
                return
            if self.kinds[self.at + 1] == ":" and self.starts_line(self.at):
                return
            self.at += 1

    def _declaration(self) -> Declaration:
        first = self.at
        kinds = self.kinds
        leading = self.take_leading() if self.extra_at <= first else ()
        names = [self._declared_name()]
        while kinds[self.at] == ",":
            self.at += 1
            names.append(self._declared_name())
        at: DirectAddress | Name | None = None
        if self._in_const_section:
            return self._constant(first, tuple(names), leading)
        if kinds[self.at] != ":":
            if self.accept_word("AT"):
                at = self.address() if kinds[self.at] == "address" else self.name()
            self.expect(":", "':'", "a declaration looks like name : TYPE;")
        else:
            self.at += 1
        type_attributes = self.pragma_text() if self.extra_at <= self.at else ""
        type_spec = self.type_spec()
        if self.extra_at <= self.at:
            type_attributes = type_attributes or self.pragma_text()
        initial: Expression | None = None
        arguments: tuple[Argument, ...] = ()
        edge = operator = ""
        behind = at is None and kinds[self.at + 1] == "address"
        if behind and self.dialect.has(Feature.CONFIGURATIONS) and self.accept_word("AT"):
            at = self.address()  # behind the type, as OpenPLC writes it
        if kinds[self.at] not in (";", ":="):
            edge, arguments, operator = self._rest_of_type(type_spec)
        if operator or kinds[self.at] == ":=":
            self.at += 1
            is_array = isinstance(type_spec, ArraySpec)
            initial = self.array_value() if is_array else self.initial_value()
        if kinds[self.at] == ";":
            self.at += 1
        elif not isinstance(type_spec, StructSpec | UnionSpec):
            self.missing_semicolon("the declaration")
        span = self.span(first)
        trailing = None
        if self.extra_at <= self.at:
            leading, trailing = self.settle(leading)
        if not (edge or arguments or operator):
            return Declaration(
                span, tuple(names), type_spec, initial, at, type_attributes, leading, trailing
            )
        return Declaration(
            span,
            tuple(names),
            type_spec,
            initial,
            at,
            type_attributes,
            leading,
            trailing,
            arguments,
            edge,
            operator or ":=",
        )

    def _rest_of_type(self, spec: TypeSpec) -> tuple[str, tuple[Argument, ...], str]:
        """What can stand between a type and its initial value: an edge, the arguments of FB_init
        (for each element of an array in brackets), and `REF=` in place of `:=`."""
        edge = ""
        arguments: tuple[Argument, ...] = ()
        if self.kinds[self.at] == "name" and self.texts[self.at].upper() in _EDGES:
            edge = self.texts[self.at].upper()
            self.at += 1
        if self.kinds[self.at] == "[" and isinstance(spec, ArraySpec):
            self.need(Feature.OBJECTS, self.at)
            each = self.initial_value()
            arguments = (Argument(each.span, ArgumentKind.POSITIONAL, "", each),)
        elif self.kinds[self.at] == "(" and isinstance(spec, NamedType | ArraySpec):
            self.need(Feature.OBJECTS, self.at)
            self.at += 1
            arguments = self.arguments()
        return edge, arguments, self.set_operator()

    def _constant(
        self, first: int, names: tuple[DeclaredName, ...], leading: TriviaList
    ) -> Declaration:
        """`name := value;` of a CONST section, from the `:=` on."""
        self.expect(":=", "':='", "constants have the type of their value: LIMIT := 10;")
        initial = self.initial_value()
        if not self.accept(";"):
            self.missing_semicolon("the constant")
        span = self.span(first)
        leading, trailing = self.settle(leading)
        no_type = NamedType(names[-1].span._replace(start=names[-1].span.end), "")
        return Declaration(span, names, no_type, initial, None, "", leading, trailing)

    def missing_semicolon(self, what: str) -> None:
        """Report that there is no ';' behind the last token; skip the rest of its line's junk."""
        at = self.at
        if at == self._last_finding_at:
            raise Unexpected
        if self.starts_line(at) or self.kinds[at] in _SECTION_ENDS or self.kinds[at] == "end":
            end = self.ends[at - 1]
            place = self.token_span(at - 1)._replace(start=max(end - 1, 0))
            self._last_finding_at = at
            self.report("FB3010", f"{what} has no ';' at its end", place, "write ';' here")
            return
        raise self.failed("';'", "a statement or declaration ends with ';'")

    def _path(self, first: int) -> DeclaredName:
        """The variable of an instance that VAR_CONFIG means, `Main.pump.speed`."""
        while self.accept("."):
            self.name()
        return DeclaredName(self.span(first), self.span(first).text.replace(" ", ""))

    def _declared_name(self) -> DeclaredName:
        at = self.at
        kind = self.kinds[at]
        if kind == "name" or (self.word(at) and kind not in _INNER_ENDS):
            self.at = at + 1
            if kind == "address" or read_area(self.texts[at]) is not None:
                self.declared_addresses.add(self.texts[at].casefold())
            attributes = self.pragma_text() if self.extra_at <= self.at else ""
            if self._has_paths:
                return self._path(at)
            return DeclaredName(self.token_span(at), self.texts[at], False, attributes)
        if kind not in NAMES:
            raise self.failed("the name of a variable")
        name = self.name()
        if name.local:
            self.report(
                "FB3001", "found '#' in a declaration", name.span, "declare the name without '#'"
            )
        return DeclaredName(name.span, name.name, name.quoted, self.pragma_text())
