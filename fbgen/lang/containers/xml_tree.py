"""XML as a tree in which everything knows its place in the text.

The parser is expat, behind defusedxml: no document type, so no entities of one's own and nothing
fetched from outside. lxml and ElementTree know lines at best; expat tells the byte of each event,
which gives findings their column and lets a file be written again with only its code changed.
"""

from collections.abc import Iterator
from dataclasses import field
from xml.etree.ElementTree import ParseError
from xml.parsers.expat import XMLParserType

from defusedxml.common import DefusedXmlException
from defusedxml.ElementTree import DefusedXMLParser

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.source import Source, Span

DEEPEST_ELEMENTS = 200
"""Elements inside elements that a file may have."""


@dataclass(slots=True, eq=False)
class Element:
    """One element: its name without prefix, and its places as offsets in the source.

    `start` and `end` are those of the whole element, `inner_start` and `inner_end` of what stands
    between its tags, equal for `<tag/>`.
    """

    source: Source
    tag: str
    attributes: dict[str, str]
    start: int
    inner_start: int = 0
    inner_end: int = 0
    end: int = 0
    children: list["Element"] = field(default_factory=list)

    def child(self, tag: str) -> "Element | None":
        """The first child with this name."""
        return next((one for one in self.children if one.tag == tag), None)

    def named(self, *tags: str) -> Iterator["Element"]:
        """All children with one of these names, in their order."""
        return (one for one in self.children if one.tag in tags)

    def get(self, name: str) -> str:
        """The value of an attribute, "" if it has none."""
        return self.attributes.get(name, "")

    @property
    def place(self) -> Span:
        """The start tag."""
        return Span(self.source, self.start, self.inner_start)

    @property
    def raw(self) -> str:
        """What stands between its tags, as it stands in the file."""
        return self.source.text[self.inner_start : self.inner_end]


def read_xml(source: Source) -> Element:
    """The root of an XML text. Raises `DiagnosticError` (FB3016) if it is broken or not allowed."""
    builder = _Builder(source)
    parser = DefusedXMLParser(target=builder, forbid_dtd=True)
    builder.expat = parser.parser
    parser.parser.buffer_text = False
    try:
        parser.feed(source.text)
        parser.close()
    except ParseError as problem:
        line, column = problem.position
        place = _place_of(source, line, column)
        raise error(
            "FB3016",
            f"this is no XML: {str(problem).partition(':')[0]}",
            place,
            "export or save the file again",
        ) from None
    except DefusedXmlException:
        at = source.text.find("<!DOCTYPE")
        place = Span(source, max(at, 0), max(at, 0) + (9 if at >= 0 else 0))
        raise error(
            "FB3016",
            "the file has a document type",
            place,
            "remove <!DOCTYPE ...>: project files have none, and entities are not read",
        ) from None
    except UnicodeEncodeError as problem:
        raise error(
            "FB3016",
            "the file has a character that XML cannot have",
            Span(source, problem.start, problem.start + 1),
            "export or save the file again",
        ) from None
    return builder.root


class _Builder:
    """Makes the tree from the events of expat."""

    expat: XMLParserType

    def __init__(self, source: Source) -> None:
        self.root = Element(source, "", {}, 0)
        self._source = source
        self._open = [self.root]
        self._encoded = b"" if source.text.isascii() else source.text.encode("utf-8", "replace")
        self._bytes = self._characters = 0

    def _offset(self) -> int:
        """Where the event begins, in characters. Events come in their order."""
        at = self.expat.CurrentByteIndex
        if not self._encoded:
            return at
        self._characters += len(self._encoded[self._bytes : at].decode("utf-8", "replace"))
        self._bytes = at
        return self._characters

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """A start tag."""
        start = self._offset()
        if len(self._open) > DEEPEST_ELEMENTS:
            raise error(
                "FB3016",
                f"elements are nested deeper than {DEEPEST_ELEMENTS} levels",
                Span(self._source, start, start + 1),
                "no project file is nested like that; export or save it again",
            )
        bare = {_local(name): value for name, value in attributes.items()}
        inner = _end_of_tag(self._source.text, start)
        element = Element(self._source, _local(tag), bare, start, inner, inner, inner)
        self._open[-1].children.append(element)
        if len(self._open) == 1:
            self.root = element
        self._open.append(element)

    def end(self, tag: str) -> None:
        """An end tag, or the end of `<tag/>`."""
        element = self._open.pop()
        at = self._offset()
        if at > element.start:
            element.inner_end = at
            element.end = self._source.text.find(">", at) + 1

    def close(self) -> None:
        """The end of the text."""


def _local(name: str) -> str:
    return name.rpartition("}")[2]


def _end_of_tag(text: str, start: int) -> int:
    """The offset behind the '>' of a start tag; a quoted value may have one, too."""
    at, quote = start, ""
    while at < len(text):
        character = text[at]
        if quote:
            quote = "" if character == quote else quote
        elif character in "\"'":
            quote = character
        elif character == ">":
            return at + 1
        at += 1
    return at


def _place_of(source: Source, line: int, column: int) -> Span:
    start = 0
    for _ in range(line - 1):
        start = source.text.find("\n", start) + 1
    at = min(start + column, len(source.text))
    return Span(source, at, min(at + 1, len(source.text)))
