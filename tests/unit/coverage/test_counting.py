"""Statements and branches: what counts as reached, and what cannot be."""

import pytest

from fbgen.source import Source
from harness import load_program
from harness.verify.coverage import Coverage, totals_of
from harness.verify.coverage.totals import Count
from tests.unit.coverage.programs import belt, decided, missing, run_of

ALL_CALLS = (
    {"start": True, "ready": True, "speed": 3},
    {"stop": True, "speed": 20},
    {"speed": 0},
    *({"speed": 20} for _ in range(50)),
)


def test_what_was_not_reached_is_named_with_its_line() -> None:
    (block,) = belt({"start": True, "ready": True, "speed": 3}).blocks()
    found = [one for one in missing(block) if one[0] != "mcdc"]
    assert found == [
        ("branch", 6, "never: ELSE"),
        ("branch", 8, "never: ELSIF is TRUE"),
        ("statement", 9, "never run"),
        ("branch", 12, "never: CASE 0"),
        ("statement", 12, "never run"),
        ("statement", 15, "never run"),
        ("branch", 15, "never: no CASE"),
        ("branch", 17, "never: the loop is not entered"),
        ("branch", 19, "never: IF is TRUE"),
        ("statement", 19, "never run"),
    ]


def test_everything_is_reached_by_enough_calls() -> None:
    (block,) = belt(*ALL_CALLS).blocks()
    totals = totals_of(block)
    assert totals.statement == Count(13, 13)
    assert totals.branch == Count(12, 12)


def test_hits_are_counted() -> None:
    (block,) = belt(*ALL_CALLS).blocks()
    hits = {place.line: count for place, count in block.statements() if place.line < 10}
    assert hits == {6: 53, 7: 1, 9: 1}


def test_instances_of_a_block_count_together() -> None:
    coverage = Coverage()
    text = """
FUNCTION_BLOCK "Inner" VAR_INPUT up : BOOL; END_VAR VAR n : INT; END_VAR BEGIN
  IF #up THEN #n := 1; ELSE #n := 2; END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK "Belt" VAR one : "Inner"; two : "Inner"; END_VAR BEGIN
  #one(up := TRUE); #two(up := FALSE);
END_FUNCTION_BLOCK
"""
    load_program([Source("two.scl", text)], probes=[coverage]).instance("Belt")()
    inner = next(block for block in coverage.blocks() if block.places.name == "Inner")
    assert totals_of(inner).branch == Count(2, 2)


def test_programs_of_the_same_text_count_together() -> None:
    coverage = belt({"stop": True})
    belt({"start": True, "ready": True}, coverage=coverage)
    (block,) = coverage.blocks()
    assert [hits for place, hits in block.statements() if place.line in (7, 9)] == [1, 1]


@pytest.mark.parametrize(
    ("statement", "excluded"),
    [
        ("IF TRUE THEN #q := 1; END_IF;", {"ELSE": "the condition is a constant"}),
        (
            "FOR #q := 1 TO 3 DO #n := #q; END_FOR;",
            {"the loop is not entered": "the bounds are constants"},
        ),
        (
            "WHILE FALSE DO #q := 1; END_WHILE;",
            {"the loop is entered": "the condition is a constant"},
        ),
    ],
)
def test_what_constants_rule_out_does_not_count(statement: str, excluded: dict[str, str]) -> None:
    text = (
        f'FUNCTION_BLOCK "Belt" VAR q : INT; n : INT; END_VAR BEGIN\n{statement}\n'
        "END_FUNCTION_BLOCK\n"
    )
    (block,) = run_of(text, [{}]).blocks()
    (branching,) = block.places.branchings
    assert {one.name: one.excluded for one in branching.outcomes if one.excluded} == excluded
    assert totals_of(block).branch.percent == 100


def test_loops_that_are_taken_apart_by_jumps_are_counted() -> None:
    text = """
FUNCTION_BLOCK "Belt" VAR_INPUT n : INT; END_VAR VAR i : INT; END_VAR BEGIN
  WHILE #i < #n DO
    #i := #i + 1;
    IF #i = 2 THEN GOTO over; END_IF;
  over:
    #i := #i + 1;
  END_WHILE;
END_FUNCTION_BLOCK
"""
    (block,) = run_of(text, [{"n": 0}, {"n": 3}]).blocks()
    found = {
        outcome.name: hits
        for branching, taken in block.branchings()
        for outcome, hits in zip(branching.outcomes, taken, strict=True)
    }
    assert (found["the loop is entered"], found["the loop is not entered"]) == (2, 1)


def test_text_inside_of_xml_is_found_where_it_stands_there() -> None:
    text = """<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject>
  <POU Name="Belt">
    <Declaration><![CDATA[FUNCTION_BLOCK Belt
VAR_INPUT up : BOOL; END_VAR
VAR n : INT; END_VAR]]></Declaration>
    <Implementation><ST><![CDATA[IF up THEN
  n := 1;
END_IF]]></ST></Implementation>
  </POU>
</TcPlcObject>
"""
    coverage = Coverage()
    program = load_program([Source("Belt.TcPOU", text)], "twincat", probes=[coverage])
    program.instance("Belt")()
    (block,) = coverage.blocks()
    assert block.file.text == text
    assert [(place.line, hits) for place, hits in block.statements()] == [(7, 1), (8, 0)]
    assert "  n := 1;" in block.lines


def test_a_block_without_statements_has_nothing_to_reach() -> None:
    block = decided("#a", [{}])
    assert totals_of(block).mcdc == Count(0, 0)
