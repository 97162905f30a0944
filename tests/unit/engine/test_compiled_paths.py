"""A structure inside of another one is read into a local once where it is used often."""

import pytest

from fbgen.source import Source
from harness.engine.compiled import CompiledEngine
from harness.engine.environment import StandaloneEnvironment
from harness.engine.loading import read_program

BLOCK = """
TYPE "typePart" STRUCT a : INT; b : INT; END_STRUCT; END_TYPE
TYPE "typeInner" STRUCT part : "typePart"; n : INT; END_STRUCT; END_TYPE
TYPE "typeOuter" STRUCT inner : "typeInner"; part : "typePart"; END_STRUCT; END_TYPE
FUNCTION_BLOCK "Block"
VAR_IN_OUT given : "typeOuter"; END_VAR
VAR own : "typeOuter"; part : INT; i : INT; END_VAR
BEGIN
{}
END_FUNCTION_BLOCK
"""
FOUR = "#own.part.a := 1; #own.part.b := #own.part.a; #i := #own.part.b;"


def source_of(statements):
    program = read_program([Source("main.scl", BLOCK.format(statements))])
    text = CompiledEngine(program, StandaloneEnvironment()).python_source("Block")
    return text.partition("def _run(self):")[2]


def test_the_local_is_called_like_the_field_and_used_from_there_on():
    text = source_of(FOUR)
    assert "part = own.part\n" in text
    assert "part.a = 1" in text
    assert text.count("own.part") == 1


def test_a_variable_of_the_same_name_is_another_local():
    text = source_of(FOUR + "#part := #i; #part := #part + #i; #i := #part;")
    assert "part_2" in text


@pytest.mark.parametrize(
    ("statements", "local"),
    [
        ("#own.part.a := 1; #own.part.b := 2;", ""),
        ("IF #i > 0 THEN " + FOUR * 3 + " END_IF;", "        part = own.part"),
        (FOUR.replace("own.part", "own.inner.part"), "part = own.inner.part"),
        (FOUR.replace("own.part", "given.part"), "part = given.part"),
        (
            FOUR.replace("own.part", "own.inner.part") + "#own.inner.n := 1; " * 4,
            "part = inner.part",
        ),
    ],
)
def test_only_what_pays_is_kept(statements, local):
    text = source_of(statements)
    if local:
        assert f"{local}\n" in text
    else:
        assert "part = own" not in text


def test_what_is_assigned_as_a_whole_is_seen_through_the_local():
    statements = FOUR + "#own.part := #own.inner.part; #i := #own.part.a;"
    program = read_program([Source("main.scl", BLOCK.format(statements))])
    instance = CompiledEngine(program, StandaloneEnvironment()).instance("Block")
    instance.set("own.inner.part.a", 7)
    instance.call({})
    assert instance.get("i") == 7
