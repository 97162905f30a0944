"""Calls of the instructions for serial lines: every parameter is known, areas are no BOOL."""

import pytest
from checking import errors_of, findings_of

from fbgen.lang.families import Cpu
from fbgen.lang.instruction_families import instead_of


def _text(body: str) -> str:
    return (
        'FUNCTION_BLOCK "F"\nVAR\nsend : Send_P2P; port : Modbus_Comm_Load; master : Modbus_Master;'
        " data : Array[0..7] of Byte; flags : Array[0..7] of Bool; n : UInt;\nEND_VAR\nBEGIN\n"
        f"{body}\nEND_FUNCTION_BLOCK\n"
    )


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ("#send(REQ := TRUE, PORTS := 270, BUFFER := #data);", "FB4006"),
        ("#send(REQ := TRUE, PORT := 270);", "FB4040"),
        ("#send(REQ := TRUE, PORT := 270, BUFFER := #flags);", "FB4010"),
        ("#send(REQ := TRUE, BUFFER := #data, BUFFER := #data);", "FB4043"),
    ],
)
def test_what_does_not_fit_is_told(body: str, code: str) -> None:
    assert [one.code for one in errors_of(_text(body), "tia")] == [code]


def test_a_call_needs_no_stub_and_no_warning() -> None:
    text = _text(
        "#port.MODE := 4;\n"
        "#port(REQ := TRUE, PORT := 270, BAUD := 19200, MB_DB := #master.MB_DB);\n"
        "#send(REQ := #port.DONE, PORT := 270, BUFFER := #data, LENGTH := 5);\n"
        "#master(REQ := #send.DONE, MB_ADDR := 1, MODE := 0, DATA_ADDR := 464001, DATA_LEN := 1,"
        " DATA_PTR := #n);"
    )
    assert [one for one in findings_of(text, "tia") if "flags" not in one.message] == []


def test_the_modules_of_the_s7_300_have_instructions_of_their_own() -> None:
    assert "Send_P2P" in (instead_of("P_SND_RK", Cpu.S7_1500) or "")
    assert "Receive_P2P" in (instead_of("RECV_440", Cpu.S7_1500) or "")
    assert instead_of("P_SND_RK", Cpu.S7_300) is None
    assert instead_of("SEND_440", Cpu.S7_400) is None
