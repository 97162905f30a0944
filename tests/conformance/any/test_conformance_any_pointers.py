"""ANY and POINTER as bytes: taken apart, built and handed on by overlays.

Expected values: STEP 7 help, "Format of the parameter type ANY" and "... POINTER" (codes of types
and areas, address in bits); S7-SCL V5.3 manual, "Parameter type ANY" (assigning variables and NIL).
"""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program

_PROGRAM = Path(__file__).with_name("pointers.step7")


def _run(engine_name: str) -> LoadedProgram:
    return load_program([_PROGRAM], dialect="step7", engine=engine_name)


@pytest.mark.parametrize(
    ("number", "expected"),
    [
        (0, (5, 5, 10, 0x84000000)),  # an array of INT
        (1, (5, 1, 10, 0x84000010)),  # one of its elements
        (2, (0x13, 1, 10, 0x84000050)),  # a text
        (3, (1, 1, 10, 0x84000099)),  # the tenth BOOL, bit 1 of byte 19
        (4, (2, 6, 10, 0x840000A0)),  # a structure of six bytes
        (5, (4, 1, 0, 0x830000A0)),  # MW20
        (6, (1, 4, 11, 0x8400001A)),  # P#DB11.DBX3.2 BOOL 4
    ],
)
def test_an_overlay_shows_what_any_points_to(
    engine_name: str, number: int, expected: tuple[int, int, int, int]
) -> None:
    block = _run(engine_name).instance("FB1")
    block()
    assert tuple(block[name][number] for name in ("code", "count", "db", "area")) == expected


def test_an_any_that_is_built_moves_data_between_data_blocks(engine_name: str) -> None:
    program = _run(engine_name)
    program.instance("FB1")()
    assert bytes(program.globals["DB11"]["bytes"]) == bytes(
        (*bytes(4), 0, 12, 0, 13, 0, 14, *bytes(10))
    )


def test_an_any_moved_on_means_the_rest_of_the_area(engine_name: str) -> None:
    program = _run(engine_name)
    block = program.instance("FB1")
    block()
    assert bytes(program.globals["DB10"]["bytes"]) == bytes((0, 0, 0, 0, 0, 0xAA, 0xAA, 0xAA))
    assert bytes(block["local"]) == bytes((0, 0, 0, 0, 0xAA, 0xAA)), "a static, with no data block"
    assert bytes(program.engine.environment.markers[100:107]) == bytes.fromhex("000000AAAAAA00")


def test_a_pointer_is_the_data_block_and_the_address(engine_name: str) -> None:
    block = _run(engine_name).instance("FB1")
    block()
    assert list(block["pointer"]) == [0x84000050, 0x8300003B, 0x84000029]
    assert list(block["pointer_db"]) == [10, 0, 11]


def test_an_any_takes_addresses_by_assignment(engine_name: str) -> None:
    block = _run(engine_name).instance("FB1")
    block["local"] = [0x12, 0x34, 0, 0, 0, 0]
    found = []
    for which in (1, 2, 3, 4):
        block(which=which)
        found.append(block["word"])
    assert found == [0xBEEF, 13, 0x1234, 0x1234], "NIL moves nothing"


_BUILT = """
FUNCTION MOVE_IT : INT
VAR_INPUT syntax : BYTE; code : BYTE; count : INT; db : INT; area : DWORD; END_VAR
VAR_TEMP
  source : ANY;
  s AT source : STRUCT id : BYTE; typ : BYTE; num : INT; dbn : INT; ptr : DWORD; END_STRUCT;
  target : DWORD;
END_VAR
s.id := syntax;
s.typ := code;
s.num := count;
s.dbn := db;
s.ptr := area;
MOVE_IT := SFC20(SRCBLK := source, DSTBLK := target);
END_FUNCTION

DATA_BLOCK DB10
STRUCT a : ARRAY[0..7] OF BYTE; END_STRUCT
BEGIN
END_DATA_BLOCK
"""


@pytest.mark.parametrize(
    ("built", "reason"),
    [
        ((0x11, 2, 4, 10, 0x84000000), "does not begin with 16#10"),
        ((0x10, 2, 9, 10, 0x84000000), "behind the 8 bytes"),
        ((0x10, 2, 4, 10, 0x84000028), "behind the 8 bytes"),
        ((0x10, 2, 0, 10, 0x84000000), "type 16#02, count 0"),
        ((0x10, 0x1C, 1, 10, 0x84000000), "type 16#1C, count 1"),
        ((0x10, 2, 4, 12, 0x84000000), "no data block 12"),
        ((0x10, 2, 4, 0, 0x86000000), "no area 16#86"),
        ((0x10, 2, 4, 0, 0x87000000), "local data that it meant is gone"),
    ],
)
def test_an_any_that_means_nothing_stops_where_it_is_followed(
    engine_name: str, built: tuple[int, int, int, int, int], reason: str
) -> None:
    program = load_program([Source("built.scl", _BUILT)], dialect="step7", engine=engine_name)
    names = ("syntax", "code", "count", "db", "area")
    with pytest.raises(DiagnosticError) as stop:
        program.call("MOVE_IT", **dict(zip(names, built, strict=True)))
    (found,) = stop.value.diagnostics
    assert found.code == "FB6017"
    assert reason in found.message
    assert found.span is not None
    assert found.span.text == "source"


_NO_ADDRESS = """
FUNCTION_BLOCK FB2
VAR_INPUT go : BOOL; END_VAR
VAR held : INT; END_VAR
held := held + 1;
END_FUNCTION_BLOCK

FUNCTION FIRST : INT
VAR_INPUT what : ANY; END_VAR
VAR bytes AT what : ARRAY[0..9] OF BYTE; target : WORD; END_VAR
FIRST := SFC20(SRCBLK := what, DSTBLK := target);
END_FUNCTION

FUNCTION_BLOCK FB3
VAR inner : FB2; result : INT; END_VAR
result := FIRST(what := inner);
END_FUNCTION_BLOCK
"""


def test_what_has_no_address_is_refused_where_it_is_followed(engine_name: str) -> None:
    program = load_program([Source("none.scl", _NO_ADDRESS)], dialect="step7", engine=engine_name)
    with pytest.raises(DiagnosticError) as stop:
        program.instance("FB3")()
    (found,) = stop.value.diagnostics
    assert found.code == "FB6017"
    assert "no address" in found.message


_FAR = """
FUNCTION INNER : INT
VAR_INPUT what : ANY; END_VAR
VAR_TEMP copy : ANY; view AT copy : ARRAY[0..9] OF BYTE; target : WORD; END_VAR
copy := what;
INNER := SFC20(SRCBLK := copy, DSTBLK := target);
INNER := WORD_TO_INT(target);
END_FUNCTION

FUNCTION MIDDLE : INT
VAR_IN_OUT data : ARRAY[0..3] OF INT; END_VAR
MIDDLE := INNER(what := data[2]);
END_FUNCTION

FUNCTION_BLOCK FB4
VAR own : ARRAY[0..3] OF INT := 1, 2, 3, 4; END_VAR
VAR_TEMP temporary : ARRAY[0..3] OF INT; END_VAR
VAR_OUTPUT found : INT; also : INT; END_VAR
temporary[2] := 77;
found := MIDDLE(data := own);
also := MIDDLE(data := temporary);
END_FUNCTION_BLOCK
"""


def test_what_comes_through_an_in_out_has_an_address(engine_name: str) -> None:
    program = load_program([Source("far.scl", _FAR)], dialect="step7", engine=engine_name)
    block = program.instance("FB4")
    block()
    assert (block["found"], block["also"]) == (3, 77)
    block()
    assert (block["found"], block["also"]) == (3, 77)


_TIA = """
FUNCTION_BLOCK "Keeper"
{ S7_Optimized_Access := 'FALSE' }
VAR_INPUT
  area : ANY;
  bytes AT area : STRUCT id : Byte; code : Byte; count : Int; db : Int; ptr : DWord; END_STRUCT;
END_VAR
VAR_OUTPUT db : Int; moved : Int; END_VAR
VAR data : Array[0..3] of Byte; END_VAR
BEGIN
  #db := #bytes.db;
  #moved := BLKMOV(SRCBLK := #area, DSTBLK => #data);
END_FUNCTION_BLOCK

DATA_BLOCK "Values"
{ S7_Optimized_Access := 'FALSE' }
STRUCT a : Word := 16#0102; b : Word := 16#0304; END_STRUCT;
BEGIN
END_DATA_BLOCK

DATA_BLOCK "Held"
"Keeper"
BEGIN
END_DATA_BLOCK

ORGANIZATION_BLOCK "Main"
BEGIN
  "Held"(area := "Values");
END_ORGANIZATION_BLOCK
"""


def test_a_block_keeps_the_pointer_it_got_last(engine_name: str) -> None:
    numbers = {"Values": 20}
    source = Source("keeper.scl", _TIA)
    program = load_program([source], dialect="tia", engine=engine_name, db_numbers=numbers)
    program.run("Main")
    held = program.globals["Held"]
    assert held["db"] == 20
    assert list(held["data"]) == [1, 2, 3, 4]
