"""Port_Config, Send_Config and Receive_Config, and what a loss of supply leaves of them."""

import pytest

from harness.line import Parity
from harness.plc.serial.conditions import LengthField, ReceiveConditions
from harness.plc.serial.configuring import read_conditions
from tests.unit.plc.serial_rig import SerialRig

PROGRAM = """\
DATA_BLOCK "Data"
{ S7_Optimized_Access := 'TRUE' }
VAR
   go : Bool; baud : UInt := 7; parity : UInt := 3; idle : UInt;
   conditions : Array[0..67] of Byte;
   done : Int; failed : Int; status : Word;
END_VAR
BEGIN
END_DATA_BLOCK
FUNCTION_BLOCK "Set"
VAR port : Port_Config; send : Send_Config; receive : Receive_Config; END_VAR
BEGIN
  #port(REQ := "Data".go, PORT := 270, BAUD := "Data".baud, PARITY := "Data".parity, STOPBITS := 2);
  #send(REQ := #port.DONE, PORT := 270, IDLELINE := "Data".idle);
  #receive(REQ := #send.DONE, PORT := 270, RECEIVE_CONDITIONS := "Data".conditions);
  IF #receive.DONE THEN "Data".done := "Data".done + 1; END_IF;
  IF #port.ERROR THEN "Data".failed := "Data".failed + 1; "Data".status := #port.STATUS; END_IF;
  IF #receive.ERROR THEN
    "Data".failed := "Data".failed + 1;
    "Data".status := #receive.STATUS;
  END_IF;
END_FUNCTION_BLOCK
DATA_BLOCK "Set_DB" "Set" BEGIN END_DATA_BLOCK
ORGANIZATION_BLOCK "Main"
BEGIN
  "Set_DB"();
END_ORGANIZATION_BLOCK
"""


def _conditions(start: int = 2, end: int = 4, **words: int) -> list[int]:
    """RECEIVE_CONDITIONS in memory, by the documented order of its members."""
    data = bytearray(68)
    data[0:2], data[38:40] = start.to_bytes(2, "big"), end.to_bytes(2, "big")
    places = {"idle": 2, "fixed": 40, "longest": 42, "n": 44, "size": 46, "rest": 48}
    places |= {"response": 50, "message": 52, "gap": 54}
    for name, value in words.items():
        data[places[name] : places[name] + 2] = value.to_bytes(2, "big")
    return list(data)


def test_the_module_is_set_until_its_supply_goes() -> None:
    rig = SerialRig(PROGRAM)
    rig["conditions"] = _conditions(gap=60)
    rig["idle"], rig["go"] = 22, True
    rig.run_ms(60)
    assert (rig["done"], rig["failed"]) == (1, 0)
    module = rig.module
    assert (module.port.format.parity, module.port.format.stop_bits) == (Parity.ODD, 2)
    assert (module.idle_bits, module.conditions) == (22, ReceiveConditions(gap_bits=60))
    rig.cpu.power_off()
    assert (module.port.format.parity, module.idle_bits) == (Parity.EVEN, 0)
    assert module.conditions == ReceiveConditions()


@pytest.mark.parametrize(("name", "value", "status"), [("baud", 13, 0x81A1), ("parity", 7, 0x81A2)])
def test_what_the_port_does_not_have(name: str, value: int, status: int) -> None:
    rig = SerialRig(PROGRAM)
    rig[name], rig["go"] = value, True
    rig.run_ms(30)
    assert (rig["done"], rig["failed"], rig["status"]) == (0, 1, status)


@pytest.mark.parametrize(
    ("conditions", "status"),
    [
        (_conditions(start=6), 0x81C0),
        (_conditions(end=0), 0x81C1),
        (_conditions(end=8, longest=0), 0x81C3),
        (_conditions(end=16, n=0, size=1), 0x81C4),
        (_conditions(end=16, n=1, size=3), 0x81C5),
        (_conditions(end=16, n=1, size=1, rest=256), 0x81C6),
        (_conditions(end=5, gap=9), 0x81C8),
        (_conditions(end=4), 0x81C9),
        (_conditions(end=32), 0x81CB),
        (_conditions(start=16, gap=9), 0x81CC),
    ],
)
def test_conditions_that_cannot_be(conditions: list[int], status: int) -> None:
    rig = SerialRig(PROGRAM)
    rig["conditions"], rig["go"] = conditions, True
    rig.run_ms(60)
    assert (rig["done"], rig["failed"], rig["status"]) == (0, 1, status)


def test_sequences_lie_where_their_table_says() -> None:
    data = bytearray(_conditions(start=0x21, end=0x70, fixed=9, n=2, size=1, rest=3))
    data[4] = 0x28
    data[14], data[16:21] = 0b01001, b"\x68\x00\x00\x68\x00"
    data[56], data[58:63] = 0b11000, b"\x00\x00\x00\x0d\x0a"
    assert read_conditions(bytes(data)) == ReceiveConditions(
        start_character=0x28,
        start_sequences=((0x68, None, None, 0x68, None),),
        gap_bits=None,
        fixed_length=9,
        length_field=LengthField(2, 1, 3),
        end_sequence=(0x0D, 0x0A),
    )
