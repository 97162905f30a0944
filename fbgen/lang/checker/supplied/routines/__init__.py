"""The controller's instructions that take values and give several values: their parameters.

The tables have one line for each: `WORD(IN INT, OUT => REAL)` is an instruction with one input, one
output and a result; `<>` marks an in-out, `?` a parameter that can be left out, `#` stands for
numbers from 0 on, `...` for any further parameters, `|` between types that a parameter can have.
A line is read when its instruction is first used, so the tables cost a program nothing.
"""

from functools import cache

from fbgen.lang.checker.supplied.routines.analog import ANALOG
from fbgen.lang.checker.supplied.routines.clock import CLOCK, CLOCK_ALIASES
from fbgen.lang.checker.supplied.routines.dates import DATES
from fbgen.lang.checker.supplied.routines.hardware import HARDWARE_ALIASES, HARDWARE_FUNCTIONS
from fbgen.lang.checker.supplied.routines.s5 import S5
from fbgen.lang.checker.supplied.routines.signature import (
    Direction,
    Parameter,
    Routine,
    read_signature,
)
from fbgen.lang.checker.supplied.routines.texts import TEXTS

__all__ = ["MODELLED", "Direction", "Parameter", "Routine", "is_modelled", "routine_named"]

MODELLED: dict[str, str] = {**ANALOG, **CLOCK, **DATES, **TEXTS, **S5}
"""What the engines carry out themselves, by upper-case name."""

_ALIASES = {**CLOCK_ALIASES, **HARDWARE_ALIASES}


def _canonical(name: str) -> str:
    key = name.upper()
    return _ALIASES.get(key, key)


def is_modelled(name: str) -> bool:
    """True for an instruction of these tables that the engines carry out."""
    return _canonical(name) in MODELLED


@cache
def routine_named(name: str) -> Routine | None:
    """The instruction with that name, whatever its case and spelling."""
    key = _canonical(name)
    text = MODELLED.get(key) or HARDWARE_FUNCTIONS.get(key)
    return None if text is None else read_signature(key, text, modelled=key in MODELLED)
