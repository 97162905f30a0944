"""What GET_ERROR and GET_ERR_ID of S7-1200 and S7-1500 are told of a fault that stops nothing.

Source: TIA Portal help, "GET_ERROR: Get error locally", tables of ERROR_ID and REACTION. Division
by zero and values out of range are none of these errors.
"""

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Assignment, Guarded, Substituted
from fbgen.source import Span
from harness.engine.fault_values import is_inside

_READ, _WRITE, _REFERENCE, _NO_BLOCK, _POINTER = 0x2522, 0x2523, 0x2533, 0x253A, 0x2503
_NUMBERS = {
    "FB6002": (_READ, _WRITE),
    "FB6010": (_READ, _WRITE),
    "FB6011": (_NO_BLOCK, _NO_BLOCK),
    "FB6017": (_POINTER, _POINTER),
    "FB6031": (_REFERENCE, _REFERENCE),
}
"""ERROR_ID where a place is read, and where it is written."""
_LEFT_OUT, _SUBSTITUTED, _SKIPPED = 0, 1, 2
"""REACTION."""


def local_error(stop: DiagnosticError, node: Substituted | Guarded) -> int | None:
    """What is noted of a fault in a node; None for one that is not of this kind, or not in it."""
    diagnostic = stop.diagnostics[0]
    numbers, place = _NUMBERS.get(diagnostic.code), diagnostic.span
    if numbers is None or place is None or not is_inside(place, node.span):
        return None
    read, write = numbers
    if isinstance(node, Substituted):
        return _SUBSTITUTED << 16 | read
    if _is_written(node, place):
        return _LEFT_OUT << 16 | write
    return _SKIPPED << 16 | read


def _is_written(node: Guarded, place: Span) -> bool:
    return isinstance(node.statement, Assignment) and is_inside(place, node.statement.target.span)
