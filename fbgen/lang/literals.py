"""Values of literals: numbers, durations, dates, strings, in all prefixes and spellings.

Source: IEC 61131-3, tables of numeric, string, duration and date literals; TIA Portal help,
"Constants" (S5TIME, DTL, `$` escapes); classic STEP 7 for `B#16#`, `W#16#`, `DW#16#`, `L#`.
Ranges are the checker's business, as they may depend on where the literal stands.
"""

import re
from datetime import date

from fbgen.dataclass import dataclass
from fbgen.lang.ast import LiteralKind
from fbgen.lang.dialects.words import words
from fbgen.lang.types import ALIASES, ELEMENTARY, Family


@dataclass(frozen=True, slots=True)
class LiteralValue:
    """What a literal means: the parts of `ast.Literal` that do not depend on its place."""

    kind: LiteralKind
    value: bool | int | float | str
    type_name: str = ""
    base: int = 10


class BadLiteralError(ValueError):
    """The text looks like a literal and is none; `help` says how to write it."""

    def __init__(self, message: str, help: str) -> None:  # noqa: A002
        super().__init__(message)
        self.help = help


_SHORT_TYPES = {"B": "BYTE", "W": "WORD", "DW": "DWORD", "LW": "LWORD", "L": "DINT"}
_DURATIONS = {
    "T": "TIME",
    "TIME": "TIME",
    "LT": "LTIME",
    "LTIME": "LTIME",
    "S5T": "S5TIME",
    "S5TIME": "S5TIME",
}
_DATES = {"D": "DATE", "DATE": "DATE", "LDATE": "LDATE", "LD": "LDATE"}
_TIMES_OF_DAY = {
    "TOD": "TIME_OF_DAY",
    "TIME_OF_DAY": "TIME_OF_DAY",
    "LTOD": "LTIME_OF_DAY",
    "LTIME_OF_DAY": "LTIME_OF_DAY",
}
_DATES_AND_TIMES = {
    "DT": "DATE_AND_TIME",
    "DATE_AND_TIME": "DATE_AND_TIME",
    "LDT": "LDT",
    "LDATE_AND_TIME": "LDT",
    "DTL": "DTL",
}
_STRINGS = {"STRING": False, "CHAR": False, "WSTRING": True, "WCHAR": True}

_INTEGER = re.compile(r"[+-]?[0-9]+(?:_[0-9]+)*\Z")
_REAL = re.compile(
    r"[+-]?[0-9]+(?:_[0-9]+)*(?:\.[0-9]+(?:_[0-9]+)*(?:[eE][+-]?[0-9]+)?|[eE][+-]?[0-9]+)\Z"
)
_BASED = re.compile(r"([+-]?)(2|8|10|16)#([0-9A-Fa-f]+(?:_[0-9A-Fa-f]+)*)\Z")
_DURATION_PART = re.compile(r"_?([0-9]+(?:_[0-9]+)*)(?:\.([0-9]+))?(ms|us|ns|d|h|m|s)", re.I)
_DATE = re.compile(r"([0-9]{4})-([0-9]{1,2})-([0-9]{1,2})\Z")
_CLOCK = re.compile(r"([0-9]{1,2}):([0-9]{1,2})(?::([0-9]{1,2})(?:\.([0-9]{1,9}))?)?\Z")

_UNIT_NS = {
    "d": 86_400_000_000_000,
    "h": 3_600_000_000_000,
    "m": 60_000_000_000,
    "s": 1_000_000_000,
    "ms": 1_000_000,
    "us": 1_000,
    "ns": 1,
}
_UNITS = tuple(_UNIT_NS)
_ESCAPED = {"$": "$", "'": "'", '"': '"', "L": "\n", "N": "\n", "P": "\f", "R": "\r", "T": "\t"}
_BROKEN = re.compile(r"\$>\s*\$<")
"""Where a string of STEP 7 ends in one line and goes on in another."""
_FIRST_DAY = date(1970, 1, 1)
_SHORT_YEAR = 2
_MAX_DIGITS = 4000
_COUNTER_DIGITS = 3
_POINTER = re.compile(
    r"(?:(?P<db>D[BI][0-9]+)\.)?(?P<area>[A-Z]*) ?(?P<byte>[0-9]+)\.(?P<bit>[0-7])"
    r"(?:\s+(?P<type>[A-Z_]+)\s+(?P<count>[0-9]+))?\Z"
)
_POINTER_AREAS = words("P PE PA PI PQ E A I Q M L V DBX DIX DB DI").union(("",))


def read_literal(text: str) -> LiteralValue:
    """The meaning of one literal token. Raises `BadLiteralError`."""
    first = text[0]
    if first == "'":
        return LiteralValue(LiteralKind.STRING, _string(text, wide=False))
    if first == '"':
        return LiteralValue(LiteralKind.WSTRING, _string(text, wide=True))
    upper = text.upper()
    if upper in ("TRUE", "FALSE"):
        return LiteralValue(LiteralKind.BOOL, upper == "TRUE")
    if "0" <= first <= "9":
        return _number(text, "")
    prefix, _, rest = text.partition("#")
    return _typed(prefix, rest)


def _typed(written: str, rest: str) -> LiteralValue:
    prefix = written.upper()
    if prefix in _DURATIONS:
        return LiteralValue(LiteralKind.DURATION, _duration(rest), _DURATIONS[prefix])
    if prefix in _DATES:
        return LiteralValue(LiteralKind.DATE, _midnight(rest), _DATES[prefix])
    if prefix in _TIMES_OF_DAY:
        return LiteralValue(LiteralKind.TIME_OF_DAY, _clock(rest), _TIMES_OF_DAY[prefix])
    if prefix in _DATES_AND_TIMES:
        return LiteralValue(
            LiteralKind.DATE_AND_TIME, _date_and_time(rest), _DATES_AND_TIMES[prefix]
        )
    if prefix == "P":
        return _pointer(rest)
    if prefix in _STRINGS:
        wide = _STRINGS[prefix]
        if prefix in ("CHAR", "WCHAR") and (_INTEGER.match(rest) or _BASED.match(rest)):
            return LiteralValue(LiteralKind.STRING, _character(rest, wide), prefix)
        kind = LiteralKind.WSTRING if wide else LiteralKind.STRING
        if rest[:1] not in ("'", '"'):
            raise BadLiteralError(f"{prefix}# without quotes", f"write {prefix}#'text'")
        return LiteralValue(kind, _string(rest, wide), prefix)
    if rest.startswith("("):
        return _bytes(prefix, rest)
    if prefix == "C":
        return _count(rest)
    name = _SHORT_TYPES.get(prefix, ALIASES.get(prefix, prefix))
    kind_of_type = ELEMENTARY.get(name)
    if kind_of_type is None:
        if rest.isidentifier():
            return LiteralValue(LiteralKind.ENUMERATOR, rest, written)
        raise BadLiteralError(
            f"'{prefix}#' is not the prefix of a type", "use a type such as WORD#, DINT# or T#"
        )
    if kind_of_type.family is Family.BOOL:
        return _bool(rest)
    if kind_of_type.family is Family.REAL and not _BASED.match(rest):
        return LiteralValue(LiteralKind.REAL, _float(rest), name)
    return _number(rest, name)


def _pointer(rest: str) -> LiteralValue:
    """`M0.0`, `DB1.DBX0.0 BYTE 10`: POINTER, or ANY with type and count; the value is the text."""
    text = " ".join(rest.upper().split())
    match = _POINTER.match(text)
    if match is None or match["area"] not in _POINTER_AREAS:
        raise BadLiteralError(
            f"'{rest}' is not a pointer", "pointers look like P#M0.0 or P#DB1.DBX0.0 BYTE 10"
        )
    text = text.replace(f"{match['area']} {match['byte']}", f"{match['area']}{match['byte']}", 1)
    return LiteralValue(LiteralKind.POINTER, text, "ANY" if match["type"] else "POINTER")


def _bytes(prefix: str, rest: str) -> LiteralValue:
    """`(1, 2)` and `(1, 2, 3, 4)` behind `B#`: a WORD or DWORD from its bytes, highest first."""
    values = [part.strip() for part in rest[1:-1].split(",")]
    if prefix != "B" or len(values) not in (2, 4) or not all(map(_is_byte, values)):
        raise BadLiteralError(
            f"'{prefix}#{rest}' is not a list of bytes", "write B#(1, 2) or B#(1, 2, 3, 4)"
        )
    value = int.from_bytes(bytes(int(part) for part in values), "big")
    return LiteralValue(LiteralKind.INTEGER, value, "WORD" if len(values) == 2 else "DWORD")


def _count(rest: str) -> LiteralValue:
    """`C#100`: the value of a counter, three decimal digits in a WORD."""
    if not (rest.isascii() and rest.isdecimal() and len(rest) <= _COUNTER_DIGITS):
        raise BadLiteralError(f"'{rest}' is no counter value", "counters go from C#0 to C#999")
    return LiteralValue(LiteralKind.INTEGER, int(rest, 16), "WORD", 16)


def _is_byte(text: str) -> bool:
    return text.isdecimal() and len(text) < 4 and int(text) < 256


def _character(text: str, wide: bool) -> str:
    """The character with this code, as in `CHAR#65` and `WCHAR#16#20AC`."""
    code = _number(text, "").value
    if not isinstance(code, int) or not 0 <= code < (0x10000 if wide else 0x100):
        raise BadLiteralError(
            f"there is no character {text}", f"codes go up to {'16#FFFF' if wide else '255'}"
        )
    return chr(code)


def _bool(rest: str) -> LiteralValue:
    value = {"TRUE": True, "1": True, "FALSE": False, "0": False}.get(rest.upper())
    if value is None:
        raise BadLiteralError(f"'{rest}' is not a BOOL", "write BOOL#TRUE or BOOL#FALSE")
    return LiteralValue(LiteralKind.BOOL, value, "BOOL")


def _number(text: str, type_name: str) -> LiteralValue:
    if len(text) > _MAX_DIGITS:
        raise BadLiteralError("the number has too many digits", "no type holds such a number")
    if _INTEGER.match(text):
        return LiteralValue(LiteralKind.INTEGER, int(text), type_name)
    if _REAL.match(text) and not type_name:
        return LiteralValue(LiteralKind.REAL, _float(text))
    if based := _BASED.match(text):
        sign, base, digits = based.groups()
        try:
            value = int(digits, int(base))
        except ValueError:
            raise BadLiteralError(
                f"'{text}' has digits that base {base} does not have",
                "base 2 has 0 and 1, 8 has 0 to 7, 10 has 0 to 9, 16 has 0 to 9 and A to F",
            ) from None
        return LiteralValue(
            LiteralKind.INTEGER, -value if sign == "-" else value, type_name, int(base)
        )
    raise BadLiteralError(
        f"'{text}' is not a number", "numbers look like 100, 1_000, 2.5, 1.0E-3, 16#FF or 2#1010"
    )


def _float(text: str) -> float:
    if not (_REAL.match(text) or _INTEGER.match(text)) or len(text) > _MAX_DIGITS:
        raise BadLiteralError(f"'{text}' is not a number", "write REAL#2.5 or REAL#1.0E-3")
    return float(text.replace("_", ""))


def duration_text(nanoseconds: int) -> str:
    """A duration as a literal of TIME, such as T#1m30s."""
    sign = "-" if nanoseconds < 0 else ""
    rest = abs(nanoseconds)
    parts: list[str] = []
    for unit, size in _UNIT_NS.items():
        count, rest = divmod(rest, size)
        if count:
            parts.append(f"{count}{unit}")
    return f"T#{sign}{''.join(parts) or '0ms'}"


def _duration(text: str) -> int:
    """Nanoseconds of `1d2h3m4s5ms6us7ns`, with a sign and underscores."""
    help_text = "durations look like T#5s, T#1m30s, T#250ms or T#1.5s, larger units first"
    sign = -1 if text.startswith("-") else 1
    position = 1 if text[:1] in ("+", "-") else 0
    total, last_unit = 0, -1
    if position == len(text):
        raise BadLiteralError("a duration without a value", help_text)
    while position < len(text):
        part = _DURATION_PART.match(text, position)
        if part is None:
            raise BadLiteralError(f"'{text}' is not a duration", help_text)
        whole, fraction, unit_text = part.groups()
        unit = _UNITS.index(unit_text.lower())
        if unit <= last_unit or (fraction and part.end() != len(text)):
            raise BadLiteralError(f"the units of '{text}' are out of order", help_text)
        if len(whole) + len(fraction or "") > 40:
            raise BadLiteralError(f"'{text}' is too long for a duration", help_text)
        unit_ns = _UNIT_NS[_UNITS[unit]]
        total += int(whole) * unit_ns
        if fraction:
            total += int(fraction) * unit_ns // 10 ** len(fraction)
        position, last_unit = part.end(), unit
    return sign * total


def _midnight(text: str) -> int:
    """Nanoseconds from 1970-01-01 to the beginning of a day."""
    match = _DATE.match(text)
    if match:
        try:
            day = date(*(int(part) for part in match.groups()))
            return (day - _FIRST_DAY).days * _UNIT_NS["d"]
        except ValueError:
            pass
    raise BadLiteralError(f"'{text}' is not a date", "dates look like D#2024-02-29")


def _clock(text: str) -> int:
    """Nanoseconds since midnight."""
    match = _CLOCK.match(text.replace("_", ""))
    if match:
        hour, minute, second = (int(part or 0) for part in match.groups()[:3])
        if hour < 24 and minute < 60 and second < 60:
            fraction = (match[4] or "").ljust(9, "0")
            return ((hour * 60 + minute) * 60 + second) * 1_000_000_000 + int(fraction)
    raise BadLiteralError(f"'{text}' is not a time of day", "times look like TOD#23:59:59.999")


def _date_and_time(text: str) -> int:
    """Nanoseconds since 1970-01-01."""
    parts = text.split("-")
    if len(parts) != 4:
        raise BadLiteralError(
            f"'{text}' is not a date and time", "they look like DT#2024-02-29-23:59:59"
        )
    if len(parts[0]) == _SHORT_YEAR:
        parts[0] = full_year(parts[0])
    return _midnight("-".join(parts[:3])) + _clock(parts[3])


def full_year(digits: str) -> str:
    """The year that two digits stand for in STEP 7, which knows 1990 to 2089."""
    return f"19{digits}" if digits >= "90" else f"20{digits}"


def _string(text: str, wide: bool) -> str:
    """The characters between the quotes, `$` escapes resolved."""
    body = text[1:-1]
    if "$" not in body:
        return body
    digits = 4 if wide or text[0] == '"' else 2
    result: list[str] = []
    position = 0
    while (dollar := body.find("$", position)) >= 0:
        result.append(body[position:dollar])
        mark = body[dollar + 1 : dollar + 2]
        if broken := _BROKEN.match(body, dollar):
            position = broken.end()
            continue
        code = body[dollar + 1 : dollar + 1 + digits]
        if mark.upper() in _ESCAPED:
            result.append(_ESCAPED[mark.upper()])
            position = dollar + 2
        elif len(code) == digits and all(char in "0123456789abcdefABCDEF" for char in code):
            result.append(chr(int(code, 16)))
            position = dollar + 1 + digits
        else:
            raise BadLiteralError(
                f"'${mark}' is not an escape",
                "escapes are $$ $' $\" $L $N $P $R $T and $ with two hexadecimal digits "
                "(four in a wide string); a dollar sign itself is $$",
            )
    result.append(body[position:])
    return "".join(result)
