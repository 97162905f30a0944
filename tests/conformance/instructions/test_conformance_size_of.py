"""SIZEOF of CODESYS and TwinCAT.

Expected values: CODESYS help, "SIZEOF" and "Alignment" (each type at a multiple of its size).
"""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import load_program

_TEXT = """
TYPE ST_Data : STRUCT flag : BOOL; number : DINT; half : INT; END_STRUCT; END_TYPE
FUNCTION_BLOCK Sizes
VAR_OUTPUT sizes : ARRAY[0..6] OF UDINT; count : UDINT; END_VAR
VAR words : ARRAY[1..10] OF WORD; data : ST_Data; text : STRING(20); flag : BOOL; END_VAR
sizes[0] := SIZEOF(words);
sizes[1] := SIZEOF(words[1]);
sizes[2] := SIZEOF(data);
sizes[3] := SIZEOF(ST_Data);
sizes[4] := SIZEOF(text);
sizes[5] := SIZEOF(flag);
sizes[6] := SIZEOF(data.number);
count := SIZEOF(words) / SIZEOF(words[1]);
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize("dialect", ["iec", "twincat"])
def test_sizes_are_those_of_a_pc(engine_name: str, dialect: str) -> None:
    text = _TEXT if dialect == "twincat" else _TEXT.replace("STRING(20)", "STRING[20]")
    program = load_program([Source("sizes.st", text)], dialect=dialect, engine=engine_name)
    block = program.instance("Sizes")
    block()
    assert list(block["sizes"]) == [20, 2, 12, 12, 21, 1, 4]
    assert block["count"] == 10


def test_what_has_no_fixed_bytes_has_no_size(engine_name: str) -> None:
    text = """
FUNCTION_BLOCK Sizes
VAR size : UDINT; t : TON; END_VAR
size := SIZEOF(t);
END_FUNCTION_BLOCK
"""
    source = Source("sizes.st", text)
    block = load_program([source], dialect="twincat", engine=engine_name).instance("Sizes")
    with pytest.raises(DiagnosticError) as failure:
        block()
    (found,) = failure.value.diagnostics
    assert (found.code, found.message) == ("FB6072", "SIZEOF of TON cannot run")
