"""One file of a project, checked alone: what is missing is said once and leads to nothing else."""

import pytest
from checking import findings_of

_STATION = """FUNCTION_BLOCK "Station"
VAR_IN_OUT
   device : "typeDevice";
END_VAR
VAR
   wanted : Bool;
   level : Int;
END_VAR
BEGIN
IF #device.cmd.manual THEN
   #wanted := #device.cmd.hand;
ELSIF #device.cmd.auto THEN
   #wanted := TRUE;
ELSIF #device.cmd.other THEN
   #level := #device.levels[#level];
END_IF;
#device.out := #wanted;
#device.raw := #level;
"Journal"(text := 'x', level => #level);
"Journal_DB".count := "Journal_DB".count + 1;
"Journal_DB".last := "Journal_DB".count;
END_FUNCTION_BLOCK
"""


def test_each_missing_name_is_one_error_with_the_way_out() -> None:
    found = findings_of(_STATION, "tia")
    assert [(one.code, one.span.line) for one in found if one.span] == [
        ("FB4003", 3),
        ("FB4004", 19),
        ("FB4001", 20),
    ]
    assert all("file" in one.help for one in found)


def test_many_places_of_a_missing_name_are_lines() -> None:
    body = "\n".join(f'"Missing".m{index} := TRUE;' for index in range(20))
    (found,) = findings_of(f'FUNCTION "F" : Void\nBEGIN\n{body}\nEND_FUNCTION\n', "tia")
    assert [note.message for note in found.notes] == [
        "and here",
        "and here",
        "and in 17 more places, lines 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, ...",
    ]


@pytest.mark.parametrize("second", ["IN := FALSE", "IN := FALSE, PT := T#1s"])
def test_a_timer_may_be_put_back_behind_its_call(second: str) -> None:
    text = (
        'FUNCTION_BLOCK "F"\nVAR_INPUT go : Bool; END_VAR\nVAR_OUTPUT done : Bool; END_VAR\n'
        "VAR t : TON_TIME; END_VAR\nBEGIN\n#t(IN := #go, PT := T#1s);\n#done := #t.Q;\n"
        f"IF #done THEN #t({second}); END_IF;\nEND_FUNCTION_BLOCK\n"
    )
    assert "FB4221" not in [one.code for one in findings_of(text, "tia")]


def test_an_output_is_written_through_its_overlay() -> None:
    text = (
        "FUNCTION_BLOCK FB7\nVAR_OUTPUT w : DWORD; bits AT w : ARRAY[0..31] OF BOOL; END_VAR\n"
        "BEGIN\nbits[3] := TRUE;\nEND_FUNCTION_BLOCK\n"
    )
    assert findings_of(text, "step7") == []


def test_a_data_block_that_is_called_and_asked_is_one_missing_name() -> None:
    text = """FUNCTION "Calls" : Void
BEGIN
"Valve_DB"("open" := "Valve_DB"."Hmi"."Open", level => "tag");
END_FUNCTION
"""
    missing = [(one.code, one.message.rpartition(" ")[2]) for one in findings_of(text, "tia")]
    assert missing == [("FB4004", "'Valve_DB'"), ("FB4001", "'tag'")]


def test_start_values_of_a_missing_type_are_left_alone() -> None:
    text = """DATA_BLOCK "Setup"
VAR
   belts : Array[0.."BELTS"] of "typeBelt";
END_VAR
BEGIN
   belts[0].speed := 3;
END_DATA_BLOCK
"""
    assert [one.code for one in findings_of(text, "tia")] == ["FB4001", "FB4003"]
