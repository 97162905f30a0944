"""Which of Siemens' SCL a text is: TIA Portal's, or that of STEP 7 V5.

Both have the suffix `.scl`. Most texts are read alike; some are written in one of them only.
"""

import re
from enum import Enum

_NO_TEXT = re.compile(rb"//[^\r\n]*|\(\*.*?\*\)|'[^'\r\n]*'", re.DOTALL)
_TIA = re.compile(
    rb"\bS7_Optimized_Access\b|\bVAR\s+CONSTANT\b|^[ \t]*REGION\b",
    re.IGNORECASE | re.MULTILINE,
)
# Sections, options of the compiler, peripheral access with brackets, addresses without %.
_CLASSIC = re.compile(
    rb"\bEND_CONST\b|\bEND_LABEL\b|\bScl_\w+\s*(?::=|;)|\bP[EAIQ][BWD]\s*\["
    rb"|(?<![%\w.\"#])(?:P[EAIQ][BWD]\d+|[EAIQM]\d+\.[0-7])(?![\w.])",
    re.IGNORECASE,
)
_NUMBERED = re.compile(rb":\s*S?FB\s?\d+\s*;", re.IGNORECASE)
_WITH_BLANK = re.compile(
    rb"^[ \t]*(?:FUNCTION(?:_BLOCK)?|(?:DATA|ORGANIZATION)_BLOCK|TYPE)[ \t]+"
    rb"(?:FB|FC|OB|DB|UDT)[ \t]+\d+",
    re.IGNORECASE | re.MULTILINE,
)
"""`FUNCTION FC 10`, as STEP 7 V5 writes the sources of its blocks."""
_MARKED = re.compile(rb"(?<![\w\"])#[A-Za-z_\"]")
"""Instances of blocks by number are of STEP 7; TIA Portal marks what is local with #."""


class Age(Enum):
    """What a text tells about itself."""

    CLASSIC = "step7"
    TIA = "tia"
    EITHER = ""


def age_of(data: bytes) -> Age:
    """What the bytes of a file tell, in whatever encoding."""
    text = data.replace(b"\0", b"")
    if _TIA.search(text):
        return Age.TIA
    if _WITH_BLANK.search(text):
        return Age.CLASSIC
    if not (_CLASSIC.search(text) or _NUMBERED.search(text)):
        return Age.EITHER
    code = _NO_TEXT.sub(b" ", text)
    if _CLASSIC.search(code) or (_NUMBERED.search(code) and not _MARKED.search(code)):
        return Age.CLASSIC
    return Age.EITHER
