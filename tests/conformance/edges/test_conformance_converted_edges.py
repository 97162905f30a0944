"""F_TRIG does after a conversion what it did before, also in its first call.

Expected values: IEC 61131-3 third edition, table 44; TIA Portal help, "F_TRIG".
"""

import pytest

from fbgen.lang.conversion import convert
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import Source
from harness import load_program

_SIGNAL = [False, True, False, False, True, False]
_S7 = """FUNCTION_BLOCK "Edge"
VAR_INPUT go : Bool; END_VAR
VAR_OUTPUT fell : Bool; END_VAR
VAR f : F_TRIG; END_VAR
BEGIN
  #f(CLK := #go);
  #fell := #f.Q;
END_FUNCTION_BLOCK
"""
_IEC = """FUNCTION_BLOCK Edge
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT fell : BOOL; END_VAR
VAR f : ARRAY[0..1] OF F_TRIG; END_VAR
f[1](CLK := go, Q => fell);
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(
    ("text", "source", "target"),
    [
        (_S7, "tia", "iec"),
        (_S7, "tia", "twincat"),
        (_IEC, "iec", "tia"),
        (_IEC, "iec", "step7"),
        (_IEC, "twincat", "tia"),
        (_IEC, "iec", "twincat"),
    ],
)
def test_falling_edges_stay_what_they_were(
    text: str, source: str, target: str, engine_name: str
) -> None:
    fell = []
    converted = convert([parse(Source("edge.txt", text), source)], target)
    after = [Source("converted.txt", print_file(one).text) for one in converted]
    for sources, dialect in (([Source("edge.txt", text)], source), (after, target)):
        block = load_program(sources, dialect=dialect, engine=engine_name).instance("Edge")
        seen = []
        for go in _SIGNAL:
            block(go=go)
            seen.append(block.fell)
        fell.append(seen)
    assert fell[0] == fell[1]
    assert fell[0] == [source != "tia", False, True, False, False, True]


def test_a_block_of_that_name_is_the_users_own() -> None:
    text = """FUNCTION_BLOCK F_TRIG
VAR_INPUT CLK : BOOL; END_VAR
CLK := CLK;
END_FUNCTION_BLOCK
FUNCTION_BLOCK Edge
VAR f : F_TRIG; END_VAR
f(CLK := TRUE);
END_FUNCTION_BLOCK
"""
    (file,) = convert([parse(Source("edge.st", text), "iec")], "tia")
    assert "F_TRIG_IEC" not in print_file(file).text


def test_the_name_of_the_block_gives_way() -> None:
    text = _S7 + 'FUNCTION_BLOCK "F_TRIG_S7"\nVAR x : Int; END_VAR\nBEGIN\n;\nEND_FUNCTION_BLOCK\n'
    (file,) = convert([parse(Source("edge.scl", text), "tia")], "iec")
    assert "f : F_TRIG_S7_2;" in print_file(file).text
