"""Telegrams as scenario files write them: bytes in hexadecimal, `xx` for any byte."""

import re
from collections.abc import Iterable

from fbgen.diagnostics import Diagnostic
from harness.scenario.model import ExpectedTelegram

OUTPUT_BYTES = 9
"""Control word, trigger, INV-NO, command, ComNo, data; padding is left out."""
INPUT_BYTES = 8
"""Status word, INV-NO, command, ComNo, data."""
_BYTE = re.compile(r"[0-9A-Fa-f]{2}|xx")


def pattern_problems(telegram: ExpectedTelegram) -> Iterable[Diagnostic]:
    """FB8013 for what is no row of bytes of the right length."""
    for name, pattern, length in (
        ("output", telegram.output, OUTPUT_BYTES),
        ("input", telegram.input, INPUT_BYTES),
    ):
        parts = pattern.split() if pattern is not None else []
        wrong = [part for part in parts if not _BYTE.fullmatch(part)]
        advice = f"write {length} bytes such as 0B, separated by blanks, and xx for any byte"
        if wrong:
            message = f"'{wrong[0]}' is no byte"
            yield Diagnostic("FB8013", message, telegram.span_of(name), advice)
        elif pattern is not None and len(parts) != length:
            message = f"{len(parts)} bytes, where an {name} telegram has {length}"
            yield Diagnostic("FB8013", message, telegram.span_of(name), advice)


def bytes_match(pattern: str, data: bytes | None) -> bool:
    """Whether bytes are as written, `xx` standing for any byte."""
    parts = pattern.split()
    return (
        data is not None
        and len(parts) == len(data)
        and all(
            part == "xx" or part.upper() == f"{byte:02X}"
            for part, byte in zip(parts, data, strict=True)
        )
    )
