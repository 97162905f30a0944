"""Which dialect a file is in, by its name and by what only CODESYS and TwinCAT write.

Structured Text in a `.st` may be of anybody. A pragma with an attribute, pointers, THIS^ and the
names with two underscores are of CODESYS and TwinCAT, as is what 3S adds to PLCopen XML.
"""

import re
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

TEXT_SUFFIXES: Mapping[str, str] = MappingProxyType(
    {
        ".scl": "tia",
        ".udt": "tia",
        ".db": "tia",
        ".awl": "tia",
        ".s7dcl": "tia",
        ".st": "iec",
        ".iecst": "iec",
        ".exp": "twincat",
    }
)
XML_SUFFIXES: Mapping[str, str] = MappingProxyType(
    {
        ".tcpou": "twincat",
        ".tcdut": "twincat",
        ".tcgvl": "twincat",
        ".tcio": "twincat",
        ".tctto": "twincat",
        ".xml": "iec",
    }
)
SUFFIXES: Mapping[str, str] = MappingProxyType({**TEXT_SUFFIXES, **XML_SUFFIXES})
"""The dialect that a file name stands for where none is given; suffixes in small letters."""

_CODESYS = re.compile(
    r"\{\s*attribute\s*'|\b(?:POINTER|REFERENCE)\s+TO\b|\b(?:THIS|SUPER)\s*\^|\bREF\s*=|\b__[A-Z]{3,}\b"
    r"|\bBIT\s*;|3s-software\.com",
    re.IGNORECASE,
)


def told_dialect(path: Path, text: str) -> str | None:
    """The dialect of a file; None if its name does not tell one."""
    told = SUFFIXES.get(path.suffix.lower())
    return "twincat" if told == "iec" and _CODESYS.search(text) else told
