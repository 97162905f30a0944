"""P_SND_RK and P_RCV_RK, and their like of CP 340 and CP 440, with the ASCII driver.

Data blocks by number, STATUS only with ERROR.
"""

import pytest

from harness.plc import CpuFamily
from tests.unit.plc.serial_rig import ENGINES, SerialRig

PROGRAM = """\
DATA_BLOCK Data
STRUCT
  go : BOOL; cancel : BOOL; listen : BOOL; laddr : INT := 270; block : INT := 20; first : INT := 2;
  length : INT := 3; done : INT; failed : INT; sendStatus : WORD;
  news : INT; errors : INT; status : WORD; got : INT;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB20
STRUCT
  out : ARRAY[0..7] OF BYTE := 1, 2, 3, 4, 5, 6, 7, 8;
  in : ARRAY[0..7] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
FUNCTION_BLOCK FB10
VAR send : P_SND_RK; receive : P_RCV_RK; END_VAR
BEGIN
send(REQ := Data.go, R := Data.cancel, LADDR := Data.laddr, DB_NO := Data.block,
     DBB_NO := Data.first, LEN := Data.length);
IF send.DONE THEN Data.done := Data.done + 1; END_IF;
IF send.ERROR THEN Data.failed := Data.failed + 1; Data.sendStatus := send.STATUS; END_IF;
receive(EN_R := Data.listen, LADDR := Data.laddr, DB_NO := Data.block, DBB_NO := 8);
IF receive.NDR THEN Data.news := Data.news + 1; Data.got := receive.LEN; END_IF;
IF receive.ERROR THEN Data.errors := Data.errors + 1; Data.status := receive.STATUS; END_IF;
END_FUNCTION_BLOCK
DATA_BLOCK DB10 FB10
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB1
VAR_TEMP info : ARRAY[0..19] OF BYTE; END_VAR
BEGIN
FB10.DB10();
END_ORGANIZATION_BLOCK
"""


BY_NUMBER = {
    "cp_340": ("P_SEND", "P_RCV", CpuFamily.S7_300),
    "cp_341": ("P_SND_RK", "P_RCV_RK", CpuFamily.S7_300),
    "cp_440": ("SEND_440", "RECV_440", CpuFamily.S7_400),
}


def _rig(engine: str = "compiled", module: str = "cp_341") -> SerialRig:
    send, receive, family = BY_NUMBER[module]
    text = PROGRAM.replace("P_SND_RK", send).replace("P_RCV_RK", receive)
    return SerialRig(text, engine=engine, family=family, dialect="step7")


@pytest.mark.parametrize("module", BY_NUMBER)
@pytest.mark.parametrize("engine", ENGINES)
def test_bytes_of_a_data_block_go_out_and_come_in(engine: str, module: str) -> None:
    rig = _rig(engine, module)
    rig.peer.answers[b"\3\4\5"] = b"\x2f\x47\x99"
    rig["go"], rig["listen"] = True, True
    rig.run_ms(60)
    assert rig.peer.heard == [b"\3\4\5"]
    assert (rig["done"], rig["failed"], rig["news"], rig["errors"], rig["got"]) == (1, 0, 1, 0, 3)
    assert rig.cpu.engine.global_value("DB20.in") == [0x2F, 0x47, 0x99, 0, 0, 0, 0, 0]


@pytest.mark.parametrize(
    ("name", "value", "status"),
    [
        ("laddr", 260, 0x1E0F),
        ("block", 21, 0x0301),
        ("first", 14, 0x0301),
        ("length", 0, 0x1E41),
        ("length", 1025, 0x0517),
    ],
)
def test_what_cannot_be_sent(name: str, value: int, status: int) -> None:
    rig = _rig()
    rig[name], rig["go"] = value, True
    rig.run_ms(40)
    assert (rig["done"], rig["failed"], rig["sendStatus"]) == (0, 1, status)


def test_a_cp_440_sends_400_bytes_at_most() -> None:
    rig = _rig(module="cp_440")
    rig["length"], rig["go"] = 401, True
    rig.run_ms(40)
    assert (rig["failed"], rig["sendStatus"]) == (1, 0x0517)


def test_a_job_is_cancelled_by_r() -> None:
    rig = _rig()
    rig["go"] = True
    rig.run_ms(3)
    rig["cancel"] = True
    rig.run_ms(10)
    assert (rig["done"], rig["failed"], rig["sendStatus"]) == (0, 1, 0x1E0D)


def test_a_job_ends_when_the_module_does_not_answer_any_more() -> None:
    rig = _rig()
    rig["go"] = True
    rig.run_ms(3)
    rig.module.failed = True
    rig.run_ms(40)
    assert (rig["done"], rig["failed"], rig["sendStatus"]) == (0, 1, 0x1E0F)
    rig.module.failed = False
    rig.run_ms(40)
    assert (rig["done"], rig["failed"]) == (0, 1)


def test_nothing_is_read_without_en_r() -> None:
    rig = _rig()
    rig.peer.port.transmit(b"\1")
    rig.run_ms(40)
    assert rig["news"] == 0
    rig["listen"] = True
    rig.run_ms(20)
    assert rig["news"] == 1


def test_a_message_too_long_for_its_data_block() -> None:
    rig = _rig()
    rig["listen"] = True
    rig.peer.port.transmit(bytes(9))
    rig.run_ms(40)
    assert (rig["news"], rig["errors"], rig["status"]) == (0, 1, 0x040A)
