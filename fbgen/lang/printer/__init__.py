"""Syntax tree to text: one canonical layout per dialect, comments kept.

    printed = print_file(parse(source, "tia"))
    printed.text, printed.origins        # the origins of each line, its template line first
    printed.places                       # the place in the source, or None, for each line

Printing what was read from a printed text gives that text again. What a dialect spells in another
way is lowered first (`fbgen.lang.lowering`); only comments are spelled here, as `(* *)` where the
dialect has no `//`. Layout: published TIA Portal exports; IEC 61131-3 leaves it open.
"""

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note
from fbgen.lang.ast import File
from fbgen.lang.depth import room_for_depth
from fbgen.lang.dialects import dialect_named
from fbgen.lang.printer.line_origins import LineOrigins
from fbgen.lang.printer.units import UnitPrinter
from fbgen.source import Source, Span

__all__ = ["LineOrigins", "PrintedText", "print_file", "print_generated"]


@dataclass(frozen=True, slots=True)
class PrintedText:
    """A text with line ends LF, and where each of its lines came from.

    `places` lie in the text that was read, `origins` in what that text was generated from.
    `together` counts the lines that have one place together.
    """

    text: str
    origins: tuple[LineOrigins, ...]
    places: tuple[Span | None, ...]
    together: tuple[int, ...]


def print_file(file: File) -> PrintedText:
    """The text of a syntax tree in its own dialect."""
    printer = UnitPrinter(dialect_named(file.dialect))
    with room_for_depth():
        printer.file(file)
    lines = printer.lines
    return PrintedText(lines.text(), lines.origins(), lines.places(), lines.together())


def print_generated(file: File) -> PrintedText:
    """As `print_file`, for text that the PLC's tools shall import: plain ASCII, line ends LF.

    Raises `DiagnosticError` (FB3040) with one finding for each line that holds anything else.
    """
    printed = print_file(file)
    if not printed.text.isascii():
        raise DiagnosticError(_beyond_ascii(printed, file.source.name))
    return printed


def _beyond_ascii(printed: PrintedText, name: str) -> list[Diagnostic]:
    source = Source(f"generated from {name}", printed.text)
    findings: list[Diagnostic] = []
    offset = 0
    for line, known in zip(printed.text.splitlines(keepends=True), printed.origins, strict=False):
        foreign = next((at for at, char in enumerate(line) if not char.isascii()), None)
        if foreign is not None:
            char = line[foreign]
            notes = tuple(
                Note(f"from {origin.what}, {origin.file}:{origin.line}") for origin in known[-1:]
            )
            findings.append(
                Diagnostic(
                    "FB3040",
                    f"the generated text has the character '{char}' (U+{ord(char):04X})",
                    Span(source, offset + foreign, offset + foreign + 1),
                    "use plain ASCII in templates and catalogue; TIA Portal imports nothing else",
                    notes,
                )
            )
        offset += len(line)
    return findings
