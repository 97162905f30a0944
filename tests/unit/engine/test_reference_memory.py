"""Absolute addresses and areas of bytes in the reference evaluator."""

from collections.abc import Callable, Mapping

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Address, AddressRef, Assignment, Constant, Program
from fbgen.lang.types import WORD, Scalar
from fbgen.source import Source, Span
from harness.engine.environment import Area, StandaloneEnvironment
from harness.engine.interface import Engine, Limits
from harness.engine.loading import read_program
from harness.engine.reference import ReferenceEngine

ADDRESSES = """
FUNCTION_BLOCK "Addresses"
VAR_OUTPUT
    inputBit : BOOL;
    inputWord : WORD;
    direct : BYTE;
END_VAR
BEGIN
    #inputBit := %I1.3;
    #inputWord := %IW2;
    #direct := %IB4:P;
    %Q0.7 := TRUE;
    %QB1 := 16#A5;
    %QD4:P := 16#01020304;
    %Q9.2:P := TRUE;
    %MW10 := %MW10 + 1;
END_FUNCTION_BLOCK
"""

LOCATED = """
PROGRAM Main
VAR
    counter AT %MW4 : INT := 7;
    ratio AT %MD8 : REAL;
    letter AT %QB0 : CHAR;
END_VAR
    counter := counter - 10;
    ratio := -1.5;
END_PROGRAM
"""


def loaded(text: str, environment: StandaloneEnvironment, dialect: str = "tia") -> ReferenceEngine:
    program = read_program([Source("memory", text)], dialect)
    return ReferenceEngine(program, environment, Limits())


def test_addresses_reach_the_images_the_hardware_and_the_bit_memory() -> None:
    environment = StandaloneEnvironment()
    environment.inputs[1:5] = bytes((0x08, 0x12, 0x34, 0x56))
    environment.outputs[9] = 0xF0
    environment.markers[10:12] = b"\x00\xff"
    block = loaded(ADDRESSES, environment).instance("Addresses")
    block.call({})
    assert (block.get("inputBit"), block.get("inputWord"), block.get("direct")) == (
        True,
        0x1234,
        0x56,
    )
    assert environment.outputs[:8] == bytes((0x80, 0xA5, 0, 0, 1, 2, 3, 4))
    assert environment.outputs[9] == 0xF4
    assert environment.markers[10:12] == b"\x01\x00"


def test_located_variables_live_in_the_memory_of_the_controller() -> None:
    environment = StandaloneEnvironment()
    engine = loaded(LOCATED, environment, "iec")
    assert environment.markers[4:6] == b"\x00\x07"
    engine.run_block("main")
    assert environment.markers[4:6] == b"\xff\xfd"
    assert environment.markers[8:12] == b"\xbf\xc0\x00\x00"
    assert engine.global_value("Main.counter") == -3
    engine.set_global("Main.letter", "A")
    assert environment.outputs[0] == 0x41


def test_a_restart_gives_located_variables_their_initial_value() -> None:
    environment = StandaloneEnvironment()
    engine = loaded(LOCATED, environment, "iec")
    engine.run_block("Main")
    engine.reset(warm=False)
    assert engine.global_value("Main.counter") == 7


class Recording(StandaloneEnvironment):
    """A controller that notes instructions and moves bytes as DPRD_DAT and DPWR_DAT do."""

    def __init__(self) -> None:
        super().__init__()
        self.received = bytes(range(1, 9))
        self.sent = b""

    def instruction(self, name: str, arguments: Mapping[str, Scalar | Area], span: Span) -> Scalar:
        record = arguments["RECORD"]
        assert not isinstance(record, bool | int | float | str)
        if name == "DPRD_DAT":
            record.write(self.received[: record.length])
        else:
            self.sent = record.read()
        laddr = arguments["LADDR"]
        assert isinstance(laddr, int)
        return laddr


AREAS = """
TYPE "typeFrame"
VERSION : 0.1
    STRUCT
        ready : BOOL;
        trigger : BOOL;
        number : BYTE;
        comNo : WORD;
        data : ARRAY[1..2] OF BYTE;
    END_STRUCT;
END_TYPE

FUNCTION_BLOCK "Areas"
VAR_OUTPUT
    status : INT;
END_VAR
VAR
    frame : "typeFrame";
    single : BYTE;
END_VAR
BEGIN
    #status := DPRD_DAT(LADDR := 16#0102, RECORD => #frame);
    #frame.trigger := TRUE;
    #frame.data[2] := 16#EE;
    #status := #status + DPWR_DAT(LADDR := 1, RECORD := #frame);
    #status := #status + DPRD_DAT(LADDR := 1, RECORD => #single);
END_FUNCTION_BLOCK
"""


def test_instructions_get_variables_as_bytes_in_s7_layout() -> None:
    environment = Recording()
    block = loaded(AREAS, environment).instance("Areas")
    block.call({})
    assert block.get("status") == 0x0102 + 2
    assert block.get("frame") == {
        "ready": True,
        "trigger": True,
        "number": 2,
        "comNo": 0x0304,
        "data": [5, 0xEE],
    }
    assert environment.sent == bytes((3, 2, 3, 4, 5, 0xEE))
    assert block.get("single") == 1


def test_an_area_that_is_written_in_part_keeps_the_rest() -> None:
    environment = Recording()
    environment.received = b"\x00\x09"
    block = loaded(AREAS, environment).instance("Areas")
    block.set("frame", {"comNo": 0x1122})
    block.call({})
    assert block.get("frame.number") == 9
    assert block.get("frame.comNo") == 0x1122


DATA_BLOCKS = """
DATA_BLOCK "DB7"
    STRUCT
        flag : BOOL;
        speed : WORD;
        level : WORD;
    END_STRUCT;
BEGIN
    speed := 16#1234;
END_DATA_BLOCK

ORGANIZATION_BLOCK "Main"
BEGIN
    "DB7".level := 1;
END_ORGANIZATION_BLOCK
"""


def with_assignment(target: Address) -> Callable[[], Engine]:
    """A program whose OB assigns 16#BEEF to an address, which text cannot do yet."""

    def load() -> Engine:
        program = read_program([Source("db", DATA_BLOCKS)])
        block = program.blocks["main"]
        span = block.span
        place = AddressRef(span, target, WORD)
        body = (Assignment(span, place, Constant(span, 0xBEEF, WORD)),)
        changed = Program(
            dialect=program.dialect,
            blocks=program.blocks,
            bodies={block: body},
            structures=program.structures,
            globals=program.globals,
            standard_blocks=program.standard_blocks,
            byte_memory=frozenset((program.globals["db7"],)),
            data_blocks={7: program.globals["db7"]},
        )
        return ReferenceEngine(changed, StandaloneEnvironment(), Limits())

    return load


def test_a_data_block_is_addressed_by_its_number() -> None:
    engine = with_assignment(Address("DB", 16, 4, db=7))()
    engine.run_block("Main")
    assert engine.global_value("DB7") == {"flag": False, "speed": 0x1234, "level": 0xBEEF}


@pytest.mark.parametrize(
    ("address", "message"),
    [
        (Address("DB", 16, 4, db=8), "FB6011.*DB8"),
        (Address("DB", 16, 5, db=7), "FB6010.*%DB7.DBW5 lies outside of its area, which has 6"),
        (Address("Q", 16, 1023), "FB6010.*%QW1023"),
    ],
)
def test_an_address_that_is_not_there_is_reported(address: Address, message: str) -> None:
    with pytest.raises(DiagnosticError, match=message):
        with_assignment(address)().run_block("Main")
