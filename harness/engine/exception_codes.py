"""Which faults `__CATCH` of CODESYS and TwinCAT catches, and the numbers it gets for them.

What says that a run makes no sense (the watchdog, blocks that call each other without end, a
statement that cannot run, a stub that is missing) is never caught. Numbers: TwinCAT 3 help, "Data
type __SYSTEM.ExceptionCode".
"""

from fbgen.diagnostics import DiagnosticError

_ARRAY_BOUNDS = 0x101
_DIVISION_BY_ZERO = 0x102
_OVERFLOW = 0x103
_NO_VALID_OPERATION = 0x154
_ACCESS_VIOLATION = 0x51
_UNKNOWN = 0xFFFF_FFFF

_CODES = {
    "FB6002": _ARRAY_BOUNDS,
    "FB6003": _DIVISION_BY_ZERO,
    "FB6006": _NO_VALID_OPERATION,
    "FB6007": _UNKNOWN,
    "FB6009": _UNKNOWN,
    "FB6010": _ACCESS_VIOLATION,
    "FB6014": _UNKNOWN,
    "FB6015": _UNKNOWN,
    "FB6030": _OVERFLOW,
    "FB6031": _ACCESS_VIOLATION,
    "FB6032": _UNKNOWN,
}


def exception_code(stop: DiagnosticError) -> int | None:
    """The number of a fault; None for one that is not caught."""
    return _CODES.get(stop.diagnostics[0].code)
