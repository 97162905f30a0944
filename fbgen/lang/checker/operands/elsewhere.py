"""The help for a name that no given source declares, but perhaps another file of the project.

In sources for S7 a name in quotes belongs to the whole project: a block, a type, a data block, a
PLC tag or a constant. One file of a project alone mentions many that are not in it.
"""

from collections.abc import Iterable

from fbgen.nearest import did_you_mean

_FILES = "name the file that has it as well: all files of a command are one program"
_TABLES = "a constant or PLC tag is in no source: give it with --tags FILE or --constant NAME=VALUE"
_ALIKE = 0.85
"""A project has many names that begin or end alike; only a slip of the keyboard is near."""


def type_help(name: str, known: Iterable[str]) -> str:
    """For a type or function block that something is declared with."""
    return did_you_mean(name, known, _ALIKE) or _FILES


def block_help(name: str, known: Iterable[str]) -> str:
    """For a block that is called."""
    return did_you_mean(name, known, _ALIKE) or f"{_FILES}; a run can stub it"


def value_help(name: str, known: Iterable[str]) -> str:
    """For what stands for a value, or has members."""
    return did_you_mean(name, known, _ALIKE) or (
        f"{_TABLES}; for a data block {_FILES}; a text stands in '...'"
    )
