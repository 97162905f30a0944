"""Source lines in messages: cut, aligned, and nothing in them that a terminal obeys."""

import pytest

from fbgen.diagnostics import Diagnostic, Note, render
from fbgen.source import Source, Span


def lines(text: str, start: int, end: int) -> list[str]:
    span = Span(Source("pump.scl", text), start, end)
    return render(Diagnostic("FB3001", "found this", span)).splitlines()


def test_a_short_line_is_shown_whole() -> None:
    text = "a := b;"
    assert lines(text, 5, 6)[-2:] == ["1 | a := b;", "  |      ^"]


def test_of_a_long_line_the_part_around_the_place_is_shown() -> None:
    text = "x" * 50_000 + "HERE" + "y" * 50_000
    shown, carets = lines(text, 50_000, 50_004)[-2:]
    assert len(shown) < 250
    assert (shown.split(" | ")[1][:3], shown[-3:]) == ("...", "...")
    assert shown[carets.index("^") : carets.rindex("^") + 1] == "HERE"


@pytest.mark.parametrize("start", [0, 1, 80, 81, 49_999])
def test_the_place_is_shown_wherever_it_is_in_a_long_line(start: int) -> None:
    text = "x" * start + "!" + "x" * (49_999 - start)
    shown, carets = lines(text, start, start + 1)[-2:]
    assert shown[carets.index("^")] == "!"
    assert carets.count("^") == 1


def test_a_place_longer_than_what_is_shown_has_no_more_carets_than_that() -> None:
    shown, carets = lines("x" * 10_000, 10, 9_000)[-2:]
    assert len(carets) <= len(shown)


@pytest.mark.parametrize("harmful", ["\x1b[2J", "\x07", "\x00", "\x9b31m", "\u202e", "\u2066"])
def test_nothing_reaches_the_terminal_that_it_would_obey(harmful: str) -> None:
    text = f"a := '{harmful}';"
    span = Span(Source(f"{harmful}.scl", text), 0, 1)
    found = Diagnostic("FB3001", f"found {harmful}", span, harmful, (Note(harmful, span),))
    assert harmful[0] not in render(found)


def test_tabs_and_wide_characters_keep_the_carets_below_the_place() -> None:
    assert lines("\tb;", 1, 2)[-1] == "  | \t^"
    assert lines("'変数' + b", 7, 8)[-1] == "  |          ^"
    assert lines("変数 := 1", 0, 2)[-1] == "  | ^^^^"
    assert lines("e\u0301 := 1", 3, 5)[-1] == "  |   ^^"


def test_a_message_of_several_lines_keeps_them() -> None:
    assert render(Diagnostic("FB6002", "one\ntwo")) == "error[FB6002]: one\ntwo"
