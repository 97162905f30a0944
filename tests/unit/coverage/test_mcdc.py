"""MC/DC: which calls show that a condition decides."""

from collections.abc import Mapping, Sequence

import pytest

from harness.engine.compiled.expressions.decisions import Condition, Join
from harness.engine.interface import Value
from harness.verify.coverage import totals_of
from harness.verify.coverage.masking import shown_by
from harness.verify.coverage.totals import Count
from tests.unit.coverage.programs import decided, missing


def calls(names: str, *rows: str) -> list[Mapping[str, Value]]:
    """`calls("ab", "TF")` is a call with a TRUE and b FALSE."""
    return [dict(zip(names, (one == "T" for one in row), strict=True)) for row in rows]


@pytest.mark.parametrize(
    ("condition", "rows", "reached"),
    [
        ("#a AND #b", ["TT", "TF", "FT"], 2),
        ("#a AND #b", ["TT", "FF"], 0),
        ("#a OR #b", ["FF", "TF", "FT"], 2),
        ("#a XOR #b", ["TF", "FF"], 1),
        ("#a XOR #b", ["TF", "FF", "TT"], 2),
        ("NOT (#a AND NOT #b)", ["TF", "TT", "FF"], 2),
        ("#a = #b", ["TT", "FT", "TF"], 2),
    ],
)
def test_conditions_are_shown_by_pairs(condition: str, rows: Sequence[str], reached: int) -> None:
    block = decided(condition, calls("ab", *rows))
    assert totals_of(block).mcdc == Count(reached, 2)


def test_both_sides_of_and_are_evaluated_and_noted() -> None:
    block = decided("#a AND #b", calls("ab", "FT"))
    assert list(block.vectors[0]) == [0b10]


def test_a_side_that_and_then_leaves_out_masks_nothing() -> None:
    block = decided("a AND_THEN b", calls("ab", "TT", "FF", "TF"), "twincat")
    assert sorted(block.vectors[0]) == [0b0001, 0b0011, 0b1000]
    assert totals_of(block).mcdc == Count(2, 2)


def test_other_conditions_may_differ_where_they_are_masked() -> None:
    tree = Join(
        "OR", Join("AND", Condition(0), Condition(1)), Join("AND", Condition(2), Condition(3))
    )
    pair = shown_by(tree, 0, 4, [0b0011, 0b1010])
    assert pair is not None
    assert not pair.unique


def test_a_pair_without_any_other_difference_is_preferred() -> None:
    tree = Join("OR", Condition(0), Join("AND", Condition(1), Condition(2)))
    pair = shown_by(tree, 0, 3, [0b001, 0b010, 0b000])
    assert pair == (0b001, 0b000, True)


@pytest.mark.parametrize(
    ("condition", "excluded"),
    [
        ("#a AND #b OR #a AND #c", []),
        ("#a OR #a AND #b", ["#a", "#b"]),
        ("#x > 5 OR #x > 3", ["#x > 5"]),
        ("#x >= 3 AND #x <= 5", []),
        ("#x = 1 OR #x = 2", []),
        ("#a AND NOT #a OR #b", ["#a", "#a"]),
        ("#a AND (#b OR TRUE) AND #c", ["#b"]),
    ],
)
def test_a_condition_that_can_never_decide_is_excluded(
    condition: str, excluded: Sequence[str]
) -> None:
    block = decided(condition, [{}])
    (place,) = block.places.decisions
    assert [one.text for one in place.conditions if one.excluded] == excluded


def test_what_is_missing_is_said() -> None:
    block = decided("#a AND #b", calls("ab", "TT", "TF"))
    assert missing(block) == [("mcdc", 5, "#a: never FALSE where it decides")]
    block = decided("#a AND #b", calls("ab", "FF"))
    assert missing(block)[0] == ("mcdc", 5, "#a: the other conditions have always decided")


def test_decisions_in_arguments_count() -> None:
    block = decided("SEL(G := #a OR #b, IN0 := #c, IN1 := #d)", calls("ab", "TF", "FT", "FF"))
    assert totals_of(block).mcdc == Count(2, 2)
