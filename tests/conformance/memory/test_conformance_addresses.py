"""Absolute addresses, PEEK and POKE reach the same memory as the names do.

Sources: TIA Portal help, "Addressing operands in global data blocks", "PEEK", "POKE", "POKE_BOOL";
STEP 7 help, "Instance data block": inputs, outputs, in-outs and statics one behind the other, each
section from an even byte on, a structured in-out as a pointer of six bytes.
"""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program

INPUTS, OUTPUTS, MARKERS, BLOCK = 0x81, 0x82, 0x83, 0x84


@pytest.fixture
def program(engine_name: str) -> LoadedProgram:
    path = Path(__file__).with_name("addresses.scl")
    return load_program([path], engine=engine_name, db_numbers={"counting": 7})


def test_addresses_in_a_data_block_follow_its_declaration(program: LoadedProgram) -> None:
    outputs = program.call_with_outputs("Addressed").outputs
    assert outputs == {"bit": False, "byte": 0x12, "word": 0xFFFE, "double": 0x3F800000}
    assert program.globals.DB100.fault is True
    assert program.globals.DB100.table == [0xABCD, 0, 0, 0]


def test_words_and_bytes_of_bit_memory_overlap(program: LoadedProgram) -> None:
    program.run("Count")
    program.call("Addressed")
    assert program.call("Peeked", area=MARKERS, offset=10) == 0x1234
    assert program.call("Peeked", area=MARKERS, offset=11) == 0x3400
    assert program.call("Peeked", area=OUTPUTS, offset=3) == 0x3400
    assert program.call("Peeked", area=INPUTS, offset=3) == 0


def test_peek_reads_across_members(program: LoadedProgram) -> None:
    assert program.call("Peeked", area=BLOCK, db=100, offset=1) == 0x12FF
    assert program.call("Peeked", area=BLOCK, db=100, offset=5) == 0x0203


def test_poke_writes_what_names_read(program: LoadedProgram) -> None:
    assert program.call("Poked", area=BLOCK, db=100, offset=2, bit=0) is True
    assert program.globals.DB100.speed == 0x0102
    assert program.globals.DB100.position == 0x03800304


def test_names_write_what_peek_reads(program: LoadedProgram) -> None:
    program.globals.DB100.load = -1.0
    assert program.call("Peeked", area=BLOCK, db=100, offset=8) == 0xBF80


def test_an_instance_data_block_has_its_sections_one_behind_the_other(
    program: LoadedProgram,
) -> None:
    program.run("Count")
    assert program.call("Peeked", area=BLOCK, db=7, offset=0) == 3
    program.run("Count")
    assert program.call("Peeked", area=BLOCK, db=7, offset=2) == 0x0100
    assert program.call("Peeked", area=BLOCK, db=7, offset=4) == 6
    assert program.call("Peeked", area=BLOCK, db=7, offset=28) == 0x0100
    program.call("Poked", area=BLOCK, db=7, offset=4, bit=3)
    assert program.globals.counting.count == 0x0902


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"area": BLOCK, "db": 100, "offset": 19}, "FB6010.*%DB100.DBW19 lies outside.* 20 bytes"),
        ({"area": BLOCK, "db": 100, "offset": -1}, "FB6010.*%DB100.DBW-1"),
        ({"area": MARKERS, "offset": 70000}, "FB6010.*%MW70000"),
        ({"area": BLOCK, "db": 8, "offset": 0}, "FB6011.*DB8"),
        ({"area": 0x85, "offset": 0}, "FB6040.*16#85"),
    ],
)
def test_an_address_that_is_not_there_stops_the_program(
    program: LoadedProgram, arguments: dict[str, int], message: str
) -> None:
    with pytest.raises(DiagnosticError, match=message):
        program.call("Peeked", **arguments)


def test_a_bit_that_no_byte_has_stops_the_program(program: LoadedProgram) -> None:
    with pytest.raises(DiagnosticError, match=r"FB6010.*%DB100\.DBX0\.8"):
        program.call("Poked", area=BLOCK, db=100, offset=0, bit=8)


def test_a_restart_brings_the_bytes_back(program: LoadedProgram) -> None:
    program.call("Poked", area=BLOCK, db=100, offset=2, bit=0)
    program.reset()
    assert program.globals.DB100.speed == -2


def test_the_bytes_of_data_blocks_are_part_of_a_snapshot(program: LoadedProgram) -> None:
    program.call("Poked", area=BLOCK, db=100, offset=2, bit=0)
    saved = program.engine.snapshot()
    program.reset()
    program.engine.restore(saved)
    assert program.call("Peeked", area=BLOCK, db=100, offset=2) == 0x0102


def test_an_index_counts_bytes(engine_name: str) -> None:
    path = Path(__file__).with_name("indexed.scl")
    program = load_program([path], engine=engine_name, db_numbers={"values": 7})
    assert program.call("Indexed", i=0) == 2 * 0x1234 + 5
    assert program.globals.values.table == [0x1234, 5, *[0] * 8]
    with pytest.raises(DiagnosticError, match=r"FB6010.*%DB7\.DBW21"):
        program.call("Indexed", i=21)


CLASSIC = """
DATA_BLOCK DB100
STRUCT table : ARRAY[0..9] OF INT; flag : BOOL; END_STRUCT
BEGIN
END_DATA_BLOCK

FUNCTION FC1 : INT
VAR_INPUT i : INT; block : WORD; END_VAR
BEGIN
  DB100.DW[i] := 16#1234;
  DB100.DX[20, 3] := TRUE;
  MW[i + 2] := DB100.DW[i];
  M[20, 1] := DB100.DX[20, 3];
  WORD_TO_BLOCK_DB(block).DW[6] := MW[i + 2];
  FC1 := WORD_TO_INT(WORD_TO_BLOCK_DB(block).DW[i]) + WORD_TO_INT(DB100.DW6);
END_FUNCTION
"""


def test_classic_spellings_reach_the_same_memory(engine_name: str) -> None:
    program = load_program([Source("classic.scl", CLASSIC)], "step7", engine=engine_name)
    assert program.call("FC1", i=2, block=100) == 2 * 0x1234
    assert program.globals.DB100.table == [0, 0x1234, 0, 0x1234, *[0] * 6]
    assert program.engine.environment.markers[20] == 2
    with pytest.raises(DiagnosticError, match=r"FB6011.*DB101"):
        program.call("FC1", i=2, block=101)
