"""Inputs, outputs and bit memory of a block on its own, by address: `address.IW256`.

`address.I0.3` is a bit, `address.IB256` a byte, `address.QW264` and `address.MD10` are words and
double words with the high byte first.
"""

import re
from collections.abc import Callable

from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.types import BOOL, BYTE, DWORD, WORD, Elementary
from fbgen.source import Span
from harness.engine.environment import Environment
from harness.scenario.kinds import Found

_ADDRESS = re.compile(r"%?([IQM])(?:([BWD])(\d{1,5})|X?(\d{1,5})\.([0-7]))", re.IGNORECASE)
_TYPES = {"B": (BYTE, 1), "W": (WORD, 2), "D": (DWORD, 4)}


class Place:
    """A bit, a byte or a word of one of the three areas."""

    def __init__(self, environment: Environment, text: str, span: Span | None) -> None:
        """Raises DiagnosticError FB8003 for what is no address, or one that is not there."""
        match = _ADDRESS.fullmatch(text)
        if match is None:
            raise _unknown(f"'{text}' is no address", span, "write IB256, QW264, MD10 or I0.3")
        area, size, number, byte, bit = match.groups()
        areas = {"I": environment.inputs, "Q": environment.outputs, "M": environment.markers}
        self._memory = areas[area.upper()]
        self._first = int(number or byte)
        self._bit = None if bit is None else int(bit)
        self.type: Elementary
        self.type, self._length = (BOOL, 1) if size is None else _TYPES[size.upper()]
        if self._first + self._length > len(self._memory):
            advice = f"a block on its own has {len(self._memory)} bytes of each area"
            raise _unknown(f"there is no '{text}'", span, advice)

    @property
    def read(self) -> Callable[[], Found]:
        """What gives the value that stands there."""
        return self._flag if self._bit is not None else self._number

    def write(self, value: Found) -> None:
        """Put a value there."""
        assert isinstance(value, int), "the type of the path lets nothing else through"
        if self._bit is None:
            last = self._first + self._length
            self._memory[self._first : last] = value.to_bytes(self._length, "big")
        else:
            mask = 1 << self._bit
            self._memory[self._first] &= ~mask
            self._memory[self._first] |= mask if value else 0

    def _number(self) -> Found:
        return int.from_bytes(self._memory[self._first : self._first + self._length], "big")

    def _flag(self) -> Found:
        assert self._bit is not None
        return bool(self._memory[self._first] >> self._bit & 1)


def _unknown(message: str, span: Span | None, advice: str) -> DiagnosticError:
    return error("FB8003", message, span, advice)
