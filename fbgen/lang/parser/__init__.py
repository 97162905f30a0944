"""Text to syntax tree: recursive descent with precedence climbing, one pass, all errors at once.

    file = parse(Source("pump.scl", text), "tia")

Chains of operands are left-deep trees of any length; walk them in a loop down the left side.
Nesting (parentheses, brackets, statements in statements) ends at `depth.DEEPEST` levels.
"""

from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.lang.ast import File
from fbgen.lang.collector import collector_at_rest
from fbgen.lang.depth import room_for_depth
from fbgen.lang.dialects import dialect_named
from fbgen.lang.parser.blocks import BlockParser
from fbgen.source import Source

__all__ = ["parse", "parse_recovering"]


def parse(source: Source, dialect: str) -> File:
    """The syntax tree of a text. Raises `DiagnosticError` with every error that it has."""
    file, diagnostics = parse_recovering(source, dialect)
    if errors := [found for found in diagnostics if found.severity is Severity.ERROR]:
        raise DiagnosticError(errors)
    return file


def parse_recovering(source: Source, dialect: str) -> tuple[File, list[Diagnostic]]:
    """What could be read of a text, with the findings in the order of their places.

    Raises `DiagnosticError` (FB3011) only for an unknown dialect.
    """
    rules = dialect_named(dialect)
    with collector_at_rest(), room_for_depth():
        parser = BlockParser(source, rules)
        file = parser.file()
    return file, parser.findings()
