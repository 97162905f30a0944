"""Modbus_Comm_Load and Modbus_Master on a line; STATUS as TIA Portal Information System says."""

import pytest

from fbgen.wire.modbus import seal
from harness.line import Parity
from tests.unit.plc.serial_rig import ENGINES, SerialRig

PROGRAM = """\
DATA_BLOCK "Data"
{ S7_Optimized_Access := 'TRUE' }
VAR
   load : Bool; baud : UDInt := 19200; parity : UInt := 2; replyTime : UInt := 50;
   loaded : Int; loadFailed : Int; loadStatus : Word;
   ask : Bool; address : UInt := 1; mode : USInt; place : UDInt := 465025; count : UInt := 1;
   words : Array[0..3] of Word; other : Bool;
   done : Int; failed : Int; status : Word; busy : Bool; first : Word; otherStatus : Word;
END_VAR
BEGIN
END_DATA_BLOCK
FUNCTION_BLOCK "Talk"
VAR loader : Modbus_Comm_Load; master : Modbus_Master; second : Modbus_Master; END_VAR
BEGIN
  #loader.RETRIES := 1;
  #loader(REQ := "Data".load, PORT := 270, BAUD := "Data".baud, PARITY := "Data".parity,
          RESP_TO := "Data".replyTime, MB_DB := #master.MB_DB);
  IF #loader.DONE THEN
    "Data".loaded := "Data".loaded + 1;
    #second.MB_DB := #master.MB_DB;
  END_IF;
  IF #loader.ERROR THEN
    "Data".loadFailed := "Data".loadFailed + 1; "Data".loadStatus := #loader.STATUS;
  END_IF;
  #master(REQ := "Data".ask, MB_ADDR := "Data".address, MODE := "Data".mode,
          DATA_ADDR := "Data".place, DATA_LEN := "Data".count, DATA_PTR := "Data".words);
  "Data".busy := #master.BUSY;
  IF #master.BUSY AND "Data".first = 0 THEN "Data".first := #master.STATUS; END_IF;
  IF #master.DONE THEN "Data".done := "Data".done + 1; "Data".status := #master.STATUS; END_IF;
  IF #master.ERROR THEN
    "Data".failed := "Data".failed + 1; "Data".status := #master.STATUS;
  END_IF;
  #second(REQ := "Data".other, MB_ADDR := 1, MODE := 0, DATA_ADDR := 40001, DATA_LEN := 1,
          DATA_PTR := "Data".words);
  IF #second.ERROR THEN "Data".otherStatus := #second.STATUS; END_IF;
END_FUNCTION_BLOCK
DATA_BLOCK "Talk_DB" "Talk" BEGIN END_DATA_BLOCK
ORGANIZATION_BLOCK "Main"
BEGIN
  "Talk_DB"();
END_ORGANIZATION_BLOCK
"""
READ = seal(bytes.fromhex("01 03 FE 00 00 01"))


@pytest.fixture(params=ENGINES)
def rig(request: pytest.FixtureRequest) -> SerialRig:
    made = SerialRig(PROGRAM, engine=request.param)
    made["load"] = True
    made.run_ms(30)
    assert (made["loaded"], made["loadFailed"]) == (1, 0)
    return made


def _ask(rig: SerialRig, **inputs: int) -> tuple[object, object, object]:
    """DONE and ERROR counted, and STATUS, behind one request."""
    rig["done"], rig["failed"] = 0, 0
    for name, value in inputs.items():
        rig[name] = value
    rig["ask"] = True
    rig.run_ms(200)
    rig["ask"] = False
    rig.run_ms(10)
    return rig["done"], rig["failed"], rig["status"]


def test_a_word_is_read(rig: SerialRig) -> None:
    rig.peer.answers[READ] = seal(bytes.fromhex("01 03 02 0B B8"))
    assert _ask(rig) == (1, 0, 0)
    assert rig.peer.heard == [READ]
    assert (rig["words"], rig["first"], rig["busy"]) == ([0x0BB8, 0, 0, 0], 0x7001, False)


def test_one_word_is_written_by_06_and_more_by_10(rig: SerialRig) -> None:
    rig["words"] = [0x0BB8, 0x1234, 0, 0]
    one = seal(bytes.fromhex("01 06 FA 01 0B B8"))
    two = seal(bytes.fromhex("01 10 FA 01 00 02 04 0B B8 12 34"))
    again = seal(bytes.fromhex("01 10 FA 01 00 01 02 0B B8"))
    rig.peer.answers[one] = one
    rig.peer.answers[two] = seal(bytes.fromhex("01 10 FA 01 00 02"))
    rig.peer.answers[again] = seal(bytes.fromhex("01 10 FA 01 00 01"))
    assert _ask(rig, mode=1, place=400001 + 0xFA01) == (1, 0, 0)
    assert _ask(rig, count=2) == (1, 0, 0)
    assert _ask(rig, mode=2, count=1) == (1, 0, 0)
    assert rig.peer.heard == [one, two, again]


@pytest.mark.parametrize(
    ("reply", "status"),
    [
        ("01 83 01", 0x8381),
        ("01 83 03", 0x8382),
        ("01 83 02", 0x8383),
        ("01 83 04", 0x8384),
        ("02 03 02 00 01", 0x8387),
        ("01 04 02 00 01", 0x8386),
        ("01 03 04 00 01 00 02", 0x8380),
    ],
)
def test_refusals_and_wrong_replies(rig: SerialRig, reply: str, status: int) -> None:
    rig.peer.answers[READ] = seal(bytes.fromhex(reply))
    assert _ask(rig) == (0, 1, status)
    assert rig["words"] == [0, 0, 0, 0]


def test_a_wrong_check_sum(rig: SerialRig) -> None:
    rig.peer.answers[READ] = seal(bytes.fromhex("01 03 02 0B B8"))[:-1] + b"\0"
    assert _ask(rig) == (0, 1, 0x8380)


def test_another_reply_to_a_write(rig: SerialRig) -> None:
    asked = seal(bytes.fromhex("01 06 FE 00 00 00"))
    rig.peer.answers[asked] = seal(bytes.fromhex("01 06 FE 00 00 01"))
    assert _ask(rig, mode=1) == (0, 1, 0x8388)


def test_silence_is_tried_again_and_then_told(rig: SerialRig) -> None:
    assert _ask(rig) == (0, 1, 0x80C8)
    assert rig.peer.heard == [READ, READ]


def test_a_broadcast_waits_for_nobody(rig: SerialRig) -> None:
    assert _ask(rig, address=0, mode=1) == (1, 0, 0)
    assert rig.peer.heard == [seal(bytes.fromhex("00 06 FE 00 00 00"))]


@pytest.mark.parametrize(
    ("inputs", "status"),
    [
        ({"address": 248}, 0x8186),
        ({"mode": 3}, 0x8188),
        ({"address": 0}, 0x8188),
        ({"place": 1}, 0x8189),
        ({"place": 40000}, 0x8189),
        ({"place": 465537}, 0x8189),
        ({"mode": 1, "place": 30001}, 0x8189),
        ({"count": 0}, 0x818A),
        ({"count": 126}, 0x818A),
        ({"count": 5}, 0x818B),
    ],
)
def test_inputs_that_cannot_be(rig: SerialRig, inputs: dict[str, int], status: int) -> None:
    assert _ask(rig, **inputs) == (0, 1, status)
    assert rig.peer.heard == []


def test_one_request_at_a_time(rig: SerialRig) -> None:
    rig["ask"] = True
    rig.run_ms(10)
    rig["other"] = True
    rig.run_ms(10)
    assert rig["otherStatus"] == 0x8200


def test_the_load_sets_the_port(rig: SerialRig) -> None:
    assert rig.module.port.format.baud == 19_200
    assert rig.module.port.format.parity is Parity.EVEN


@pytest.mark.parametrize(
    ("name", "value", "status"),
    [("baud", 9601, 0x8181), ("parity", 3, 0x8182), ("replyTime", 4, 0x8184)],
)
@pytest.mark.parametrize("engine", ENGINES)
def test_loads_that_cannot_be(engine: str, name: str, value: int, status: int) -> None:
    rig = SerialRig(PROGRAM, engine=engine)
    rig[name] = value
    rig["load"] = True
    rig.run_ms(30)
    assert (rig["loaded"], rig["loadFailed"], rig["loadStatus"]) == (0, 1, status)
    assert _ask(rig) == (0, 1, 0x8180)


def test_a_request_ends_when_the_module_does_not_answer_any_more(rig: SerialRig) -> None:
    rig["ask"] = True
    rig.run_ms(10)
    rig.module.failed = True
    rig.run_ms(10)
    assert (rig["done"], rig["failed"], rig["status"]) == (0, 1, 0x8282)
    rig.module.failed = False
    rig.run_ms(200)
    assert (rig["done"], rig["failed"], rig["busy"]) == (0, 1, False)


def test_a_load_ends_when_the_module_does_not_answer_any_more() -> None:
    rig = SerialRig(PROGRAM)
    rig["load"] = True
    rig.run_ms(1)
    rig.module.failed = True
    rig.run_ms(30)
    assert (rig["loaded"], rig["loadFailed"], rig["loadStatus"]) == (0, 1, 0x8282)


def test_a_module_without_supply(rig: SerialRig) -> None:
    rig["load"] = False
    rig.module.power_off()
    assert _ask(rig) == (0, 1, 0x8282)
    rig.module.power_on()
    assert _ask(rig) == (0, 1, 0x8180)
