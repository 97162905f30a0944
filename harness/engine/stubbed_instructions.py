"""System instructions that a stub carries out where there is no hardware; areas as bytes."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.types import Scalar
from fbgen.source import Span
from harness.engine.stubs import Stub

if TYPE_CHECKING:
    from harness.engine.environment import Area

_RESULT = "ret_val"
_WORD = 1 << 16


def carry_out(
    stub: Stub, name: str, arguments: Mapping[str, "Scalar | Area"], span: Span
) -> Scalar:
    """What the stub gives, as INT; 16#8090 is the negative number with these bits.

    Areas that it names are filled with its bytes, or with those of a text in hexadecimal. Raises
    DiagnosticError FB6071 for what the call does not take.
    """
    areas = {
        key.casefold(): value
        for key, value in arguments.items()
        if not isinstance(value, bool | int | float | str)
    }
    given = stub(**{key: arguments[key] for key in arguments if key.casefold() not in areas})
    results = given if isinstance(given, Mapping) else {_RESULT: given}
    by_key = {str(key).casefold(): value for key, value in results.items()}
    status = by_key.pop(_RESULT, 0)
    for key, value in by_key.items():
        if key not in areas:
            raise _wrong(name, f"'{key}', which the call does not ask for", span)
        areas[key].write(octets(name, value, span))
    if not isinstance(status, int) or not -_WORD // 2 <= status < _WORD:
        raise _wrong(name, f"{status!r}, and the call has an INT", span)
    return status - _WORD if status >= _WORD // 2 else int(status)


def octets(name: str, value: object, span: Span) -> bytes:
    """The bytes of an area that a stub gave, as such or in hexadecimal. Raises FB6071."""
    if isinstance(value, bytes):
        return value
    try:
        return bytes.fromhex(str(value))
    except ValueError:
        raise _wrong(name, f"{value!r}, and the area takes bytes", span) from None


def _wrong(name: str, what: str, span: Span) -> DiagnosticError:
    advice = 'give RET_VAL a number, and areas their bytes, such as "DF 00 0B 47"'
    return error("FB6071", f"the stub of {name} gave {what}", span, advice)
