"""A temporary variable gets a value at the start of a call only if something could read it."""

import pytest

from fbgen.source import Source
from harness.engine.compiled import CompiledEngine
from harness.engine.environment import StandaloneEnvironment
from harness.engine.loading import read_program

BLOCK = """
FUNCTION_BLOCK "Block"
VAR_INPUT a : INT; END_VAR
VAR b : INT; END_VAR
VAR_TEMP t : INT; END_VAR
BEGIN
{}
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(
    ("statements", "starts"),
    [
        ("#t := #a; #b := #t;", False),
        ("#b := #t; #t := #a;", True),
        ("#t := #t + 1; #b := #t;", True),
        ("IF #a > 0 THEN #t := 1; ELSE #t := 2; END_IF; #b := #t;", False),
        ("IF #a > 0 THEN #t := 1; END_IF; #b := #t;", True),
        ("IF #a > 0 THEN #t := 1; ELSIF #t > 1 THEN #t := 2; ELSE #t := 3; END_IF;", True),
        ("IF #a > 0 THEN #t := 1; #b := #t; END_IF;", False),
        ("CASE #a OF 1: #t := 1; ELSE #t := 2; END_CASE; #b := #t;", False),
        ("CASE #a OF 1: #t := 1; 2: ; ELSE #t := 2; END_CASE; #b := #t;", True),
        ("WHILE #b < #a DO #t := 1; #b := #b + #t; END_WHILE;", False),
        ("WHILE #b < #a DO #t := 1; #b := #b + 1; END_WHILE; #b := #t;", True),
        ("REPEAT #t := 1; #b := #b + 1; UNTIL #b + #t > 3 END_REPEAT;", True),
        ("FOR #t := 1 TO 3 DO #b := #b + #t; END_FOR;", True),
    ],
)
def test_a_start_value_is_there_if_it_can_be_read(statements, starts):
    program = read_program([Source("main.scl", BLOCK.format(statements))])
    engine = CompiledEngine(program, StandaloneEnvironment())
    text = engine.python_source("Block").partition("def _run(self):")[2]
    assert text.lstrip().startswith("t = 0") == starts
    instance = engine.instance("Block")
    for value in (0, 1, 2):
        instance.call({"a": value})
