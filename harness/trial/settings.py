"""Inputs that somebody sets for a trial: `start=1`, `speed=50.0@3`, `name='x'@200ms`."""

import re

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.lang.ast import LiteralKind
from fbgen.lang.literals import BadLiteralError, read_literal

_SETTING = re.compile(r"(?P<path>[^=]+?)=(?P<text>'(?:[^'$]|\$.)*'|.*?)(?:@(?P<when>[^@']*))?")


@dataclass(frozen=True, slots=True)
class Setting:
    """The variable at `path` gets the value `text` in front of cycle number `cycle`, from 1.

    The value stays until another setting changes it. Instead of the cycle, `at_ns` may be the time
    from the first cycle on: the first cycle that does not begin before it.
    """

    path: str
    text: str
    cycle: int = 1
    at_ns: int | None = None

    def is_due(self, cycle: int, now_ns: int) -> bool:
        """Whether it belongs in front of this cycle, or of one before it."""
        return cycle >= self.cycle if self.at_ns is None else now_ns >= self.at_ns


def read_setting(text: str) -> Setting:
    """The setting that a person wrote. Raises DiagnosticError FB9010."""
    match = _SETTING.fullmatch(text.strip())
    if match is None or not match["path"].strip():
        raise error(
            "FB9010",
            f"'{text}' does not say what to set",
            help="write name=value, or name=value@3 for cycle 3, or name=value@200ms",
        )
    path, value, when = match["path"].strip(), match["text"].strip(), match["when"]
    if when is None:
        return Setting(path, value)
    if when.isdecimal() and int(when):
        return Setting(path, value, cycle=int(when))
    if not when.isdecimal() and (at_ns := _duration(when)) is not None and at_ns >= 0:
        return Setting(path, value, at_ns=at_ns)
    raise error(
        "FB9010",
        f"'@{when}' of '{text}' is neither a cycle nor a time",
        help="write @1 for the first cycle, @2 for the second, or @200ms",
    )


def read_duration(text: str) -> int:
    """Nanoseconds of `10ms`, `1.5s` or `T#1m30s`. Raises DiagnosticError FB9010."""
    found = _duration(text)
    if found is None:
        raise error("FB9010", f"'{text}' is no time", help="write a time such as 10ms, 1.5s or 2m")
    if found < 0:
        raise error("FB9010", f"'{text}' is in the past", help="write a time that is not negative")
    return found


def _duration(text: str) -> int | None:
    try:
        found = read_literal(text if "#" in text else f"T#{text}")
    except BadLiteralError:
        return None
    if found.kind is not LiteralKind.DURATION or not isinstance(found.value, int):
        return None
    return found.value
