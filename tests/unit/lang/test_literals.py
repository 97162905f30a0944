"""What literals mean."""

import pytest

from fbgen.lang.ast import LiteralKind
from fbgen.lang.literals import BadLiteralError, read_literal

_MS = 1_000_000
_S = 1_000 * _MS
_H = 3_600 * _S


@pytest.mark.parametrize(
    ("text", "value", "type_name", "base"),
    [
        ("0", 0, "", 10),
        ("1_000", 1000, "", 10),
        ("16#FF_ff", 0xFFFF, "", 16),
        ("2#1010", 10, "", 2),
        ("8#17", 15, "", 8),
        ("WORD#16#00FF", 255, "WORD", 16),
        ("W#16#F", 15, "WORD", 16),
        ("B#16#F", 15, "BYTE", 16),
        ("DW#16#F", 15, "DWORD", 16),
        ("L#5", 5, "DINT", 10),
        ("int#-5", -5, "INT", 10),
        ("BYTE#5", 5, "BYTE", 10),
    ],
)
def test_whole_numbers(text: str, value: int, type_name: str, base: int) -> None:
    literal = read_literal(text)
    assert literal.kind is LiteralKind.INTEGER
    assert (literal.value, literal.type_name, literal.base) == (value, type_name, base)


@pytest.mark.parametrize(
    ("text", "value", "type_name"),
    [
        ("1.5", 1.5, ""),
        ("1.5E-3", 0.0015, ""),
        ("3E10", 3e10, ""),
        ("1_0.2_5", 10.25, ""),
        ("REAL#-2.5", -2.5, "REAL"),
        ("LREAL#2", 2.0, "LREAL"),
        ("REAL#1E-3", 0.001, "REAL"),
    ],
)
def test_real_numbers(text: str, value: float, type_name: str) -> None:
    literal = read_literal(text)
    assert (literal.kind, literal.value, literal.type_name) == (LiteralKind.REAL, value, type_name)


@pytest.mark.parametrize(
    ("text", "value", "type_name"),
    [
        ("T#5s", 5 * _S, "TIME"),
        ("t#1D_2h3M4s5ms", 26 * _H + 184 * _S + 5 * _MS, "TIME"),
        ("TIME#-1.5s", -1500 * _MS, "TIME"),
        ("T#90m", 5400 * _S, "TIME"),
        ("LT#1us2ns", 1002, "LTIME"),
        ("S5T#2S_500MS", 2500 * _MS, "S5TIME"),
    ],
)
def test_durations_are_nanoseconds(text: str, value: int, type_name: str) -> None:
    literal = read_literal(text)
    assert (literal.kind, literal.value) == (LiteralKind.DURATION, value)
    assert literal.type_name == type_name


@pytest.mark.parametrize(
    ("text", "kind", "value", "type_name"),
    [
        ("D#1970-01-02", LiteralKind.DATE, 86_400_000_000_000, "DATE"),
        ("DATE#1969-12-31", LiteralKind.DATE, -86_400_000_000_000, "DATE"),
        ("TOD#01:00:00.5", LiteralKind.TIME_OF_DAY, _H + 500 * _MS, "TIME_OF_DAY"),
        ("LTOD#00:00:01", LiteralKind.TIME_OF_DAY, _S, "LTIME_OF_DAY"),
        ("DT#1970-01-01-00:00:01", LiteralKind.DATE_AND_TIME, _S, "DATE_AND_TIME"),
        ("LDT#1970-01-02-00:00:00", LiteralKind.DATE_AND_TIME, 24 * _H, "LDT"),
        ("DTL#1970-01-01-01:00:00", LiteralKind.DATE_AND_TIME, _H, "DTL"),
    ],
)
def test_dates_and_times(text: str, kind: LiteralKind, value: int, type_name: str) -> None:
    literal = read_literal(text)
    assert (literal.kind, literal.value, literal.type_name) == (kind, value, type_name)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("''", ""),
        ("'it$'s $$5$L'", "it's $5\n"),
        ("'$41$0d'", "A\r"),
        ("STRING#'x'", "x"),
        ('"$0041$""', 'A"'),
        ("WSTRING#'$20AC'", "€"),
    ],
)
def test_strings_without_quotes_and_escapes(text: str, value: str) -> None:
    assert read_literal(text).value == value


def test_bool_with_a_prefix() -> None:
    assert read_literal("BOOL#1").value is True
    assert read_literal("false").value is False


@pytest.mark.parametrize(
    "text",
    [
        "12ab",
        "1__0",
        "1_",
        "2#12",
        "8#9",
        "16#",
        "7#1",
        "1.5.2",
        "T#",
        "T#5",
        "T#5x",
        "T#5s1m",
        "T#1.5m3s",
        "D#2024-02-30",
        "D#24",
        "TOD#24:00:00",
        "DT#2024-01-01",
        "BOOL#2",
        "REAL#x",
        "'$'",
        "'$q'",
        "Color#2Red",
        "STRING#5",
        "9" * 5000,
    ],
)
def test_what_is_no_literal_says_how_to_write_it(text: str) -> None:
    with pytest.raises(BadLiteralError) as problem:
        read_literal(text)
    assert problem.value.help
