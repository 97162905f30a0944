"""Checks a piece of PLC text, for the tests of the checker."""

from fbgen.diagnostics import Diagnostic, Severity
from fbgen.lang.checked import Program
from fbgen.lang.checker import check, check_reporting
from fbgen.lang.parser import parse
from fbgen.source import Source


def program_of(text: str, dialect: str = "iec") -> Program:
    """The checked program; fails on any error."""
    return check([parse(Source("test", text), dialect)], dialect)


def findings_of(text: str, dialect: str = "iec", name: str = "test") -> list[Diagnostic]:
    """All errors and warnings."""
    return [one for one in _all_of(text, dialect, name) if one.severity is not Severity.INFO]


def hints_of(text: str, dialect: str = "iec", name: str = "test") -> list[Diagnostic]:
    """What is neither an error nor a warning."""
    return [one for one in _all_of(text, dialect, name) if one.severity is Severity.INFO]


def _all_of(text: str, dialect: str, name: str) -> list[Diagnostic]:
    return check_reporting([parse(Source(name, text), dialect)], dialect)[1]


def errors_of(text: str, dialect: str = "iec") -> list[Diagnostic]:
    """The errors only."""
    return [one for one in findings_of(text, dialect) if one.severity is Severity.ERROR]


def in_program(declarations: str, statements: str) -> str:
    """A PROGRAM with these variables and statements, the statements from line 3 on."""
    return f"PROGRAM main\nVAR {declarations} END_VAR\n{statements}\nEND_PROGRAM\n"


def in_block(declarations: str, statements: str) -> str:
    """A TIA function block with these statics and statements, the statements from line 4 on."""
    return (
        f'FUNCTION_BLOCK "Test"\nVAR {declarations} END_VAR\nBEGIN\n{statements}\n'
        "END_FUNCTION_BLOCK\n"
    )
