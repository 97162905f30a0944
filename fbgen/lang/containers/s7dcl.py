"""`.s7dcl`, the text documents of blocks that TIA Portal exports and imports from V20 on.

A document holds one block, type or data block in SCL's spelling, with these differences from an
external source: attributes stand in front of what they are for, with their values in double quotes;
the body is a row of networks, each with its language; `_.name` is a type or block of the outermost
namespace; a data block has no BEGIN, and a colon in front of its type. Titles and comments in
several languages are in a `.s7res` beside it, which is not read.

Here it becomes the text of an external source, which knows its places in the document. Networks in
ladder or as a function block diagram are known to be there, and no more.
Sources: Siemens, "SIMATIC SD" in github.com/siemens/tia-portal-ai-extensions; published documents.
"""

import re
from collections.abc import Iterator, Mapping

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.lang.containers.embedded import Assembly, EmbeddedSource
from fbgen.lang.other_languages import foreign_body, other_language
from fbgen.source import Source, Span

SUFFIX = ".s7dcl"

_PARTS = re.compile(
    r"""(?P<comment>//[^\n]*|\(\*.*?\*\)|/\*.*?\*/)
    |(?P<text>'(?:[^'$\n]|\$.)*'|"[^"\n]*")
    |(?P<attributes>\{[^}]*\})
    |(?P<region>^[ \t]*(?:END_)?REGION\b[^\n]*)
    |(?P<network>^[ \t]*NETWORK(?=[ \t]*(?://[^\n]*)?\r?$))
    |(?P<end>^[ \t]*END_NETWORK\b)
    |(?P<root>(?<![\w."\#])_\.(?=["\w]))
    |(?P<block>^[ \t]*(?:FUNCTION_BLOCK|FUNCTION|ORGANIZATION_BLOCK|DATA_BLOCK|TYPE)\b
       [ \t]*(?P<name>"[^"\n]*"|\w+)?)
    |(?P<section>^[ \t]*VAR(?:_\w+)?\b)
    |(?P<section_end>\bEND_VAR\b)
    |(?P<rung>^[ \t]*RUNG\b)""",
    re.DOTALL | re.MULTILINE | re.VERBOSE | re.IGNORECASE,
)
_ATTRIBUTE = re.compile(r'(\w+)\s*:=\s*"([^"]*)"')
_TYPE_OF_DATA = re.compile(r'\s*:\s*(?:_\.)?("[^"\n]*"|\w+)')
_RESULT = re.compile(r'\s*:\s*(?:_\.)?("[^"\n]*"|\w+)')


@dataclass(frozen=True, slots=True)
class Declared:
    """The text of a document as an external source, and the networks that nobody reads."""

    source: EmbeddedSource
    findings: tuple[Diagnostic, ...]


def read_declared(document: Source) -> Declared:
    """The block, type or data block of a document."""
    return _Reader(document).read()


class _Reader:
    """Goes through a document once."""

    def __init__(self, document: Source) -> None:
        self._document = document
        self._text = Assembly(document)
        self._done = 0
        self._findings: list[Diagnostic] = []
        self._attributes: Mapping[str, str] = {}
        self._name = ""
        self._is_data = False
        self._has_begun = False

    def read(self) -> Declared:
        parts = _PARTS.finditer(self._document.text)
        for part in parts:
            kind = part.lastgroup if part.lastgroup != "name" else "block"
            if kind == "attributes":
                self._attributes = dict(_ATTRIBUTE.findall(part[0]))
                self._leave_out(part)
            elif kind in ("root", "end"):
                self._leave_out(part)
            elif kind == "network":
                self._network(part, parts)
            elif kind == "block":
                self._block(part)
            elif kind == "section_end" and self._is_data:
                self._copy_to(part.end())
                self._begin_data()
        self._copy_to(len(self._document.text))
        return Declared(self._text.source(), tuple(self._findings))

    # --- what is copied -------------------------------------------------------------------------

    def _copy_to(self, end: int) -> None:
        if end > self._done:
            self._text.add(self._document.text[self._done : end], self._done)
        self._done = end

    def _leave_out(self, part: re.Match[str]) -> None:
        """Leave a part out, but for its ends of lines."""
        if part.start() < self._done:
            return
        self._copy_to(part.start())
        self._text.add_at("\n" * part[0].count("\n"), part.start())
        self._done = part.end()

    # --- blocks ---------------------------------------------------------------------------------

    def _block(self, part: re.Match[str]) -> None:
        """The line of a block, with its attributes as header lines behind it."""
        keyword = part[0].split()[0].upper()
        self._name = part["name"] or ""
        self._copy_to(part.end())
        attributes, self._attributes = self._attributes, {}
        if keyword == "TYPE":
            return
        self._is_data = keyword == "DATA_BLOCK"
        text = self._document.text
        header = "\n".join(_header(attributes))
        if keyword == "FUNCTION" and (result := _RESULT.match(text, self._done)):
            self._copy_without_root(result)
        self._text.add_at(f"\n{header}\n", self._done)
        if self._is_data and (kind := _TYPE_OF_DATA.match(text, self._done)):
            self._text.add(kind[1], kind.start(1))
            self._done = kind.end()
            self._begin_data()

    def _copy_without_root(self, result: re.Match[str]) -> None:
        self._text.add(" : ", result.start())
        self._text.add(result[1], result.start(1))
        self._done = result.end()

    def _begin_data(self) -> None:
        """BEGIN, if no further section follows but start values."""
        rest = self._document.text[self._done :]
        following = next((one for one in _PARTS.finditer(rest) if one.lastgroup != "comment"), None)
        if following is None or following.lastgroup != "section":
            self._text.add_at("\nBEGIN\n", self._done)
            self._is_data = False

    # --- networks -------------------------------------------------------------------------------

    def _network(self, opening: re.Match[str], parts: Iterator[re.Match[str]]) -> None:
        """A network in SCL as statements, any other one as a statement that cannot run."""
        self._leave_out(opening)
        if not self._has_begun:
            self._text.add_at("BEGIN", opening.start())
            self._has_begun = True
        language = self._attributes.get("S7_Language", "").upper()
        self._attributes = {}
        if language in ("SCL", "") and not self._has_rungs(opening.end()):
            return
        closing = next((one for one in parts if one.lastgroup == "end"), None)
        language = language or "LAD"
        place = Span(self._document, opening.end() - len("NETWORK"), opening.end())
        self._findings.append(other_language(self._name.strip('"'), language, place))
        self._text.add_at(f" {foreign_body(language)}", place.start)
        end = closing.end() if closing is not None else len(self._document.text)
        self._text.add_at("\n" * self._document.text.count("\n", self._done, end), place.start)
        self._done = end

    def _has_rungs(self, start: int) -> bool:
        for part in _PARTS.finditer(self._document.text, start):
            if part.lastgroup in ("end", "rung"):
                return part.lastgroup == "rung"
        return False


def _header(attributes: Mapping[str, str]) -> Iterator[str]:
    """The header lines that say in an external source what the attributes say."""
    optimized = attributes.get("S7_Optimized", "TRUE").upper()
    yield f"{{ S7_Optimized_Access := '{optimized}' }}"
    for word in ("Author", "Family", "Version"):
        value = attributes.get(f"S7_{word}", "")
        if value:
            yield f"{word.upper()} : {value}"
