"""A program with what it was translated to goes through the cache's bytes, whatever is in it."""

from fbgen.cache.objects import packed_objects, unpacked_objects
from fbgen.source import Source
from harness.engine.compiled import CompiledEngine, translation
from harness.engine.environment import StandaloneEnvironment
from harness.engine.loading import read_program
from harness.kernel import Kernel

TEXT = """
ORGANIZATION_BLOCK "OB86"
VAR_TEMP
  OB86_EV_CLASS : BYTE;
  OB86_FLT_ID : BYTE;
  rest : ARRAY[0..17] OF BYTE;
END_VAR
BEGIN
  "Noted".class := #OB86_EV_CLASS;
END_ORGANIZATION_BLOCK

DATA_BLOCK "Noted"
STRUCT
  class : BYTE;
END_STRUCT;
BEGIN
END_DATA_BLOCK

FUNCTION_BLOCK "Chosen"
VAR_INPUT code : DINT; END_VAR
VAR_OUTPUT arm : INT; END_VAR
BEGIN
  CASE #code OF
    0..20000: #arm := 1;
    20001: #arm := 2;
    20002: #arm := 3;
    20003: #arm := 4;
    20004: #arm := 5;
    20005: #arm := 6;
    20006: #arm := 7;
    20007: #arm := 8;
    20010..30000: #arm := 9;
    ELSE #arm := 0;
  END_CASE;
END_FUNCTION_BLOCK
"""


def test_start_information_and_wide_arms_run_in_the_process_that_takes_them() -> None:
    program = read_program([Source("unit.scl", TEXT)])
    CompiledEngine(program, StandaloneEnvironment(Kernel()))
    content = packed_objects((program, translation.shared(program)))
    assert content is not None
    again, known = unpacked_objects(content)
    assert known
    translation.share(again, known)
    chosen = CompiledEngine(again, StandaloneEnvironment(Kernel())).instance("Chosen")
    chosen.call({"code": 25_000})
    assert chosen.get("arm") == 9
