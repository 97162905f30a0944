"""Units of a file: blocks, data blocks, types; configurations stand next door.

Source: TIA Portal help, "Using external source files"; IEC 61131-3, program organization units;
published sources for header lines in any order and comments between them.
"""

from fbgen.lang.ast import (
    Assignment,
    Block,
    BlockKind,
    DataBlock,
    Declaration,
    DeclaredName,
    Expression,
    File,
    Globals,
    HeaderItem,
    LabelSection,
    LoneMember,
    NamedType,
    StructSpec,
    TriviaList,
    TypeDeclaration,
    TypeSpec,
    UnionSpec,
    Unit,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.parser.cursor import Unexpected
from fbgen.lang.parser.declarations import BLOCK_ENDS, MEMBERS, SECTIONS, UNITS
from fbgen.lang.parser.headers import HeaderParser
from fbgen.lang.parser.meant_words import CONSTANT_SECTIONS, meant_section
from fbgen.lang.parser.statement_lists import STARTS
from fbgen.lang.parser.unread import UNREAD_SECTIONS

_FOREIGN_SECTIONS = {"CONST": Feature.CONST_SECTIONS, "LABEL": Feature.LABEL_SECTIONS}
_FEATURES = {
    "ORGANIZATION_BLOCK": Feature.ORGANIZATION_BLOCKS,
    "PROGRAM": Feature.PROGRAMS,
    "CLASS": Feature.CLASSES,
}


class BlockParser(HeaderParser):
    """Reads a whole file."""

    def file(self) -> File:
        """Everything the source holds."""
        units: list[Unit] = []
        while self.kinds[self.at] != "end":
            units += self.units_until("end")
        return File(self.source, self.dialect.name, tuple(units), self.take_leading())

    def units_until(self, end: str) -> list[Unit]:
        """All units up to the word `end`, or the end of the text."""
        units: list[Unit] = []
        depth = self.depth
        while self.kinds[self.at] not in (end, "end"):
            start = self.at
            try:
                units += self._units()
            except Unexpected:
                self.depth = depth
                self.open_lists.clear()
                self._skip_unit(start)
        return units

    def _skip_unit(self, start: int) -> None:
        if self.at == start:
            self.at += 1
        ends = ("end", "VAR_GLOBAL", "VAR_CONFIG", "END_NAMESPACE")
        while self.kinds[self.at] not in UNITS and self.kinds[self.at] not in ends:
            self.at += 1

    def _units(self) -> list[Unit]:
        kind = self.kinds[self.at]
        if kind in BlockKind.__members__:
            return [self._block(BlockKind[kind])]
        if kind == "DATA_BLOCK":
            return [self._data_block()]
        if kind == "TYPE":
            return list(self._types())
        if kind == "CONFIGURATION":
            return [self.configuration()]
        if kind in ("VAR_GLOBAL", "VAR_CONFIG"):
            section = self.section()
            return [Globals(section.span, section)]
        if kind == "INTERFACE":
            return [self.interface()]
        if kind == "NAMESPACE":
            return [self.namespace()]
        if kind == "USING":
            return [self.using()]
        if kind == ";":
            self.at += 1
            return []
        if kind in MEMBERS:
            return self._homeless_members()
        raise self.failed(
            "a block, a type or a data block",
            "statements stand in a block: write FUNCTION_BLOCK name in front of them"
            if kind in STARTS or self.kinds[self.at + 1] in (":=", "(", ".")
            else f"a file holds units such as {', '.join(sorted(UNITS))}",
        )

    def _homeless_members(self) -> list[Unit]:
        """Members without a block: the name of the file may say whose they are."""
        first = self.at
        if not self.dialect.has(Feature.OBJECTS):
            self.need(Feature.OBJECTS, first)
        members = self.members()
        return [] if self._findings else [LoneMember(one.span, one) for one in members]

    # --- blocks with code ---------------------------------------------------------------------

    def _block(self, kind: BlockKind) -> Block:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        if kind.value in _FEATURES:
            self.need(_FEATURES[kind.value], first)
        end = f"END_{kind.value}"
        modifiers = self.modifiers()
        name = self.block_name()
        return_type: TypeSpec | None = None
        header: list[HeaderItem] = []
        self.pragmas_into(header)
        usings = self.usings()
        generic = self.sections_here() if self.kinds[self.at] == "VAR_GENERIC" else ()
        extends, implements = self.base_types("EXTENDS"), self.base_types("IMPLEMENTS")
        if kind is BlockKind.FUNCTION and not self._lacks_result():
            self.expect(":", "':' and the type of the result", "without result it is ': Void'")
            return_type = self.type_spec()
        if not self.dialect.has(Feature.HEADERS):
            self.end_head()
        usings += self.usings()
        comments = self.header_items(header)
        sections, labels = self._interface()
        body_comments: TriviaList = ()
        if self.kinds[self.at] == "BEGIN":
            body_comments = self.take_leading()
            self.at += 1
            if comment := self.take_same_line():
                body_comments = (*body_comments, comment)
        body, members = self.statements_and_members(end)
        closing = self.take_leading()
        self._end_unit(end, first)
        if self.kinds[self.at] in MEMBERS:
            members += tuple(self.members())
        return Block(
            self.span(first),
            kind,
            name,
            return_type,
            tuple(header),
            (*generic, *sections),
            body,
            leading,
            comments,
            body_comments,
            closing,
            modifiers,
            extends[0] if extends else None,
            implements,
            members,
            labels,
            usings,
        )

    def _lacks_result(self) -> bool:
        """Whether this is a function without result that does not say so."""
        return self.kinds[self.at] != ":" and self.dialect.has(Feature.OBJECTS)

    def _interface(self) -> tuple[tuple[VarSection, ...], tuple[LabelSection, ...]]:
        """VAR, CONST and LABEL sections in any order."""
        sections: list[VarSection] = []
        labels: list[LabelSection] = []
        self.declared_addresses.clear()
        while True:
            kind = self.kinds[self.at]
            if kind == "LABEL":
                labels.append(self.label_section())
            elif more := self.sections_here():
                sections += more
            elif kind == "name" and self._misspelt_section():
                continue
            elif not (kind == "name" and self._foreign_section(self.texts[self.at].upper())):
                return tuple(sections), tuple(labels)

    def _misspelt_section(self) -> bool:
        """Whether a word in front of a declaration is nearly that of a section: it becomes one."""
        at = self.at
        if not (self.word(at + 1) and self.kinds[at + 2] in (":", ",")):
            return False
        meant = meant_section(self.texts[at], SECTIONS)
        if meant:
            is_constant = self.texts[at].upper() in CONSTANT_SECTIONS
            help_text = self.word_for_constants() if is_constant else f"write {meant}"
            self.unexpected("a section, BEGIN or a statement", help_text)
            self.kinds[at] = meant
        return bool(meant)

    def _foreign_section(self, word: str) -> bool:
        """Whether CONST or LABEL begins a section here, where the dialect has none."""
        feature = _FOREIGN_SECTIONS.get(word)
        if feature is None or not self.word(self.at + 1):
            return False
        at = self.at + 1
        while self.texts[at].upper() != f"END_{word}":
            if self.kinds[at] in UNITS or self.kinds[at] in ("BEGIN", "end"):
                return False
            at += 1
        self.missing_feature(feature, self.token_span(self.at))
        self.kinds[self.at], self.kinds[at] = word, f"END_{word}"
        return True

    def _end_unit(self, end: str, first: int) -> None:
        if self.accept(end):
            self.accept(";")
        elif self.kinds[self.at] in BLOCK_ENDS and self.is_last_of_unit():
            self.unexpected(end, f"write {end}, as it ends a {end.removeprefix('END_')}")
            self.at += 1
            self.accept(";")
        else:
            self.missing_end(end, first)

    def sections_here(self) -> tuple[VarSection, ...]:
        """All VAR sections at the cursor."""
        sections: list[VarSection] = []
        while True:
            kind = self.kinds[self.at]
            if kind in SECTIONS and self.kinds[self.at + 1] != ":=":
                sections.append(self.const_section() if kind == "CONST" else self.section())
            elif kind == "name" and self.texts[self.at].upper() in UNREAD_SECTIONS:
                raise self.unread(
                    self.texts[self.at].upper(), self.token_span(self.at), "leave it out"
                )
            else:
                return tuple(sections)

    # --- data blocks and types ----------------------------------------------------------------

    def _data_block(self) -> DataBlock:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.DATA_BLOCKS, first)
        self.declared_addresses.clear()
        name = self.block_name()
        header: list[HeaderItem] = []
        comments = self.header_items(header)
        type_name: NamedType | None = None
        struct: StructSpec | None = None
        sections: tuple[VarSection, ...] = ()
        kind = self.kinds[self.at]
        if kind == "STRUCT":
            comments += self.take_leading()
            struct = self.struct_type()
            self.accept(";")
        elif kind in SECTIONS:
            sections = self.sections_here()
        elif kind == "ARRAY":
            comments += self.take_leading()
            sections = (self._elements(),)
        elif kind in ("name", '"'):
            comments += self.take_leading()
            type_name = self.named_type()
            self.accept(";")
        else:
            raise self.failed("STRUCT, VAR, or the name of a type or function block")
        self.more_header(header)
        assignments: tuple[Assignment, ...] = ()
        if self.kinds[self.at] == "BEGIN":
            comments += self.take_before(self.at)
            self.at += 1
            assignments = self._start_values()
        closing = self.take_leading()
        self._end_unit("END_DATA_BLOCK", first)
        return DataBlock(
            self.span(first),
            name,
            tuple(header),
            type_name,
            struct,
            sections,
            assignments,
            leading,
            comments,
            closing,
            kind == "ARRAY",
        )

    def _elements(self) -> VarSection:
        """The type of an ARRAY data block, as the section with its only variable, THIS."""
        first = self.at
        elements = self.type_spec()
        self.need(Feature.ARRAY_BLOCKS, first)
        self.accept(";")
        this = DeclaredName(elements.span, "THIS")
        return VarSection(
            elements.span, "VAR", (), (Declaration(elements.span, (this,), elements, None),)
        )

    def _start_values(self) -> tuple[Assignment, ...]:
        assignments: list[Assignment] = []
        depth = self.depth
        while self.kinds[self.at] not in ("END_DATA_BLOCK", "end") and (
            self.kinds[self.at] not in UNITS
        ):
            if self.accept(";"):
                continue
            start = self.at
            try:
                assignments.append(self._start_value())
            except Unexpected:
                self.depth = depth
                self.skip_statement(start)
        return tuple(assignments)

    def _start_value(self) -> Assignment:
        leading = self.take_leading()
        first = self.at
        target = self.operand()
        self.expect(":=", "':='", "a start value looks like name := 5;")
        value = self.initial_value()
        if not self.accept(";"):
            self.missing_semicolon("the assignment")
        place = self.span(first)
        leading, trailing = self.settle(leading)
        return Assignment(place, target, ":=", value, leading, trailing)

    def _types(self) -> list[TypeDeclaration]:
        """All types between TYPE and END_TYPE."""
        leading = self.take_leading()
        first = self.at
        self.at += 1
        declarations: list[TypeDeclaration] = []
        while self.kinds[self.at] in ("name", '"') or (
            self.word(self.at) and self.kinds[self.at + 1] == ":"
        ):
            start = self.at if declarations else first
            leading = (*leading, *self.take_leading())
            declarations.append(self._type(start, leading))
            leading = ()
        if not declarations:
            raise self.failed("the name of a type")
        closing = self.take_leading()
        self._end_unit("END_TYPE", first)
        if closing:
            declarations[-1] = _with_closing(declarations[-1], closing)
        return declarations

    def _type(self, first: int, leading: TriviaList) -> TypeDeclaration:
        modifiers = self.modifiers()
        name = self.block_name()
        extends = self.base_types("EXTENDS")
        header: list[HeaderItem] = []
        comments: TriviaList = ()
        if self.kinds[self.at] != ":":
            comments = self.header_items(header)
        self.accept(":")
        comments += self.take_leading()
        spec = self.type_spec()
        initial: Expression | None = None
        if self.accept(":="):
            initial = self.initial_value()
        if not self.accept(";") and not isinstance(spec, StructSpec | UnionSpec):
            self.missing_semicolon("the type")
        place = self.span(first)
        leading, trailing = self.settle(leading)
        closing = (trailing,) if trailing else ()
        return TypeDeclaration(
            place,
            name,
            tuple(header),
            spec,
            initial,
            leading,
            comments,
            closing,
            modifiers,
            extends[0] if extends else None,
        )


def _with_closing(declaration: TypeDeclaration, closing: TriviaList) -> TypeDeclaration:
    return TypeDeclaration(
        declaration.span,
        declaration.name,
        declaration.header,
        declaration.type,
        declaration.initial,
        declaration.leading,
        declaration.header_comments,
        (*declaration.closing, *closing),
        declaration.modifiers,
        declaration.extends,
    )
