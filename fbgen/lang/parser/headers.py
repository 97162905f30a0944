"""Heads of blocks: TITLE, AUTHOR, FAMILY, NAME, VERSION, attributes, and comments between them.

Source: TIA Portal help, "Using external source files"; S7-SCL V5.3 manual, "Block attributes";
published sources for header lines in any order and comments between them.
"""

from fbgen.lang.ast import HeaderItem, TriviaList
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.parser.declarations import SECTIONS
from fbgen.lang.parser.namespaces import NamespaceParser
from fbgen.source import Span

_WORDS = frozenset({"AUTHOR", "FAMILY", "NAME", "VERSION"})
_FLAGS = frozenset({"KNOW_HOW_PROTECT", "NON_RETAIN", "RETAIN", "UNLINKED", "READ_ONLY"})


class HeaderParser(NamespaceParser):
    """Reads what stands between the name of a block and its declarations."""

    def pragmas_into(self, header: list[HeaderItem]) -> None:
        """All attributes in braces at the cursor, into `header`."""
        while self.extra_at <= self.at and (pragma := self.take_pragma()):
            header.append(pragma)

    def header_items(self, header: list[HeaderItem]) -> TriviaList:
        """The header lines, into `header`; the comments in front of them are given back.

        A comment in front of the first section, BEGIN or statement is left there, unless it ends
        the line of the block's name or of a header item.
        """
        comments: TriviaList = ()
        while True:
            if comment := self.take_same_line():
                comments += (comment,)
            self.pragmas_into(header)
            before = self.at
            item = self._header_item()
            if item is None:
                return comments
            comments += self.take_before(before)
            header.append(item)

    def _header_item(self) -> HeaderItem | None:
        first = self.at
        kind, text = self.kinds[first], self.texts[first]
        if kind != "name":
            return None
        word = text.upper()
        if word in _FLAGS:
            self.at += 1
            return HeaderItem(self.token_span(first), word, "")
        if word in _WORDS and self.kinds[first + 1] in (":", "="):
            return self._header_line(word)
        if word == "TITLE" and self.kinds[first + 1] == "=":
            return self._raw_line(word)
        if self.kinds[first + 1] == ":" and self.texts[first + 2][:1] == "'":
            message = f"a block's header has no {text}"
            self.report("FB3001", message, self.token_span(first), "write it as a comment: // ...")
            return self._header_line(word)
        return None

    def _header_line(self, word: str) -> HeaderItem:
        """`AUTHOR : text`, raw to the end of the line; VERSION is one token."""
        first = self.at
        self.at += 2
        self.need(Feature.HEADERS, first)
        if word == "VERSION":
            ends = self.kinds[self.at] == "end" or self.starts_line(self.at)
            self.at += 0 if ends else 1
        else:
            while not self.starts_line(self.at) and self.kinds[self.at] != "end":
                if self.kinds[self.at] in SECTIONS or self.kinds[self.at] in ("BEGIN", "STRUCT"):
                    break
                self.at += 1
        text = self.source.text[self.ends[first + 1] : self.ends[self.at - 1]].strip()
        self.drop_extras(self.ends[first + 1], self.ends[self.at - 1])
        return HeaderItem(self.span(first), word, text)

    def _raw_line(self, word: str) -> HeaderItem:
        """`TITLE = text`, whatever stands in the rest of the line."""
        first = self.at
        self.need(Feature.HEADERS, first)
        text = self.source.text
        end = text.find("\n", self.ends[first + 1])
        end = len(text) if end < 0 else end
        while self.starts[self.at] < end:
            self.at += 1
        self.drop_extras(self.ends[first + 1], end)
        raw = text[self.ends[first + 1] : end]
        return HeaderItem(Span(self.source, self.starts[first], end), word, raw.strip())

    def more_header(self, header: list[HeaderItem]) -> None:
        """The header lines that stand behind the type of a data block, into `header`."""
        self.pragmas_into(header)
        while item := self._header_item():
            header.append(item)
            self.pragmas_into(header)
