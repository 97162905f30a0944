"""Rules for the characters of any generated text.

Source: TIA Portal Openness help, "Importing external source files": ASCII only; the Windows tools
take both line ends, and LF gives the same bytes everywhere.
"""

import re
from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint.emitted import EmittedText
from fbgen.source import Span

_FOREIGN = re.compile(r"[^\n -~]")


def only_printable_ascii(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5040: a character that is not printable ASCII, or a line end that is not LF."""
    for found in _FOREIGN.finditer(emitted.source.text):
        code = ord(found[0])
        yield Diagnostic(
            "FB5040",
            f"the character U+{code:04X} stands in generated text",
            Span(emitted.source, found.start(), found.end()),
            "names and titles of the catalogue and the plant must be ASCII",
        )


def ends_with_line_end(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5040: no line end behind the last line."""
    if not emitted.source.text.endswith("\n"):
        end = len(emitted.source.text)
        yield Diagnostic("FB5040", "the last line does not end", Span(emitted.source, end, end))


RULES = (only_printable_ascii, ends_with_line_end)
