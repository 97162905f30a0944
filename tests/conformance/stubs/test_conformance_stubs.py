"""Stubs: Python in the place of blocks that the harness has no model for, or that are not there."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program

TEXT = Path(__file__).with_name("stubs.scl")
BAD = Path(__file__).parents[2] / "unit" / "bad"
LIBRARY = {"LFilter": lambda **_: None, "LOffset": lambda **_: None, "LIsGood": lambda **_: None}


def loaded(engine_name: str) -> LoadedProgram:
    return load_program([TEXT], engine=engine_name, stubs=LIBRARY)


def test_a_function_gets_inputs_as_written_and_gives_outputs_by_name(engine_name: str) -> None:
    program = loaded(engine_name)
    calls: list[dict[str, object]] = []

    def get_diag(**inputs: object) -> Mapping[str, object]:
        calls.append(inputs)
        return {"RET_VAL": -1, "cnt_diag": 3, "TEXT": "bus", "Detail": [1, 2, 3, 4]}

    program.stub("GET_DIAG", get_diag)
    block = program.instance("Diagnosis")
    block(mode=2)
    assert calls == [{"MODE": 2, "Detail": [0, 0, 0, 0]}]
    assert (block.state, block.count, block.text, list(block.data)) == (-1, 3, "bus", [1, 2, 3, 4])


AREA = """FUNCTION_BLOCK "Receiver"
VAR_OUTPUT got : Bool; END_VAR
VAR
  port : Receive_P2P;
  record : STRUCT count : Int; bytes : Array[1..3] of Byte; END_STRUCT;
END_VAR
BEGIN
#port(PORT := 270, BUFFER := #record, NDR => #got);
END_FUNCTION_BLOCK
"""


def test_an_area_is_given_as_its_bytes_and_stays_as_it_was_behind_them(engine_name: str) -> None:
    program = load_program([Source("receiver.scl", AREA)], engine=engine_name)
    block = program.instance("Receiver")
    for given, count, octets in (
        ("01 02 0A 0B 0C", 0x0102, [10, 11, 12]),
        (b"\x03\x04\x0d", 0x0304, [13, 11, 12]),
        ("", 0x0304, [13, 11, 12]),
    ):
        program.stub("RECEIVE_P2P", lambda given=given, **_: {"NDR": True, "buffer": given})
        block()
        assert (block.got, block.record.count) == (True, count)
        assert list(block.record.bytes) == octets


@pytest.mark.parametrize("given", ["01 02 0A 0B 0C 0D 0E", "soon", b"1234567"])
def test_an_area_takes_no_more_bytes_than_it_has_and_nothing_else(
    engine_name: str, given: str | bytes
) -> None:
    program = load_program([Source("receiver.scl", AREA)], engine=engine_name)
    program.stub("RECEIVE_P2P", lambda **_: {"BUFFER": given})
    with pytest.raises(DiagnosticError, match="FB6071"):
        program.instance("Receiver")()


def test_a_function_may_give_its_result_alone(engine_name: str) -> None:
    program = loaded(engine_name)
    program.stub("get_diag", lambda **inputs: inputs["MODE"] + 1)
    block = program.instance("Diagnosis")
    block(mode=4)
    assert (block.state, block.count) == (5, 7)


def test_a_stub_can_be_replaced(engine_name: str) -> None:
    program = loaded(engine_name)
    block = program.instance("Diagnosis")
    for result in (1, 2):
        program.stub("GET_DIAG", lambda result=result, **_: result)
        block()
        assert block.state == result


class Connecting:
    """Done at the second call for the connection 1."""

    def __init__(self) -> None:
        self.calls = 0

    def __call__(self, REQ: bool, ID: int) -> Mapping[str, object]:  # noqa: N803  # PLC names
        self.calls += 1
        return {"DONE": REQ and ID == 1 and self.calls > 1, "STATUS": 0x7000 + self.calls}


def test_each_instance_has_an_object_of_its_class(engine_name: str) -> None:
    program = loaded(engine_name)
    program.stub("TCON", Connecting)
    block, other = program.instance("Connection"), program.instance("Connection")
    block(start=True)
    assert (block.status, block.first) == (0x7001, False)
    block()
    assert (block.status, block.first) == (0x7002, True)
    other(start=True)
    assert (other.status, other.first) == (0x7001, False)


def test_blocks_that_are_not_in_the_files(engine_name: str) -> None:
    program = loaded(engine_name)
    program.stub("LFilter", lambda **inputs: {"out": inputs["in"] / 2})
    program.stub("LIsGood", lambda value, **_: {"RET_VAL": value > 1.0, "seen": True})
    program.stub("LOffset", lambda step: step + 0.5)
    block = program.instance("WithLibrary")
    block(x=3.0)
    assert (block.y, block.seen) == (24.0, True)


def test_arguments_without_names_need_an_interface(engine_name: str) -> None:
    text = (
        'FUNCTION "F" : VOID\nVAR_TEMP x : INT; END_VAR\nBEGIN\n#x := "LOffset"(10);\nEND_FUNCTION'
    )
    with pytest.raises(DiagnosticError, match="FB4044"):
        load_program([Source("f.scl", text)], engine=engine_name, stubs=LIBRARY)


def test_a_block_that_nobody_knows_is_an_error_of_the_text(engine_name: str) -> None:
    with pytest.raises(DiagnosticError, match="FB4003") as failure:
        load_program([TEXT], engine=engine_name)
    assert "FB4004" in {one.code for one in failure.value.diagnostics}


def test_the_failure_of_a_stub_is_not_that_of_the_program(engine_name: str) -> None:
    program = loaded(engine_name)

    def fails(**inputs: object) -> object:
        raise ZeroDivisionError("of the test itself")

    program.stub("GET_DIAG", fails)
    with pytest.raises(ZeroDivisionError, match="of the test itself"):
        program.instance("Diagnosis")()


@pytest.mark.parametrize(
    ("given", "code"),
    [
        ({"COUNT": 1}, "FB6071"),
        ({"CNT_DIAG": 1.5}, "FB6021"),
        (70000, "FB6021"),
    ],
)
def test_what_a_stub_may_not_give(engine_name: str, given: object, code: str) -> None:
    program = load_program([BAD / "FB6071_wrong_output.scl"], engine=engine_name)
    program.stub("GET_DIAG", lambda **_: given)
    with pytest.raises(DiagnosticError, match=code):
        program.instance("Faulty")()


def test_a_block_in_a_further_file_is_used_instead(engine_name: str) -> None:
    st = (
        "FUNCTION GET_DIAG : INT\nVAR_INPUT MODE : INT; END_VAR\nVAR_OUTPUT CNT_DIAG : INT;"
        " END_VAR\nBEGIN\n#CNT_DIAG := 9;\nGET_DIAG := 2;\nEND_FUNCTION\n"
    )
    files = [BAD / "FB6070_no_stub.scl", Source("stub.scl", st)]
    block = load_program(files, engine=engine_name).instance("Faulty")
    block()
    assert (block.state, block.count) == (2, 9)


INPUTS = """FUNCTION_BLOCK "Sender"
VAR_INPUT go : Bool; END_VAR
VAR_OUTPUT sent : Bool; asked : Bool; length : UDInt; END_VAR
VAR send : TSEND; other : CONT_C; data : Array[0..3] of Byte; END_VAR
BEGIN
  #send.REQ := #go;
  #send(ID := 16#0001, LEN := 4, DATA := #data);
  #send();
  #asked := #send.REQ;
  #length := #send.LEN;
  #sent := #send.DONE;
  #other(SP_INT := 50.0, GAIN := 2.0);
END_FUNCTION_BLOCK
"""


def test_inputs_of_hardware_blocks_are_members_that_stay(engine_name: str) -> None:
    program = load_program([Source("sender.scl", INPUTS)], engine=engine_name)
    calls: list[Mapping[str, object]] = []

    def sends(**inputs: object) -> Mapping[str, object]:
        calls.append(inputs)
        return {"DONE": inputs["REQ"]}

    program.stub("TSEND", sends)
    program.stub("CONT_C", lambda SP_INT, GAIN: {"LMN": SP_INT * GAIN})  # noqa: N803  # PLC names
    block = program.instance("Sender")
    block(go=True)
    assert (block.sent, block.asked, block.length) == (True, True, 4)
    assert block["other.LMN"] == 100.0
    assert [sorted(given) for given in calls] == [["DATA", "ID", "LEN", "REQ"], ["REQ"]]
