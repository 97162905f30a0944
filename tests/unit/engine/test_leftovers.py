"""Temporary variables that hold anything before they are written, as the local data of an S7."""

import pytest

from fbgen.lang.checked import VariableKind
from fbgen.source import Source
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.loading import ENGINES, engine_named, load_program, read_program

BLOCK = """
TYPE "Pair"
STRUCT
    low : INT;
    high : INT;
END_STRUCT;
END_TYPE
FUNCTION_BLOCK "Block"
VAR_OUTPUT
    flag : BOOL;
    number : INT;
    word : WORD;
    real : REAL;
    time : TIME;
    text : STRING[8];
    pair : "Pair";
    row : ARRAY[1..4] OF BYTE;
    written : INT;
    given : DWORD;
END_VAR
VAR_TEMP
    tFlag : BOOL;
    tNumber : INT;
    tWord : WORD;
    tReal : REAL;
    tTime : TIME;
    tText : STRING[8];
    tPair : "Pair";
    tRow : ARRAY[1..4] OF BYTE;
    tWritten : INT;
END_VAR
BEGIN
    tWritten := 5;
    flag := tFlag;
    number := tNumber;
    word := tWord;
    real := tReal;
    time := tTime;
    text := tText;
    pair := tPair;
    row := tRow;
    written := tWritten;
    given := "Given"();
END_FUNCTION_BLOCK
FUNCTION "Given" : DWORD
BEGIN
    ;
END_FUNCTION
"""
OVERLAID = """
FUNCTION_BLOCK "Block"
VAR_OUTPUT number : DWORD; high : BYTE; END_VAR
VAR_TEMP
    whole : DWORD;
    parts AT whole : ARRAY[0..3] OF BYTE;
END_VAR
BEGIN
    number := whole;
    high := parts[0];
END_FUNCTION_BLOCK
"""
ERROR_BLOCK = """
DATA_BLOCK "D"
STRUCT
    class : BYTE;
    last : BYTE;
    own : DWORD;
END_STRUCT;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB86
VAR_TEMP
    told : ARRAY[0..19] OF BYTE;
    own : DWORD;
END_VAR
BEGIN
    D.class := told[0];
    D.last := told[19];
    D.own := own;
END_ORGANIZATION_BLOCK
"""
IEC = """
FUNCTION_BLOCK Block
VAR_OUTPUT number : INT; END_VAR
VAR_TEMP tNumber : INT; END_VAR
    number := tNumber;
END_FUNCTION_BLOCK
"""
CYCLES = 12


def called(engine="compiled", seed=None, dialect="tia", text=BLOCK):
    """What the outputs of the block hold in each of some cycles."""
    program = load_program([Source("main.scl", text)], dialect, engine, leftovers=seed)
    block = program.engine.instance("Block")
    outputs = [one for one in block.block.variables if one.kind is VariableKind.OUTPUT]
    seen = []
    for _ in range(CYCLES):
        block.call({})
        seen.append({one.name: repr(block.get(one.name)) for one in outputs})
        program.clock.advance(ms=10)
    return seen


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_what_is_read_unwritten_is_another_value_in_each_cycle(engine):
    seen = called(engine, 1)
    for name in set(seen[0]) - {"flag", "written"}:
        assert len({one[name] for one in seen}) == CYCLES, name
    assert {one["flag"] for one in seen} == {"True", "False"}


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_what_is_written_first_holds_what_was_written(engine):
    assert {one["written"] for one in called(engine, 1)} == {"5"}


@pytest.mark.parametrize("text", [BLOCK, OVERLAID])
@pytest.mark.parametrize("dialect", ["tia", "step7"])
def test_both_engines_find_the_same(dialect, text):
    assert called("compiled", 3, dialect, text) == called("reference", 3, dialect, text)


def test_an_overlay_shows_the_bytes_that_are_left():
    for one in called(seed=1, text=OVERLAID):
        assert int(one["number"]) >> 24 == int(one["high"])


def test_the_seed_decides_what_is_left():
    assert called(seed=1) == called(seed=1)
    assert called(seed=1) != called(seed=2)


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_without_a_seed_temporaries_begin_with_their_defaults(engine):
    (seen,) = {tuple(sorted(one.items())) for one in called(engine)}
    assert dict(seen)["number"] == "0"


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_elsewhere_they_begin_with_their_defaults_in_any_case(engine):
    assert {one["number"] for one in called(engine, 1, "iec", IEC)} == {"0"}


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_start_information_is_not_left_over(engine):
    program = read_program([Source("ob.scl", ERROR_BLOCK)], "step7")
    environment = StandaloneEnvironment()
    environment.services.leftovers = 1
    loaded = engine_named(engine)(program, environment, Limits())
    loaded.run_block("OB86", bytes(range(20)))
    assert loaded.global_value("D.class") == 0
    assert loaded.global_value("D.last") == 19
    assert loaded.global_value("D.own") != 0
    loaded.run_block("OB86")
    assert loaded.global_value("D.last") == 0


def test_one_program_runs_with_and_without_beside_each_other():
    program = read_program([Source("main.scl", BLOCK)])
    seen = []
    for seed in (None, 1, None, 2):
        environment = StandaloneEnvironment()
        environment.services.leftovers = seed
        block = engine_named("compiled")(program, environment, Limits()).instance("Block")
        block.call({})
        seen.append(block.get("given"))
    assert seen[0] == seen[2] == 0
    assert len(set(seen)) == 3
