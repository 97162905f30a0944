"""What PLCopen XML has no element for and CODESYS adds: members, bases, access words, interfaces.

The declaration stands there as text, too, as CODESYS exports it on demand, so nothing of it is
lost: on reading, that text counts. Source: see `codesys_data`.
"""

from collections.abc import Sequence

from fbgen.lang.ast import (
    Accessor,
    Block,
    Interface,
    Method,
    NamedType,
    Property,
    TypeDeclaration,
    VarSection,
)
from fbgen.lang.containers import code_parts
from fbgen.lang.containers.places import escape
from fbgen.lang.containers.plcopen_variables import VariableWriter, documentation, quoted

_DATA = "http://www.3s-software.com/plcopenxml/"


def data(name: str, inside: str) -> str:
    """One addition of CODESYS."""
    return f'<data name="{_DATA}{name}" handleUnknown="implementation">\n{inside}</data>\n'


def added(pieces: Sequence[str]) -> str:
    """All additions to an element; nothing without any."""
    return f"<addData>\n{''.join(pieces)}</addData>\n" if pieces else ""


def body_of(node: Block | Method | Accessor, dialect: str) -> str:
    """The statements."""
    text = escape(code_parts.body(node, dialect))
    return f"<body>\n<ST><xhtml:p>{text}</xhtml:p></ST>\n</body>\n"


class ObjectWriter:
    """Writes the objects of one program."""

    def __init__(self, dialect: str) -> None:
        self._dialect = dialect
        # What has no element stands in the declaration as text.
        self._variables = VariableWriter(dialect, [])

    def head(self, block: Block) -> str:
        """The interface element of a block with all that it has."""
        return self._interface(
            self._result(block) + self._sections(block.sections),
            code_parts.declaration(block, self._dialect),
            [
                *_inheritance((block.extends,) if block.extends else (), block.implements),
                *_modifiers(block.modifiers),
            ],
        )

    def members(self, block: Block) -> list[str]:
        """Methods and properties, as additions to their block."""
        return [
            self._method(member) if isinstance(member, Method) else self._property(member)
            for member in block.members
            if isinstance(member, Method | Property)
        ]

    def interface(self, node: Interface) -> str:
        """An INTERFACE, as an addition to the project."""
        methods = "".join(
            self._promise(member, "Method") for member in node.members if isinstance(member, Method)
        )
        properties = "".join(
            self._promise(member, "Property")
            for member in node.members
            if isinstance(member, Property)
        )
        inside = (
            f'<Interface name="{quoted(node.name.name)}">\n'
            + (f"<Methods>\n{methods}</Methods>\n" if methods else "")
            + (f"<Properties>\n{properties}</Properties>\n" if properties else "")
            + added(
                [
                    *_inheritance(node.extends, ()),
                    self._text(code_parts.declaration(node, self._dialect)),
                ]
            )
            + "</Interface>\n"
        )
        return data("interface", inside)

    def base_of_type(self, node: TypeDeclaration) -> str:
        """What a structure extends."""
        if node.extends is None:
            return ""
        inside = f"<Inheritance><Extends>{escape(node.extends.name)}</Extends></Inheritance>\n"
        return added([data("datatypeinheritance", inside)])

    # --- members ------------------------------------------------------------------------------

    def _method(self, node: Method) -> str:
        return data(
            "method",
            f'<Method name="{quoted(node.name.name)}">\n{self._head(node)}'
            f"{body_of(node, self._dialect)}{documentation(node.leading)}</Method>\n",
        )

    def _property(self, node: Property) -> str:
        accessors = "".join(self._accessor(one) for one in node.accessors)
        return data(
            "property",
            f'<Property name="{quoted(node.name.name)}">\n{self._head(node)}{accessors}'
            f"{documentation(node.leading)}</Property>\n",
        )

    def _accessor(self, node: Accessor) -> str:
        tag = f"{node.keyword.capitalize()}Accessor"
        declaration = code_parts.accessor_declaration(node, self._dialect)
        head = self._interface(self._sections(node.sections), declaration, [])
        return f"<{tag}>\n{head}{body_of(node, self._dialect)}</{tag}>\n"

    def _promise(self, node: Method | Property, tag: str) -> str:
        accessors = ""
        if isinstance(node, Property):
            tags = [f"{one.keyword.capitalize()}Accessor" for one in node.accessors]
            accessors = "".join(f"<{one}>\n<interface/>\n</{one}>\n" for one in tags)
        return f'<{tag} name="{quoted(node.name.name)}">\n{self._head(node)}{accessors}</{tag}>\n'

    def _head(self, node: Method | Property) -> str:
        sections = node.sections if isinstance(node, Method) else ()
        return self._interface(
            self._result(node) + self._sections(sections),
            code_parts.declaration(node, self._dialect),
            _modifiers(node.modifiers),
        )

    def _interface(self, inside: str, declaration: str, more: Sequence[str]) -> str:
        additions = added([*more, self._text(declaration)])
        return f"<interface>\n{inside}{additions}</interface>\n"

    def _text(self, declaration: str) -> str:
        inside = f"<xhtml:p>{escape(declaration)}</xhtml:p>"
        return data(
            "interfaceasplaintext", f"<InterfaceAsPlainText>\n{inside}\n</InterfaceAsPlainText>\n"
        )

    def _result(self, node: Block | Method | Property) -> str:
        kind = node.type if isinstance(node, Property) else node.return_type
        return f"<returnType>{self._variables.type(kind)}</returnType>\n" if kind else ""

    def _sections(self, sections: Sequence[VarSection]) -> str:
        return "".join(self._variables.section(section) for section in sections)


def _inheritance(extends: Sequence[NamedType], implements: Sequence[NamedType]) -> list[str]:
    lines = [f"<Extends>{escape(one.name)}</Extends>\n" for one in extends]
    lines += [f"<Implements>{escape(one.name)}</Implements>\n" for one in implements]
    if not lines:
        return []
    return [data("pouinheritance", f"<Inheritance>\n{''.join(lines)}</Inheritance>\n")]


def _modifiers(words: Sequence[str]) -> list[str]:
    if not words:
        return []
    flags = "".join(f' {word.capitalize()}="true"' for word in words)
    return [data("accessmodifiers", f"<AccessModifiers{flags}/>\n")]
