"""Values as the PLC languages write them, from and to text: `16#8401`, `T#1s200ms`, `'on'`, `TRUE`.

A text means something only together with a type: `5` is no TIME, and `16#FF` no STRING. What is
shown for a type can be read back for it.
Source: IEC 61131-3, literals; TIA Portal help, "Constants".
"""

from collections.abc import Mapping
from datetime import date, timedelta

from fbgen.lang.ast import LiteralKind
from fbgen.lang.dates import (
    DAYS,
    NS_PER_DAY,
    count_of,
    counted_in,
    instant_of,
)
from fbgen.lang.literals import BadLiteralError, LiteralValue, duration_text, read_literal
from fbgen.lang.types import (
    LTIME,
    TIME_OF_DAY,
    ArrayType,
    Elementary,
    Enumeration,
    Family,
    Scalar,
    StringType,
    StructType,
    Type,
)
from harness.engine.interface import Value
from harness.engine.values import accept_scalar
from harness.kernel import NS_PER_MS, NS_PER_S

LITERALS = {
    "TIME": (LiteralKind.DURATION, "T#2s or T#1m30s"),
    "LTIME": (LiteralKind.DURATION, "LT#2s or LT#1m30s"),
    "DATE": (LiteralKind.DATE, "D#2024-02-29"),
    "LDATE": (LiteralKind.DATE, "LDATE#2024-02-29"),
    "TIME_OF_DAY": (LiteralKind.TIME_OF_DAY, "TOD#23:59:59"),
    "LTIME_OF_DAY": (LiteralKind.TIME_OF_DAY, "LTOD#23:59:59"),
    "DATE_AND_TIME": (LiteralKind.DATE_AND_TIME, "DT#2024-02-29-23:59:59"),
    "LDT": (LiteralKind.DATE_AND_TIME, "LDT#2024-02-29-23:59:59"),
}
"""Types whose values need their prefix: the kind of literal, and an example."""

_EPOCH = date(1970, 1, 1)
_PREFIXES = {"DATE": "D", "LDATE": "LDATE", "DATE_AND_TIME": "DT", "LDT": "LDT"}
_TRUTHS = {"true": True, "false": False, "1": True, "0": False}
_ESCAPES = {"$": "$$", "'": "$'", "\n": "$L", "\r": "$R", "\t": "$T", "\f": "$P"}


class WrongSpellingError(ValueError):
    """A text that no value of the type is written like; `help` says how one is written."""

    def __init__(self, help: str) -> None:  # noqa: A002 - the word of the diagnostics
        super().__init__(help)
        self.help = help


def read_value(kind: Type, text: str) -> Scalar:
    """The value of a type that is written as in PLC text. Raises WrongSpellingError.

    BOOL may also be 1 or 0, and a text may stand without quotes. Raises DiagnosticError FB6021 for
    a value that is written rightly and does not fit.
    """
    if isinstance(kind, StringType):
        return accept_scalar(text, kind, _text(text))
    if not isinstance(kind, Elementary):
        raise WrongSpellingError(f"{kind} has parts: name one of them")
    if kind.family is Family.BOOL:
        if (truth := _TRUTHS.get(text.strip().casefold().removeprefix("bool#"))) is None:
            raise WrongSpellingError("write TRUE or FALSE")
        return truth
    if kind.family is Family.CHAR:
        return accept_scalar(text, kind, _text(text))
    return accept_scalar(text, kind, _number(kind, text))


def _text(text: str) -> str:
    quoted = len(text) > 1 and text[0] == text[-1] == "'"
    typed = text.partition("#")[0].upper() in ("STRING", "WSTRING", "CHAR", "WCHAR")
    if not quoted and not (typed and text.endswith("'")):
        return text
    return str(_literal(text).value)


def _number(kind: Elementary, text: str) -> int | float:
    text = text.strip()
    if isinstance(kind, Enumeration) and text[:1].isidentifier():
        return int(accept_scalar(text, kind, text))
    sign = -1 if text.startswith("-") else 1
    literal = _literal(text.removeprefix("-") if sign < 0 else text.removeprefix("+"))
    value = literal.value
    if wanted := LITERALS.get(kind.name):
        if literal.kind is not wanted[0] or not isinstance(value, int) or sign < 0:
            raise WrongSpellingError(f"write it as the PLC does, such as {wanted[1]}")
        return counted(kind, value)
    if literal.kind is LiteralKind.INTEGER or (
        literal.kind is LiteralKind.REAL and kind.family is Family.REAL
    ):
        assert not isinstance(value, str)
        return sign * value
    raise WrongSpellingError(
        "write a number" if kind.family is Family.REAL else "write a whole number, such as 16#FF"
    )


def _literal(text: str) -> LiteralValue:
    try:
        return read_literal(text)
    except BadLiteralError as wrong:
        raise WrongSpellingError(wrong.help or str(wrong)) from None


def counted(kind: Elementary, literal: int) -> int:
    """What a variable of the type holds for a duration, date or time of day of a literal."""
    if counted_in(kind):
        return count_of(kind, literal)
    return literal // NS_PER_MS if counts_ms(kind) else literal


def counts_ms(kind: Elementary) -> bool:
    """Whether values of a type count milliseconds, as TIME does; literals count nanoseconds."""
    return kind is TIME_OF_DAY or (kind.family is Family.DURATION and kind is not LTIME)


def spell(kind: Type, value: Value) -> str:
    """A value as PLC text writes it; structures and arrays with all their parts."""
    if isinstance(value, str):
        return "'" + "".join(_ESCAPES.get(character, character) for character in value) + "'"
    if isinstance(value, Mapping):
        fields = (
            {field.name: field.type for field in kind.fields}
            if (isinstance(kind, StructType))
            else {}
        )
        parts = (f"{name} := {_part(fields.get(name), part)}" for name, part in value.items())
        return f"({', '.join(parts)})"
    if not isinstance(value, bool | int | float):
        element = kind.element if isinstance(kind, ArrayType) else None
        return f"[{', '.join(_part(element, item) for item in value)}]"
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    if isinstance(value, float):
        return _real(kind, value)
    return _whole(kind, value)


def _part(kind: Type | None, value: Value) -> str:
    return spell(kind, value) if kind is not None else str(value)


def _real(kind: Type, value: float) -> str:
    """The shortest decimal number that is this REAL: seven digits where they will do."""
    if isinstance(kind, Elementary) and kind.bits == 32:
        for digits in (6, 7, 8):
            short = f"{value:.{digits}g}"
            if accept_scalar("", kind, float(short)) == value:
                break
        else:
            short = f"{value:.9g}"
        value = float(short)
    return repr(value)


def _whole(kind: Type, value: int) -> str:
    if not isinstance(kind, Elementary):
        return str(value)
    if isinstance(kind, Enumeration) and (name := kind.name_of(value)):
        return name
    if kind.family is Family.BITS:
        return f"16#{value:0{kind.bits // 4}X}"
    if kind.family is Family.DURATION:
        text = duration_text(value * (NS_PER_MS if counts_ms(kind) else 1))
        return text if counts_ms(kind) else f"L{text}"
    if kind.family is Family.DATE:
        return _instant(kind, value)
    return str(value)


def _instant(kind: Elementary, value: int) -> str:
    if not counted_in(kind):
        ns = value * (NS_PER_MS if counts_ms(kind) else 1)
        return f"{'TOD' if counts_ms(kind) else 'LTOD'}#{_clock(ns)}"
    days, ns = divmod(instant_of(kind, value), NS_PER_DAY)
    text = f"{_PREFIXES[kind.name]}#{_EPOCH + timedelta(days=days)}"
    return text if kind in DAYS else f"{text}-{_clock(ns)}"


def _clock(ns: int) -> str:
    seconds, rest = divmod(ns, NS_PER_S)
    minutes, second = divmod(seconds, 60)
    hour, minute = divmod(minutes, 60)
    fraction = f".{rest:09d}".rstrip("0").rstrip(".")
    return f"{hour:02d}:{minute:02d}:{second:02d}{fraction}"
