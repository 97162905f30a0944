"""Dates outside of their type: what is said about them, in each dialect."""

import pytest

from fbgen.diagnostics import Diagnostic, Severity
from fbgen.lang.checker import check_reporting
from fbgen.lang.parser import parse
from fbgen.source import Source

IEC = ("1970-01-01", "2106-02-07")
S7 = ("1990-01-01", "2169-06-06")


def findings(kind: str, literal: str, dialect: str) -> list[Diagnostic]:
    mark = "#" if dialect == "tia" else ""
    text = (
        f"FUNCTION_BLOCK F VAR_OUTPUT d : {kind}; END_VAR {mark}d := {literal}; END_FUNCTION_BLOCK"
    )
    return list(check_reporting([parse(Source("a.st", text), dialect)], dialect)[1])


@pytest.mark.parametrize(
    ("dialect", "kind", "literal", "ends"),
    [
        ("iec", "DATE", "D#1969-12-31", IEC),
        ("twincat", "DATE", "D#2106-02-08", IEC),
        ("twincat", "DT", "DT#2106-02-07-06:28:16", IEC),
        ("tia", "DATE", "D#1989-12-31", S7),
        ("step7", "DATE", "D#2169-06-07", S7),
        ("tia", "DATE_AND_TIME", "DT#1989-12-31-23:59:59", ("1990-01-01", "2089-12-31")),
        ("step7", "DATE_AND_TIME", "DT#2090-01-01-00:00:00", ("1990-01-01", "2089-12-31")),
    ],
)
def test_a_date_that_does_not_fit_tells_the_first_and_the_last(
    dialect: str, kind: str, literal: str, ends: tuple[str, str]
) -> None:
    (found,) = findings(kind, literal, dialect)
    name = "DATE_AND_TIME" if kind == "DT" else kind
    assert (found.code, found.message) == ("FB4014", f"{literal} is outside of {name}")
    assert f"between {ends[0]} and {ends[1]}" in (found.help or "")


@pytest.mark.parametrize(
    ("dialect", "kind", "literal"),
    [
        ("iec", "DATE", "D#1970-01-01"),
        ("twincat", "DATE", "D#2106-02-07"),
        ("iec", "DT", "DT#2106-02-07-06:28:15"),
        ("twincat", "LDATE", "LDATE#2200-01-01"),
        ("tia", "DATE", "D#1990-01-01"),
        ("step7", "DATE", "D#2169-06-06"),
        ("tia", "DATE_AND_TIME", "DT#2089-12-31-23:59:59.999"),
    ],
)
def test_the_first_and_the_last_date_fit(dialect: str, kind: str, literal: str) -> None:
    assert findings(kind, literal, dialect) == []


def test_the_part_of_a_second_is_lost_where_dates_count_seconds() -> None:
    (found,) = findings("DT", "DT#2024-01-01-12:00:00.5", "twincat")
    assert (found.code, found.severity) == ("FB4105", Severity.WARNING)
    assert findings("DT", "DT#2024-01-01-12:00:00.5", "tia") == []


def test_ldate_is_no_type_of_s7() -> None:
    assert "FB4003" in [one.code for one in findings("LDATE", "LDATE#2024-01-01", "tia")]
