"""Dialects as data: what a dialect of the PLC language has, and how it is laid out.

A dialect does not inherit from another one. The lexer, the parser, the printer and the lowering
look at its features; nothing else in the code asks for the name of a dialect.
"""

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.iec import IEC
from fbgen.lang.dialects.step7 import STEP7
from fbgen.lang.dialects.tia import TIA
from fbgen.lang.dialects.twincat import TWINCAT

__all__ = ["DIALECTS", "Dialect", "Feature", "dialect_named"]

DIALECTS: dict[str, Dialect] = {dialect.name: dialect for dialect in (TIA, STEP7, IEC, TWINCAT)}
"""All dialects by name, in the order in which they are shown."""


def dialect_named(name: str) -> Dialect:
    """The dialect with this name. Raises `DiagnosticError` (FB3011) for an unknown one."""
    dialect = DIALECTS.get(name)
    if dialect is None:
        known = ", ".join(DIALECTS)
        raise DiagnosticError(
            [Diagnostic("FB3011", f"there is no dialect '{name}'", help=f"choose one of: {known}")]
        )
    return dialect
