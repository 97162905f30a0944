"""Variables, types and values as elements of PLCopen TC6 XML.

Source: PLCopen, schema of TC6 XML 2.01: varList, dataType, value, formattedText.
"""

from fbgen.diagnostics import Diagnostic
from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    ArrayLiteral,
    ArraySpec,
    Declaration,
    DirectAddress,
    EnumSpec,
    Expression,
    NamedType,
    ReferenceSpec,
    Repeated,
    StringSpec,
    StructLiteral,
    StructSpec,
    SubrangeSpec,
    TriviaList,
    TypeSpec,
    VarSection,
)
from fbgen.lang.containers.places import escape
from fbgen.lang.containers.plcopen_declarations import QUALIFIERS, SECTIONS
from fbgen.lang.containers.twincat_writing import no_place
from fbgen.lang.dialects import dialect_named
from fbgen.lang.dialects.words import ELEMENTARY_TYPES
from fbgen.lang.printer.expressions import ExpressionPrinter
from fbgen.source import Span

_TAGS = {keyword: tag for tag, keyword in SECTIONS.items()}
_ATTRIBUTES = {word: name for name, word in QUALIFIERS.items()}
_SHORT = {"TIME_OF_DAY": "TOD", "DATE_AND_TIME": "DT"}
_ANY = "ANY"


class VariableWriter:
    """Writes what is declared; `refused` collects what has no element."""

    def __init__(self, dialect: str, refused: list[Diagnostic]) -> None:
        self._refused = refused
        self._printer = ExpressionPrinter(dialect_named(dialect))

    def section(self, section: VarSection, more: str = "") -> str:
        """One VAR section; `more` are further attributes."""
        tag = _TAGS.get(section.keyword)
        if tag is None or not set(section.qualifiers) <= _ATTRIBUTES.keys():
            self._refuse(section.span)
            return ""
        flags = "".join(f' {_ATTRIBUTES[word]}="true"' for word in section.qualifiers)
        variables = "".join(self._variables(one) for one in section.declarations)
        return f"<{tag}{more}{flags}>\n{variables}{documentation(section.leading)}</{tag}>\n"

    def _variables(self, node: Declaration) -> str:
        if node.arguments or node.edge or node.operator != ":=":
            self._refuse(node.span)
        address = ""
        if isinstance(node.at, DirectAddress):
            address = f' address="{quoted(self._printer.expression(node.at))}"'
        elif node.at is not None:
            self._refuse(node.at.span)
        comments = (*node.leading, *((node.trailing,) if node.trailing else ()))
        inside = (
            f"<type>{self.type(node.type)}</type>{self.initial(node.initial)}"
            f"{documentation(comments)}"
        )
        return "".join(
            f'<variable name="{quoted(name.name)}"{address}>{inside}</variable>\n'
            for name in node.names
        )

    # --- types --------------------------------------------------------------------------------

    def type(self, spec: TypeSpec) -> str:
        """A type; "" if there is no element for it."""
        if isinstance(spec, NamedType):
            word = spec.name.upper()
            if word in ELEMENTARY_TYPES or word.startswith(_ANY):
                return f"<{_SHORT.get(word, word)}/>"
            return f'<derived name="{quoted(spec.name)}"/>'
        if isinstance(spec, StringSpec):
            tag = "wstring" if spec.wide else "string"
            length = "" if spec.length is None else f' length="{self._text(spec.length)}"'
            return f"<{tag}{length}/>"
        if isinstance(spec, ArraySpec):
            return self._array(spec)
        if isinstance(spec, StructSpec):
            return f"<struct>\n{''.join(map(self._variables, spec.fields))}</struct>"
        if isinstance(spec, EnumSpec):
            return self._enumeration(spec)
        if isinstance(spec, SubrangeSpec):
            tag = "subrangeUnsigned" if spec.base.name.upper()[:1] == "U" else "subrangeSigned"
            ends = f'lower="{self._text(spec.first)}" upper="{self._text(spec.last)}"'
            base = self.type(spec.base)
            return f"<{tag}><range {ends}/><baseType>{base}</baseType></{tag}>"
        if isinstance(spec, ReferenceSpec) and spec.keyword == "POINTER TO":
            return f"<pointer><baseType>{self.type(spec.target)}</baseType></pointer>"
        self._refuse(spec.span)
        return ""

    def _array(self, spec: ArraySpec) -> str:
        ends = ""
        for bounds in spec.bounds:
            if bounds.first is None or bounds.last is None:
                self._refuse(spec.span)
            else:
                first, last = self._text(bounds.first), self._text(bounds.last)
                ends += f'<dimension lower="{first}" upper="{last}"/>'
        return f"<array>{ends}<baseType>{self.type(spec.element)}</baseType></array>"

    def _enumeration(self, spec: EnumSpec) -> str:
        values = ""
        for one in spec.enumerators:
            value = "" if one.value is None else f' value="{self._text(one.value)}"'
            values += f'<value name="{quoted(one.name)}"{value}/>'
        base = f"<baseType>{self.type(spec.base)}</baseType>" if spec.base else ""
        return f"<enum><values>{values}</values>{base}</enum>"

    # --- values -------------------------------------------------------------------------------

    def initial(self, value: Expression | None) -> str:
        """The initialValue element, or nothing."""
        return "" if value is None else f"<initialValue>{self._value(value)}</initialValue>"

    def argument(self, argument: Argument) -> str:
        """The value of an argument, as an attribute."""
        return "" if argument.value is None else self._text(argument.value)

    def _value(self, value: Expression) -> str:
        if isinstance(value, ArrayLiteral):
            return f"<arrayValue>{''.join(map(self._item, value.items))}</arrayValue>"
        if isinstance(value, StructLiteral):
            fields = ""
            for one in value.fields:
                if one.kind is not ArgumentKind.INPUT or one.value is None:
                    self._refuse(value.span)
                else:
                    fields += f'<value member="{quoted(one.name)}">{self._value(one.value)}</value>'
            return f"<structValue>{fields}</structValue>"
        return f'<simpleValue value="{self._text(value)}"/>'

    def _item(self, item: Expression) -> str:
        if not isinstance(item, Repeated):
            return f"<value>{self._value(item)}</value>"
        if item.value is None:
            self._refuse(item.span)
            return ""
        count = self._text(item.count)
        return f'<value repetitionValue="{count}">{self._value(item.value)}</value>'

    def _text(self, expression: Expression) -> str:
        return quoted(self._printer.expression(expression))

    def _refuse(self, span: Span) -> None:
        self._refused.append(no_place("PLCopen XML", span))


def documentation(trivia: TriviaList) -> str:
    """Comments as the documentation of what they stand at."""
    words = [_words(item.text) for item in trivia if item.text]
    if not words:
        return ""
    text = escape("\n".join(words))
    return f"<documentation><xhtml:p>{text}</xhtml:p></documentation>\n"


def quoted(text: str) -> str:
    """A text as it stands in an attribute."""
    return escape(text).replace('"', "&quot;").replace("\n", "&#10;")


def _words(comment: str) -> str:
    if comment.startswith("//"):
        return comment[2:].strip()
    if comment.startswith(("(*", "/*")):
        return comment[2:-2].strip()
    return comment
