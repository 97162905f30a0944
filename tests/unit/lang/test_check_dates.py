"""Dates outside of DATE: what is said about them."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checker import check
from fbgen.lang.parser import parse
from fbgen.source import Source

TEXT = "PROGRAM p VAR d : DATE; END_VAR d := {date}; END_PROGRAM"


@pytest.mark.parametrize("date", ["D#1970-01-01", "D#1989-12-31", "D#2169-06-07"])
def test_a_date_that_does_not_fit_tells_the_first_and_the_last(date: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        check([parse(Source("a.st", TEXT.format(date=date)), "iec")], "iec")
    (found,) = failure.value.diagnostics
    assert (found.code, found.message) == ("FB4014", f"{date} is outside of DATE")
    assert "1990-01-01 and 2169-06-06" in (found.help or "")


@pytest.mark.parametrize("date", ["D#1990-01-01", "D#2169-06-06"])
def test_the_first_and_the_last_date_fit(date: str) -> None:
    check([parse(Source("a.st", TEXT.format(date=date)), "iec")], "iec")
