"""Whole units and files as lines.

Source: the order of header lines and the place of comments in published TIA Portal exports: no
comment may stand between a block's first line and its first section, so those go above the block.
"""

from collections.abc import Callable
from typing import Any

from fbgen.lang.ast import (
    Block,
    Configuration,
    DataBlock,
    File,
    Globals,
    HeaderItem,
    Interface,
    LoneMember,
    Namespace,
    ProgramInstance,
    Resource,
    StructSpec,
    Task,
    TriviaKind,
    TriviaList,
    TypeDeclaration,
    Unit,
    Using,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.printer.members import (
    MemberPrinter,
    first_of,
    last_of,
    without_last_blanks,
)

_HEADER_ORDER = ("TITLE", "{}", "AUTHOR", "FAMILY", "NAME", "VERSION")


class UnitPrinter(MemberPrinter):
    """Writes a whole file."""

    def file(self, file: File) -> None:
        """All units, one blank line between them."""
        self._units(file.units)
        self.lines.trivia(without_last_blanks(file.closing))

    def _units(self, units: tuple[Unit, ...]) -> None:
        for number, unit in enumerate(units):
            if number:
                self.lines.blank()
            _WRITERS[type(unit)](self, unit)

    def _namespace(self, node: Namespace) -> None:
        self.lines.trivia(node.leading)
        words = ("NAMESPACE", *node.modifiers, node.name)
        self.lines.add(" ".join(words), first_of(node.span))
        self.lines.level += 1
        self._units(node.units)
        self.lines.trivia(without_last_blanks(node.closing))
        self.lines.level -= 1
        self.lines.add("END_NAMESPACE", last_of(node.span))

    # --- blocks with code ---------------------------------------------------------------------

    def _block(self, block: Block) -> None:
        sections = block.sections
        above: TriviaList = ()
        if sections and self.dialect.has(Feature.HEADERS):
            above, sections = _first_comments_apart(sections)
        self.lines.trivia((*block.leading, *block.header_comments, *above))
        behind = self.heading(block)
        self.header_items(block.header)
        self.sections(sections if behind is block.sections else behind)
        self.lines.level += 1
        for labels in block.labels:
            self.label_section(labels)
        self.lines.level -= 1
        self.members(block.members)
        self.lines.trivia(without_last_blanks(block.body_comments))
        if self.dialect.has(Feature.HEADERS):
            self.lines.blank()
            self.lines.add("BEGIN", first_of(block.span))
        self.statements(block.body, without_last_blanks(block.closing))
        self.lines.add(f"END_{block.kind.value}", last_of(block.span))

    def header_items(self, header: tuple[HeaderItem, ...]) -> None:
        """Lines of the header in the order of exports."""
        order = {keyword: number for number, keyword in enumerate(_HEADER_ORDER)}
        for item in sorted(header, key=lambda item: order.get(item.keyword, len(order))):
            if item.keyword == "{}":
                text = item.text
            elif item.keyword == "TITLE":
                text = f"TITLE = {item.text}"
            elif item.keyword in order:
                text = f"{item.keyword} : {item.text}"
            else:
                text = item.keyword
            self.lines.add(text, item.span)

    # --- data blocks and types ----------------------------------------------------------------

    def _data_block(self, block: DataBlock) -> None:
        self.lines.trivia((*block.leading, *block.header_comments))
        self.lines.add(f"DATA_BLOCK {self.name(block.name)}", first_of(block.span))
        self.header_items(block.header)
        if block.type:
            self.lines.add(self.type_text(block.type), block.type.span)
        if block.struct:
            self._own_structure(block.struct)
        if block.is_array and block.sections:
            elements = block.sections[0].declarations[0].type
            self.lines.add(self.type_text(elements), elements.span)
        else:
            self.sections(block.sections)
        self.lines.blank()
        self.lines.add("BEGIN", first_of(block.span))
        self.statements(block.assignments, without_last_blanks(block.closing))
        self.lines.add("END_DATA_BLOCK", last_of(block.span))

    def _own_structure(self, struct: StructSpec) -> None:
        self.lines.level += 1
        self.typed("", struct, ";", struct.span, None)
        self.lines.level -= 1

    def _type(self, declaration: TypeDeclaration) -> None:
        self.lines.trivia((*declaration.leading, *declaration.header_comments))
        name = " ".join((*declaration.modifiers, self.name(declaration.name)))
        if declaration.extends is not None:
            name += f" EXTENDS {self.type_text(declaration.extends)}"
        initial = declaration.initial
        value = f" := {self.expression(initial)};" if initial is not None else ";"
        if isinstance(declaration.type, StructSpec) and self.dialect.has(Feature.HEADERS):
            self.lines.add(f"TYPE {name}", first_of(declaration.span))
            self.header_items(declaration.header)
            self.lines.level += 1
            self.typed("", declaration.type, value, declaration.type.span, None)
        else:
            self.lines.add("TYPE", first_of(declaration.span))
            self.lines.level += 1
            self.typed(f"{name} : ", declaration.type, value, declaration.span, None)
        self.lines.trivia(without_last_blanks(declaration.closing))
        self.lines.level -= 1
        self.lines.add("END_TYPE", last_of(declaration.span))

    # --- configurations -----------------------------------------------------------------------

    def _configuration(self, node: Configuration) -> None:
        self.lines.trivia(node.leading)
        self.lines.add(f"CONFIGURATION {node.name}", first_of(node.span))
        self.sections(node.sections)
        self.lines.level += 1
        for resource in node.resources:
            self._resource(resource)
        self.lines.trivia(without_last_blanks(node.closing))
        self.lines.level -= 1
        self.lines.add("END_CONFIGURATION", last_of(node.span))

    def _resource(self, node: Resource) -> None:
        self.lines.trivia(node.leading)
        if not node.name:
            self._tasks_and_programs(node)
            return
        self.lines.add(f"RESOURCE {node.name} ON {node.on}", first_of(node.span))
        self.sections(node.sections)
        self.lines.level += 1
        self._tasks_and_programs(node)
        self.lines.trivia(without_last_blanks(node.closing))
        self.lines.level -= 1
        self.lines.add("END_RESOURCE", last_of(node.span))

    def _tasks_and_programs(self, node: Resource) -> None:
        for task in node.tasks:
            self._task(task)
        for program in node.programs:
            self._program(program)

    def _task(self, node: Task) -> None:
        self.lines.trivia(node.leading)
        text = f"TASK {node.name}({self.arguments(node.properties)});"
        self.lines.add(text, node.span, node.trailing)

    def _program(self, node: ProgramInstance) -> None:
        self.lines.trivia(node.leading)
        task = f" WITH {node.task}" if node.task else ""
        words = " ".join(("PROGRAM", *node.qualifiers, node.name))
        connections = f"({self.arguments(node.arguments)})" if node.arguments else ""
        text = f"{words}{task} : {self.type_text(node.type)}{connections};"
        self.lines.add(text, node.span, node.trailing)

    def _globals(self, node: Globals) -> None:
        self.section(node.section)


def _first_comments_apart(
    sections: tuple[VarSection, ...],
) -> tuple[TriviaList, tuple[VarSection, ...]]:
    """The comments in front of the first section, and the sections without them."""
    first = sections[0]
    bare = VarSection(
        first.span,
        first.keyword,
        first.qualifiers,
        first.declarations,
        (),
        first.trailing,
        first.closing,
        first.opening,
    )
    comments = tuple(item for item in first.leading if item.kind is not TriviaKind.BLANK_LINE)
    return comments, (bare, *sections[1:])


_WRITERS: dict[type, Callable[[UnitPrinter, Any], None]] = {
    Block: UnitPrinter._block,
    DataBlock: UnitPrinter._data_block,
    TypeDeclaration: UnitPrinter._type,
    Configuration: UnitPrinter._configuration,
    Interface: UnitPrinter.interface,
    Namespace: UnitPrinter._namespace,
    Using: UnitPrinter.using,
    LoneMember: UnitPrinter.lone_member,
    Globals: UnitPrinter._globals,
}
