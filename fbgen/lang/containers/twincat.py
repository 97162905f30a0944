"""TwinCAT files: `.TcPOU`, `.TcDUT`, `.TcGVL`, `.TcIO` and `.TcTTO`, one object each.

A POU's declaration, its statements and each of its methods, properties and actions are elements of
their own. They are put together as one text, in the order declaration, members, statements, so that
one tree comes of it. Source: files that TwinCAT XAE writes, in published projects.
"""

from collections.abc import Sequence
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.lang.ast import Accessor, Action, Block, File, Globals, Interface, Property
from fbgen.lang.containers import code_parts
from fbgen.lang.containers.embedded import Assembly, EmbeddedSource, content
from fbgen.lang.containers.places import CodeOf, Slot
from fbgen.lang.containers.twincat_tasks import write_task
from fbgen.lang.containers.xml_tree import Element
from fbgen.lang.dialects import dialect_named
from fbgen.lang.lexer import tokenize
from fbgen.lang.other_languages import foreign_body, other_language
from fbgen.source import Source

ROOT = "TcPlcObject"
_OBJECTS = ("POU", "Itf", "DUT", "GVL", "Task")
_MEMBERS = ("Method", "Property", "Action")
_HEADS = ("FUNCTION_BLOCK", "FUNCTION", "PROGRAM", "INTERFACE")


@dataclass(slots=True)
class CodeInXml:
    """The code of an XML file as one text, the places to write to, and what could not be read."""

    source: EmbeddedSource
    slots: list[Slot]
    findings: list[Diagnostic] = field(default_factory=list)
    list_names: list[str] = field(default_factory=list)
    """The names of the lists of global variables, in their order; "" for one without."""


def read_object(root: Element, dialect: str) -> CodeInXml | None:
    """The code of a TwinCAT object; None if there is none that could be read."""
    item = next(root.named(*_OBJECTS), None)
    if item is None:
        return None
    reader = _Reader(item.source, dialect)
    if item.tag in ("POU", "Itf"):
        reader.block(item)
    elif item.tag == "Task":
        write_task(reader.assembly, item)
    else:
        reader.declarations(item)
    code = CodeInXml(reader.assembly.source(), reader.slots, reader.findings)
    if item.tag == "GVL":
        code.list_names = [item.get("Name")]
    return code


class _Reader:
    def __init__(self, source: Source, dialect: str) -> None:
        self.assembly = Assembly(source)
        self.slots: list[Slot] = []
        self.findings: list[Diagnostic] = []
        self._dialect = dialect

    def declarations(self, item: Element) -> None:
        """A type or a list of global variables."""
        self._code(
            item.child("Declaration"),
            lambda file: code_parts.units(file.units, self._dialect, file.closing),
        )

    def block(self, item: Element) -> None:
        """A POU or an interface with its members."""
        head = item.child("Declaration")
        self._code(head, lambda file: code_parts.declaration(_owner(file), self._dialect))
        self.assembly.add("\n")
        for number, member in enumerate(item.named(*_MEMBERS)):
            self._member(member, number)
        self._body(item, item.get("Name"), self._body_of)
        word = self._first_keyword(content(head) if head is not None else "")
        self.assembly.add(f"\nEND_{word}\n")

    def _first_keyword(self, text: str) -> str:
        tokens = tokenize(Source("", text), dialect_named(self._dialect))
        return next((kind for kind in tokens.kinds if kind in _HEADS), "FUNCTION_BLOCK")

    def _body_of(self, file: File) -> str:
        owner = _owner(file)
        return code_parts.body(owner, self._dialect) if isinstance(owner, Block) else ""

    def _member(self, item: Element, number: int) -> None:
        if item.tag == "Property":
            self._property(item, number)
            return
        if item.tag == "Action":
            self.assembly.add("ACTION ")
            self.assembly.add_attribute(item, "Name")
            self.assembly.add(":\n")
        else:
            self._code(item.child("Declaration"), self._declaration_of(number))
            self.assembly.add("\n")

        def text(file: File) -> str:
            member = _owner(file).members[number]
            return "" if isinstance(member, Property) else code_parts.body(member, self._dialect)

        self._body(item, item.get("Name"), text)
        self.assembly.add(f"\nEND_{item.tag.upper()}\n")

    def _declaration_of(self, number: int) -> CodeOf:
        def text(file: File) -> str:
            member = _owner(file).members[number]
            if isinstance(member, Action):
                return ""
            return code_parts.declaration(member, self._dialect)

        return text

    def _property(self, item: Element, number: int) -> None:
        self._code(item.child("Declaration"), self._declaration_of(number))
        self.assembly.add("\n")
        for position, accessor in enumerate(item.named("Get", "Set")):
            self._accessor(accessor, item.get("Name"), number, position)
        self.assembly.add("\nEND_PROPERTY\n")

    def _accessor(self, item: Element, name: str, number: int, position: int) -> None:
        word = item.tag.upper()

        def node(file: File) -> Accessor:
            member = _owner(file).members[number]
            if not isinstance(member, Property):
                raise ValueError("the tree has another member here")
            return member.accessors[position]

        self.assembly.add(f"{word}\n")
        self._code(
            item.child("Declaration"),
            lambda file: code_parts.accessor_declaration(node(file), self._dialect),
        )
        self.assembly.add("\n")

        def body(file: File) -> str:
            return code_parts.body(node(file), self._dialect)

        self._body(item, f"{name}.{item.tag}", body)
        self.assembly.add(f"\nEND_{word}\n")

    def _code(self, element: Element | None, code: CodeOf) -> None:
        if element is not None:
            self.assembly.add_content(element)
            self.slots.append(Slot(element, code))

    def _body(self, item: Element, name: str, code: CodeOf) -> None:
        implementation = item.child("Implementation")
        if implementation is None:
            return
        for language in implementation.children:
            if language.tag == "ST":
                self._code(language, code)
            else:
                self.assembly.add_at(foreign_body(language.tag), language.start)
                self.findings.append(other_language(name, language.tag, language.place))


def _owner(file: File) -> Block | Interface:
    (unit,) = file.units
    if not isinstance(unit, Block | Interface):
        raise ValueError("the tree has another unit here")
    return unit


def with_list_names(file: File, names: Sequence[str]) -> File:
    """The same tree, where lists of global variables have their names; one name is for all."""
    lists = [unit for unit in file.units if isinstance(unit, Globals)]
    if len(names) == 1:
        names = [*names] * len(lists)
    if len(names) != len(lists):
        return file  # some of them could not be read
    named = dict(zip(lists, names, strict=True))
    units = tuple(
        Globals(unit.span, unit.section, named[unit]) if isinstance(unit, Globals) else unit
        for unit in file.units
    )
    return File(file.source, file.dialect, units, file.closing)
