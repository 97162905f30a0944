"""`fbgen test -k EXPR`: which scenarios an expression chooses, and what is no expression."""

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.scenario.selection import parse_selection

NAMES = ("A drive starts at its set-point [doc9]", "scenarios/start.scenario.yaml", "sequences")


@pytest.mark.parametrize(
    ("expression", "chosen"),
    [
        ("", True),
        ("   ", True),
        ("start", True),
        ("START", True),
        ("reverse", False),
        ("sequences", True),
        ("doc9", True),
        ("set-point", True),
        ("start.scenario", True),
        ("scenarios/start", True),
        ("not start", False),
        ("not reverse", True),
        ("not not start", True),
        ("start and not reverse", True),
        ("start and reverse", False),
        ("start or reverse", True),
        ("reverse or reset or doc9", True),
        ("reverse and doc9 or start", True),
        ("reverse and (doc9 or start)", False),
        ("start and (reverse or doc9) and not (stop)", True),
        ("((start))", True),
        ("(start)and(doc9)", True),
        ('"drive starts"', True),
        ("'drive stops'", False),
        ('"[doc9]"', True),
        ('"and"', False),
        ("drive starts".replace(" ", " and "), True),
    ],
)
def test_an_expression_chooses_by_title_file_variation_and_tags(
    expression: str, chosen: bool
) -> None:
    assert parse_selection(expression)(NAMES) is chosen


@pytest.mark.parametrize(
    ("expression", "column", "text"),
    [
        ("and", 1, "found 'and' where a word belongs"),
        ("start and", 10, "the expression ends where a word belongs"),
        ("start  reverse", 8, "found 'reverse' where 'and' or 'or' belongs"),
        ("start)", 6, "found ')' where 'and' or 'or' belongs"),
        ("(start", 7, "a parenthesis is not closed"),
        ("()", 2, "found ')' where a word belongs"),
        ("not", 4, "the expression ends where a word belongs"),
        ("start or or reverse", 10, "found 'or' where a word belongs"),
        ('start and "rev', 11, "a quote is not closed"),
        ("(" * 60 + "a" + ")" * 60, 51, "more than 50 parentheses inside each other"),
    ],
)
def test_what_is_no_expression_is_marked(expression: str, column: int, text: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        parse_selection(expression)
    (found,) = failure.value.diagnostics
    assert (found.code, found.message) == ("FB8011", text)
    assert found.span is not None
    assert (found.span.source.name, found.span.column) == ("-k", column)


def test_a_long_expression_is_no_trouble() -> None:
    assert parse_selection("not " * 10_001 + "reverse")(NAMES)
    assert parse_selection(" or ".join(["reverse"] * 10_000 + ["start"]))(NAMES)
