"""The prefix of generated names: `TOS_`, unless the plant file has one of its own.

Templates, pages and scenarios call everything by the usual prefix. With `prefix: ACME_` the block
`TOS_Main` is called `ACME_Main`, and the type `typeTosDrive` is called `typeAcmeDrive`. Blocks of
gateways for process data keep their family behind it: `PBDP_Drive` is called `ACME_PBDP_Drive`, the
type `typePbdpDrive` is called `typeAcmePbdpDrive`; so do those of serial lines (`TIP_`, `MB_`) and
of DeviceNet (`DEV_`).
"""

import re
from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.source import Span

USUAL_PREFIX = "TOS_"
LONGEST_PREFIX = 12
_PREFIX = re.compile(r"[A-Za-z][A-Za-z0-9]*_")
_FAMILIES = ("PBDP_", "TIP_", "MB_", "DEV_", "typePbdp", "typeTip", "typeDev")
"""How the names of blocks and types of another family begin, which stays behind a prefix."""
_USUAL_NAME = re.compile(
    r"(?<![A-Za-z0-9_])(?:(?P<block>TOS_)|(?P<type>typeTos)|(?P<other>PBDP_|TIP_|MB_|DEV_)|type(?=Pbdp|Tip|Dev))"
    r"(?=[A-Za-z_])"
)


def with_prefix(text: str, prefix: str) -> str:
    """A text in which every name with the usual prefix has this one."""
    if prefix == USUAL_PREFIX:
        return text
    of_types = type_prefix(prefix)

    def changed(found: re.Match[str]) -> str:
        if found["other"]:
            return f"{prefix}{found['other']}"
        return prefix if found["block"] else of_types

    return _USUAL_NAME.sub(changed, text)


def type_prefix(prefix: str) -> str:
    """How the names of data types begin: `typeTos` for `TOS_`, `typeMyPlant` for `MyPlant_`."""
    stem = prefix.rstrip("_")
    return f"type{stem.capitalize() if stem.isupper() else stem[:1].upper() + stem[1:]}"


def reserved_beginnings(prefix: str) -> tuple[str, ...]:
    """How no name of a gateway or a drive may begin, in lower case."""
    return tuple(
        dict.fromkeys(
            start.lower()
            for one in (USUAL_PREFIX, prefix)
            if one
            for start in (one, type_prefix(one), *_FAMILIES)
        )
    )


def prefix_problems(prefix: str, span: Span | None) -> Iterator[Diagnostic]:
    """FB2021 for a prefix that makes no names for all dialects."""
    if not _PREFIX.fullmatch(prefix):
        stem = re.sub(r"[^A-Za-z0-9]", "", prefix).lstrip("0123456789") or "HALL"
        yield Diagnostic(
            "FB2021",
            f"'{prefix}' is no prefix for names of blocks",
            span,
            f"use letters and digits, a letter first, and one underscore at the end: {stem}_",
        )
    elif len(prefix) > LONGEST_PREFIX:
        yield Diagnostic(
            "FB2021",
            f"the prefix '{prefix}' has {len(prefix)} characters",
            span,
            f"use at most {LONGEST_PREFIX}; STEP 7 V5 takes 24 for a whole name",
        )
