"""PLCopen TC6 XML 2.01 from trees: one project with types, blocks and configurations.

Interfaces become elements, statements stay text. Methods, properties, bases and interfaces stand in
the additions of CODESYS; what has no place there either is refused by name. Comments at variables
and blocks become their documentation. Source: PLCopen, "XML Formats for
IEC 61131-3", version 2.01, and its schema.
"""

from collections.abc import Sequence

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.ast import (
    Action,
    Argument,
    Block,
    BlockKind,
    Configuration,
    File,
    Globals,
    Interface,
    ProgramInstance,
    Resource,
    Task,
    TriviaList,
    TypeDeclaration,
)
from fbgen.lang.containers import code_parts
from fbgen.lang.containers.codesys_objects import ObjectWriter, added
from fbgen.lang.containers.places import escape
from fbgen.lang.containers.plcopen_variables import VariableWriter, documentation, quoted
from fbgen.lang.containers.twincat_writing import no_place
from fbgen.lang.depth import room_for_depth

_KINDS = {
    BlockKind.PROGRAM: "program",
    BlockKind.FUNCTION_BLOCK: "functionBlock",
    BlockKind.FUNCTION: "function",
}
_NAMESPACES = (
    'xmlns="http://www.plcopen.org/xml/tc6_0201" xmlns:xhtml="http://www.w3.org/1999/xhtml"'
)
_GLOBALS = "http://www.3s-software.com/plcopenxml/globalvars"
_ANY_TIME = "2000-01-01T00:00:00"
"""When a project was made is not said, so that the same trees give the same file."""


def project(files: Sequence[File], name: str) -> str:
    """The text of the project. Raises `DiagnosticError` (FB3019) with all that has no place."""
    writer = _Writer(files[0].dialect if files else "iec")
    with room_for_depth():
        for file in files:
            writer.units(file)
    if writer.refused:
        raise DiagnosticError(writer.refused)
    return writer.project(name)


class _Writer:
    def __init__(self, dialect: str) -> None:
        self.refused: list[Diagnostic] = []
        self._dialect = dialect
        self._variables = VariableWriter(dialect, self.refused)
        self._objects = ObjectWriter(dialect)
        self._types: list[str] = []
        self._blocks: list[str] = []
        self._configurations: list[str] = []
        self._globals: list[str] = []

    def units(self, file: File) -> None:
        """All units of one file."""
        for unit in file.units:
            if isinstance(unit, TypeDeclaration) and not unit.modifiers:
                self._types.append(self._type(unit))
            elif isinstance(unit, Globals):
                section = self._variables.section(unit.section, f' name="{quoted(unit.name)}"')
                self._globals.append(
                    f'<data name="{_GLOBALS}" handleUnknown="implementation">\n{section}</data>\n'
                )
            elif isinstance(unit, Interface):
                self._globals.append(self._objects.interface(unit))
            elif isinstance(unit, Block) and unit.kind in _KINDS and not unit.usings:
                self._blocks.append(self._block(unit))
            elif isinstance(unit, Configuration):
                self._configurations.append(self._configuration(unit))
            else:
                self.refused.append(no_place("PLCopen XML", unit.span))

    def _is_object(self, block: Block) -> bool:
        """True for a block that the standard's elements cannot describe."""
        without: list[Diagnostic] = []
        variables = VariableWriter(self._dialect, without)
        for section in block.sections:
            variables.section(section)
        return bool(
            without
            or block.extends is not None
            or block.implements
            or block.modifiers
            or any(not isinstance(member, Action) for member in block.members)
        )

    def project(self, name: str) -> str:
        """The whole file."""
        scaling = '<scaling x="1" y="1"/>'
        added = f"<addData>\n{''.join(self._globals)}</addData>\n" if self._globals else ""
        return (
            '<?xml version="1.0" encoding="utf-8"?>\n'
            f"<project {_NAMESPACES}>\n"
            '<fileHeader companyName="" productName="fbgen" productVersion="1" '
            f'creationDateTime="{_ANY_TIME}"/>\n'
            f'<contentHeader name="{quoted(name)}" modificationDateTime="{_ANY_TIME}">\n'
            f"<coordinateInfo><fbd>{scaling}</fbd><ld>{scaling}</ld><sfc>{scaling}</sfc>"
            "</coordinateInfo>\n</contentHeader>\n"
            f"<types>\n<dataTypes>\n{''.join(self._types)}</dataTypes>\n"
            f"<pous>\n{''.join(self._blocks)}</pous>\n</types>\n"
            "<instances>\n<configurations>\n"
            f"{''.join(self._configurations)}</configurations>\n</instances>\n"
            f"{added}</project>\n"
        )

    def _type(self, node: TypeDeclaration) -> str:
        return (
            f'<dataType name="{quoted(node.name.name)}">\n'
            f"<baseType>{self._variables.type(node.type)}</baseType>\n"
            + self._variables.initial(node.initial)
            + self._objects.base_of_type(node)
            + documentation((*node.leading, *node.header_comments))
            + "</dataType>\n"
        )

    # --- blocks -------------------------------------------------------------------------------

    def _block(self, block: Block) -> str:
        is_object = self._is_object(block)
        result = sections = ""
        if block.return_type is not None and not is_object:
            result = f"<returnType>{self._variables.type(block.return_type)}</returnType>\n"
        if not is_object:
            sections = "".join(self._variables.section(section) for section in block.sections)
        head = f"<interface>\n{result}{sections}</interface>\n"
        if is_object:
            head = self._objects.head(block)
        actions = "".join(
            f'<action name="{quoted(member.name.name)}">\n{self._body(member)}'
            f"{documentation(member.leading)}</action>\n"
            for member in block.members
            if isinstance(member, Action)
        )
        return (
            f'<pou name="{quoted(block.name.name)}" pouType="{_KINDS[block.kind]}">\n'
            f"{head}"
            + (f"<actions>\n{actions}</actions>\n" if actions else "")
            + self._body(block)
            + added(self._objects.members(block) if is_object else [])
            + documentation(() if is_object else _about(block))
            + "</pou>\n"
        )

    def _body(self, node: Block | Action) -> str:
        text = escape(code_parts.body(node, self._dialect))
        return f"<body>\n<ST><xhtml:p>{text}</xhtml:p></ST>\n</body>\n"

    # --- configurations -----------------------------------------------------------------------

    def _configuration(self, node: Configuration) -> str:
        resources = "".join(self._resource(resource) for resource in node.resources)
        sections = "".join(self._variables.section(section) for section in node.sections)
        return (
            f'<configuration name="{quoted(node.name)}">\n{resources}{sections}'
            f"{documentation(node.leading)}</configuration>\n"
        )

    def _resource(self, node: Resource) -> str:
        tasks = "".join(self._task(task, node) for task in node.tasks)
        sections = "".join(self._variables.section(section) for section in node.sections)
        known = {task.name.casefold() for task in node.tasks}
        loose = "".join(
            self._instance(one) for one in node.programs if one.task.casefold() not in known
        )
        if not node.name:
            self.refused.append(no_place("PLCopen XML", node.span))
        return (
            f'<resource name="{quoted(node.name)}">\n{tasks}{sections}{loose}'
            f"{documentation(node.leading)}</resource>\n"
        )

    def _task(self, node: Task, resource: Resource) -> str:
        values = {one.name.upper(): self._variables.argument(one) for one in node.properties}
        attributes = "".join(
            f' {name}="{values[name.upper()]}"'
            for name in ("single", "interval")
            if name.upper() in values
        )
        priority = values.get("PRIORITY", "0")
        programs = "".join(
            self._instance(one)
            for one in resource.programs
            if one.task.casefold() == node.name.casefold()
        )
        return (
            f'<task name="{quoted(node.name)}"{attributes} priority="{priority}">\n'
            f"{programs}{documentation(node.leading)}</task>\n"
        )

    def _instance(self, node: ProgramInstance) -> str:
        refused: tuple[Argument, ...] = node.arguments
        if refused or node.qualifiers:
            self.refused.append(no_place("PLCopen XML", node.span))
        return (
            f'<pouInstance name="{quoted(node.name)}" typeName="{quoted(node.type.name)}">'
            f"{documentation(node.leading)}</pouInstance>\n"
        )


def _about(block: Block) -> TriviaList:
    return (*block.leading, *block.header_comments)
