"""Send_P2P, Receive_P2P, Receive_Reset and the configuring instructions on a line.

STATUS as TIA Portal Information System, "Freeport communication", says.
"""

import pytest

from fbgen.lang.checked import Program
from harness.engine.compiled.outside.replaceable import ReplaceableEngine
from harness.engine.environment import Environment
from harness.engine.interface import Limits
from harness.line import Parity
from harness.plc.serial import ReceiveConditions
from tests.unit.plc.serial_rig import ENGINES, SerialRig

PROGRAM = """\
DATA_BLOCK "Data"
{ S7_Optimized_Access := 'TRUE' }
VAR
   send : Bool; reset : Bool; receive : Bool; port : UInt := 270; length : UInt;
   out : Array[0..7] of Byte := [16#2F, 16#01, 16#47, 16#FE, 16#03, 16#00, 16#00, 16#78];
   in : Array[0..9] of Byte;
   sent : Int; failed : Int; sendStatus : Word; states : Array[0..3] of Word; state : Int;
   news : Int; errors : Int; status : Word; got : UInt;
END_VAR
BEGIN
END_DATA_BLOCK
FUNCTION_BLOCK "Talk"
VAR sender : Send_P2P; receiver : Receive_P2P; resetter : Receive_Reset; END_VAR
BEGIN
  #sender(REQ := "Data".send, PORT := "Data".port, BUFFER := "Data".out, LENGTH := "Data".length);
  IF #sender.DONE THEN "Data".sent := "Data".sent + 1; "Data".sendStatus := #sender.STATUS; END_IF;
  IF #sender.ERROR THEN
    "Data".failed := "Data".failed + 1; "Data".sendStatus := #sender.STATUS;
  END_IF;
  IF "Data".send AND "Data".state <= 3 THEN
    "Data".states["Data".state] := #sender.STATUS;
    "Data".state := "Data".state + 1;
  END_IF;
  IF "Data".receive THEN
    #receiver(PORT := "Data".port, BUFFER := "Data".in);
    IF #receiver.NDR THEN
      "Data".news := "Data".news + 1;
      "Data".status := #receiver.STATUS;
      "Data".got := #receiver.LENGTH;
    END_IF;
    IF #receiver.ERROR THEN
      "Data".errors := "Data".errors + 1;
      "Data".status := #receiver.STATUS;
    END_IF;
  END_IF;
  #resetter(REQ := "Data".reset, PORT := "Data".port);
END_FUNCTION_BLOCK
DATA_BLOCK "Talk_DB" "Talk" BEGIN END_DATA_BLOCK
ORGANIZATION_BLOCK "Main"
BEGIN
  "Talk_DB"();
END_ORGANIZATION_BLOCK
"""
REPLY = bytes.fromhex("2F 01 47 FE 03 0F 1B A2")
_REQUEST = bytes.fromhex("2F 01 47 FE 03 00 00 78")


@pytest.mark.parametrize("engine", ENGINES)
def test_a_request_goes_out_and_its_reply_comes_in(engine: str) -> None:
    rig = SerialRig(PROGRAM, engine=engine)
    rig.peer.answers[_REQUEST] = REPLY
    rig.run_ms(6)
    rig["send"], rig["receive"] = True, True
    rig.run_ms(60)
    assert rig.peer.heard == [_REQUEST]
    assert rig["states"] == [0x7001, 0x7002, 0, 0x7000]
    assert (rig["sent"], rig["failed"], rig["sendStatus"]) == (1, 0, 0)
    assert (rig["news"], rig["errors"], rig["status"], rig["got"]) == (1, 0, 0x0096, 8)
    assert bytes(rig["in"][:8]) == REPLY


def test_an_engine_that_goes_to_another_cpu_sends_there() -> None:
    engines: list[ReplaceableEngine] = []

    def load(program: Program, environment: Environment, limits: Limits) -> ReplaceableEngine:
        if engines:
            engines[0].move_to(environment)
        else:
            engines.append(ReplaceableEngine(program, environment, limits))
        return engines[0]

    for _ in range(2):
        rig = SerialRig(PROGRAM, load=load)
        rig["send"] = True
        rig.run_ms(60)
        assert rig.peer.heard == [_REQUEST]
        assert (rig["sent"], rig["failed"]) == (1, 0)


@pytest.mark.parametrize("engine", ENGINES)
def test_the_rest_of_the_buffer_stays(engine: str) -> None:
    rig = SerialRig(PROGRAM, engine=engine)
    rig["in"] = [9] * 10
    rig["receive"] = True
    rig.peer.port.transmit(b"\x01\x02")
    rig.run_ms(40)
    assert rig["in"] == [1, 2, *[9] * 8]


def test_length_says_how_much_of_the_buffer_goes_out() -> None:
    rig = SerialRig(PROGRAM)
    rig["length"], rig["send"] = 5, True
    rig.run_ms(40)
    assert rig.peer.heard == [_REQUEST[:5]]


@pytest.mark.parametrize(
    ("place", "value", "status"), [("length", 9, 0x8088), ("port", 271, 0x8282)]
)
def test_what_cannot_be_sent(place: str, value: int, status: int) -> None:
    rig = SerialRig(PROGRAM)
    rig[place], rig["send"] = value, True
    rig.run_ms(40)
    assert (rig["sent"], rig["failed"], rig["sendStatus"]) == (0, 1, status)


def test_two_senders_at_one_module() -> None:
    rig = SerialRig(PROGRAM)
    job = rig.module.send(bytes(100))
    rig["send"] = True
    rig.run_ms(40)
    assert rig["sendStatus"] == 0x81D0
    rig.run_ms(100)
    assert job.over(rig.kernel.now_ns)


def test_a_stop_ends_what_is_being_sent_and_a_start_begins_anew() -> None:
    rig = SerialRig(PROGRAM)
    rig["send"] = True
    rig.run_ms(4)
    rig.cpu.stop()
    rig.run_ms(20)
    assert len(rig.peer.heard[0]) < len(_REQUEST)
    rig.cpu.start()
    rig.run_ms(20)
    assert (rig["sent"], rig["failed"], len(rig.peer.heard)) == (0, 0, 1)


@pytest.mark.parametrize("engine", ENGINES)
def test_a_job_ends_when_the_module_does_not_answer_any_more(engine: str) -> None:
    rig = SerialRig(PROGRAM, engine=engine)
    rig["send"] = True
    rig.run_ms(4)
    rig.module.failed = True
    rig.run_ms(40)
    assert (rig["sent"], rig["failed"], rig["sendStatus"]) == (0, 1, 0x8282)
    rig.module.failed = False
    rig.run_ms(40)
    assert (rig["sent"], rig["failed"]) == (0, 1)


def test_a_message_longer_than_the_buffer() -> None:
    rig = SerialRig(PROGRAM)
    rig["receive"] = True
    rig.peer.port.transmit(bytes(11))
    rig.run_ms(40)
    assert (rig["news"], rig["errors"], rig["status"]) == (0, 1, 0x8088)


def test_characters_with_another_parity_are_an_error() -> None:
    rig = SerialRig(PROGRAM)
    rig["receive"] = True
    rig.peer.port.format = type(rig.peer.port.format)(19_200, Parity.ODD, 2)
    rig.peer.port.transmit(REPLY)
    rig.run_ms(40)
    assert (rig["news"], rig["errors"], rig["status"]) == (0, 1, 0x81E1)


def test_messages_come_in_their_order_and_a_reset_deletes_them() -> None:
    rig = SerialRig(PROGRAM)
    for number in (1, 2, 3):
        rig.peer.port.transmit(bytes([number]))
        rig.run_ms(10)
    rig["receive"] = True
    rig.run_ms(6)
    rig["receive"], rig["reset"] = False, True
    rig.run_ms(15)
    rig["receive"] = True
    rig.run_ms(40)
    assert (rig["news"], rig["in"][0]) == (1, 1)


def test_the_receive_buffer_overflows() -> None:
    rig = SerialRig(PROGRAM)
    for _ in range(2):
        rig.peer.port.transmit(bytes(600))
        rig.run_ms(400)
    assert rig.module.lost_messages == 1
    assert [one.status for one in (rig.module.take(), rig.module.take()) if one] == [0x96, 0x81E0]


def test_a_loss_of_supply_forgets_what_was_received() -> None:
    rig = SerialRig(PROGRAM)
    rig.peer.port.transmit(b"\x05")
    rig.run_ms(20)
    rig.cpu.power_off()
    rig.peer.port.transmit(b"\x06")
    rig.run_ms(20)
    rig.cpu.power_on()
    rig.cpu.start()
    rig["receive"] = True
    rig.run_ms(40)
    assert (rig["news"], rig["errors"]) == (0, 0)


@pytest.mark.parametrize(
    ("conditions", "sent", "expected"),
    [
        (ReceiveConditions(fixed_length=3), b"ABCDEF", [(b"ABC", 0x94), (b"DEF", 0x94)]),
        (ReceiveConditions(gap_bits=None, message_ms=4), b"ABCDEFGHIJ", [(b"ABCDEFG", 0x95)]),
        (
            ReceiveConditions(end_sequence=(13,), start_character=40),
            b"xx(RFE03)\rzz",
            [(b"(RFE03)\r", 0x99)],
        ),
        (
            ReceiveConditions(start_sequences=((0x68, None, None, 0x68),), gap_bits=60),
            b"\x68\x68\x05\x05\x68\x01",
            [(b"\x68\x05\x05\x68\x01", 0x96)],
        ),
    ],
)
def test_where_a_message_begins_and_ends(
    conditions: ReceiveConditions, sent: bytes, expected: list[tuple[bytes, int]]
) -> None:
    rig = SerialRig(PROGRAM, conditions=conditions)
    rig.peer.port.transmit(sent)
    rig.run_ms(60)
    found = []
    while (message := rig.module.take()) is not None:
        found.append((message.data, message.status))
    assert found[: len(expected)] == expected
