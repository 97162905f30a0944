"""Rules of the `iec` dialect: what MATIEC (OpenPLC) and CODESYS both take.

The parser already refuses what the dialect has not (slices, REGION, `#`, quotes, `+=`); here stands
what is only wrong for one of the compilers. Source: IEC 61131-3 third edition; MATIEC's readme.
"""

import re
from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint.emitted import EmittedText
from fbgen.lang import ast
from fbgen.lang.walk import walk

_DOUBLE_UNDERSCORE = re.compile(r"__|_$|^_[0-9]")


def no_line_comments(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5050: MATIEC knows only comments in (* *)."""
    for item in emitted.of(ast.Trivia):
        if item.kind is ast.TriviaKind.LINE_COMMENT:
            yield Diagnostic("FB5050", "a // comment", item.span, "write (* ... *)")


def plain_names(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5051: no name with two underscores in a row or one at its end."""
    for item in emitted.of(ast.DeclaredName):
        if _DOUBLE_UNDERSCORE.search(item.name):
            yield Diagnostic(
                "FB5051",
                f"'{item.name}' is no name of IEC 61131-3",
                item.span,
                "choose names without two underscores in a row and without one at the end",
            )


def addresses_only_declared(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5052: an address stands in a declaration with AT, never in code."""
    for unit in emitted.file.units:
        if isinstance(unit, ast.Block):
            for item in walk(unit.body):
                if isinstance(item, ast.DirectAddress):
                    yield Diagnostic(
                        "FB5052",
                        f"the address {item.span.text} stands in code",
                        item.span,
                        "declare a located variable and use its name",
                    )


RULES = (no_line_comments, plain_names, addresses_only_declared)
