"""PLCopen TC6 XML, version 2.01 and older: a whole project in one file.

Types, interfaces and tasks are elements; they are said as text, and the statements stand between
them as they are. Where CODESYS adds the declaration of a block as text, that is read. Source:
PLCopen, "XML Formats for IEC 61131-3", version 2.01, and its schema; exports of CODESYS, which put
blocks, types and interfaces into the data of the application, for what they add: see
`codesys_data`.
"""

import re

from fbgen.diagnostics import Diagnostic
from fbgen.lang.ast import Accessor, Action, Block, File, Method, Property
from fbgen.lang.containers import code_parts
from fbgen.lang.containers.codesys_data import (
    added,
    attributes,
    bases,
    children,
    members_of_interface,
    modifiers,
    plain_text,
    project_parts,
    sections_of_list,
)
from fbgen.lang.containers.embedded import Assembly
from fbgen.lang.containers.places import CodeOf, Slot
from fbgen.lang.containers.plcopen_declarations import DeclarationReader
from fbgen.lang.containers.twincat import CodeInXml
from fbgen.lang.containers.xml_tree import Element
from fbgen.lang.other_languages import foreign_body, other_language

ROOT = "project"
_KINDS = {"program": "PROGRAM", "functionBlock": "FUNCTION_BLOCK", "function": "FUNCTION"}
_SECONDS = re.compile(r"PT([0-9.]+)S")


def read_project(root: Element, dialect: str) -> CodeInXml | None:
    """The code of a project; None if the file is no project of PLCopen."""
    types, instances = root.child("types"), root.child("instances")
    if types is None and instances is None and root.child("addData") is None:
        return None
    reader = _Reader(root, dialect)
    parts = project_parts(root)
    for data_type in parts.types:
        reader.data_type(data_type)
    for variables in parts.globals:
        reader.global_variables(variables)
    for interface in parts.interfaces:
        reader.interface(interface)
    for pou in parts.pous:
        reader.pou(pou)
    for configuration in parts.configurations:
        reader.configuration(configuration)
    return CodeInXml(reader.text.source(), reader.slots, reader.findings, reader.list_names)


class _Reader:
    def __init__(self, root: Element, dialect: str) -> None:
        self.text = Assembly(root.source)
        self.slots: list[Slot] = []
        self.findings: list[Diagnostic] = []
        self.list_names: list[str] = []
        self._dialect = dialect
        self._declarations = DeclarationReader(self.text)
        self._blocks = 0
        self._programs: set[str] = set()

    def data_type(self, item: Element) -> None:
        self._attributes(item)
        self.text.add("TYPE\n")
        self._declarations.documentation(item)
        self.text.add_attribute(item, "name")
        self._bases(item)
        self.text.add(" : ")
        self._declarations.type_of(item.child("baseType"), item)
        self._declarations.initial(item)
        self.text.add(";\nEND_TYPE\n")

    def global_variables(self, item: Element) -> None:
        for section in sections_of_list(item):
            self.list_names.append(item.get("name"))
            self._attributes(item)
            self._declarations.section("VAR_GLOBAL", section)

    def interface(self, item: Element) -> None:
        if (plain := plain_text(item)) is not None:
            self.text.add_content(plain)
            self.text.add("\n")
        else:
            self._declarations.documentation(item)
            self.text.add("INTERFACE ")
            self.text.add_attribute(item, "name")
            self._bases(item)
            self.text.add("\n")
        for member in members_of_interface(item):
            word = member.tag.upper()
            self._head(member, word)
            if member.tag == "Property":
                for accessor in member.named("GetAccessor", "SetAccessor"):
                    self.text.add(f"{accessor.tag.removesuffix('Accessor').upper()}\n")
                    self.text.add(f"END_{accessor.tag.removesuffix('Accessor').upper()}\n")
            self.text.add(f"END_{word}\n")
        self.text.add("END_INTERFACE\n")

    # --- blocks -------------------------------------------------------------------------------

    def pou(self, item: Element) -> None:
        number = self._blocks
        self._blocks += 1
        word = _KINDS.get(item.get("pouType"), "FUNCTION_BLOCK")
        self._programs.add(item.get("name").casefold())
        self._declarations.documentation(item)
        self._head(item, word)
        position = 0
        for action in children(item, "actions", "action"):
            self._action(action, number, position)
            position += 1
        for member in added(item, "Method", "Property"):
            self._member(member, number, position)
            position += 1
        self._bodies(item, item.get("name"), lambda file: self._text(_block(file, number)))
        self.text.add(f"\nEND_{word}\n")

    def _head(self, item: Element, word: str) -> None:
        interface = item.child("interface")
        if (plain := plain_text(item)) is not None:
            self.text.add_content(plain)
            self.text.add("\n")
            return
        self._attributes(item)
        self.text.add(" ".join((word, *modifiers(item), "")))
        self.text.add_attribute(item, "name")
        self._bases(item)
        result = interface.child("returnType") if interface is not None else None
        if result is not None:
            self.text.add(" : ")
            self._declarations.type_of(result, item)
        self.text.add("\n")
        if interface is not None:
            self._declarations.sections(interface)

    def _attributes(self, item: Element) -> None:
        for attribute in attributes(item):
            self.text.add(f"{attribute}\n")

    def _bases(self, item: Element) -> None:
        for word, names in bases(item).items():
            self.text.add(f" {word} {', '.join(names)}")

    def _action(self, item: Element, number: int, position: int) -> None:
        self.text.add("ACTION ")
        self.text.add_attribute(item, "name")
        self.text.add(":\n")
        self._bodies(item, item.get("name"), self._member_text(number, position))
        self.text.add("\nEND_ACTION\n")

    def _member(self, item: Element, number: int, position: int) -> None:
        word = item.tag.upper()
        self._head(item, word)
        if item.tag == "Method":
            self._bodies(item, item.get("name"), self._member_text(number, position))
        else:
            for count, accessor in enumerate(item.named("GetAccessor", "SetAccessor")):
                self._accessor(accessor, item.get("name"), number, position, count)
        self.text.add(f"\nEND_{word}\n")

    def _accessor(self, item: Element, name: str, number: int, position: int, count: int) -> None:
        word = item.tag.removesuffix("Accessor").upper()
        self.text.add(f"{word}\n")
        interface = item.child("interface")
        if (plain := plain_text(item)) is not None:
            self.text.add_content(plain)
            self.text.add("\n")
        elif interface is not None:
            self._declarations.sections(interface)

        def code(file: File) -> str:
            member = _block(file, number).members[position]
            return self._text(member.accessors[count]) if isinstance(member, Property) else ""

        self._bodies(item, f"{name}.{word}", code)
        self.text.add(f"\nEND_{word}\n")

    def _member_text(self, number: int, position: int) -> CodeOf:
        def code(file: File) -> str:
            member = _block(file, number).members[position]
            return "" if isinstance(member, Property) else self._text(member)

        return code

    def _text(self, node: Block | Method | Action | Accessor) -> str:
        return code_parts.body(node, self._dialect)

    def _bodies(self, item: Element, name: str, code: CodeOf) -> None:
        for body in item.named("body"):
            for language in body.children:
                if language.tag == "ST":
                    inner = next(iter(language.children), language)
                    self.text.add_content(inner)
                    self.slots.append(Slot(inner, code))
                elif language.tag not in ("addData", "documentation"):
                    self.text.add_at(foreign_body(language.tag), language.start)
                    self.findings.append(other_language(name, language.tag, language.place))

    # --- configurations -----------------------------------------------------------------------

    def configuration(self, item: Element) -> None:
        is_codesys = self._dialect == "twincat"
        self.text.add("CONFIGURATION ")
        self._name(item)
        self.text.add("\n")
        if not is_codesys:
            self._declarations.sections(item)
        for resource in item.named("resource"):
            self.text.add("RESOURCE ")
            self._name(resource)
            self.text.add(" ON PLC\n")
            if not is_codesys:
                self._declarations.sections(resource)
            for task in resource.named("task"):
                self._task(task)
            for task in resource.named("task"):
                for instance in task.named("pouInstance"):
                    self._instance(instance, task)
            for instance in resource.named("pouInstance"):
                self._instance(instance, None)
            self.text.add("END_RESOURCE\n")
        self.text.add("END_CONFIGURATION\n")

    def _name(self, item: Element) -> None:
        """A name of CODESYS may have blanks and signs."""
        name = item.get("name")
        if name.isidentifier():
            self.text.add_attribute(item, "name")
        else:
            self.text.add(re.sub(r"\W", "_", f"_{name}" if name[:1].isdigit() else name) or "PLC")

    def _task(self, item: Element) -> None:
        self.text.add("TASK ")
        self._name(item)
        self.text.add("(")
        for attribute, word in (("single", "SINGLE"), ("interval", "INTERVAL")):
            if item.get(attribute):
                self.text.add(f"{word} := ")
                if seconds := _SECONDS.fullmatch(item.get(attribute)):
                    self.text.add(f"T#{seconds[1]}s")
                else:
                    self.text.add_attribute(item, attribute)
                self.text.add(", ")
        self.text.add(f"PRIORITY := {item.get('priority') or 0});\n")

    def _instance(self, item: Element, task: Element | None) -> None:
        """A program; CODESYS gives its name only, and has programs of libraries among them."""
        kind = "typeName" if item.get("typeName") else "name"
        if self._dialect == "twincat" and item.get(kind).casefold() not in self._programs:
            return
        self.text.add("PROGRAM ")
        self._name(item)
        if task is not None:
            self.text.add(" WITH ")
            self._name(task)
        self.text.add(" : ")
        self.text.add_attribute(item, kind)
        self.text.add(";\n")


def _block(file: File, number: int) -> Block:
    blocks = [unit for unit in file.units if isinstance(unit, Block)]
    return blocks[number]
