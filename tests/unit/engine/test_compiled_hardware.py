"""What compiled blocks hand to the controller: areas of memory, addresses, the peripheral."""

from collections.abc import Mapping

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Address, AddressRef, Assignment, Constant, Program
from fbgen.lang.types import BOOL, BYTE, WORD, Scalar
from fbgen.source import Source, Span
from harness.engine.compiled import CompiledEngine
from harness.engine.environment import Area, StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.loading import engine_named, read_program
from harness.engine.reference import ReferenceEngine

ENGINES = ["compiled", "reference"]


class Module(StandaloneEnvironment):
    """A controller whose only module gives counting bytes and remembers what it was sent."""

    __slots__ = ("calls", "sent")

    def __init__(self) -> None:
        super().__init__()
        self.sent: list[bytes] = []
        self.calls: list[str] = []

    def instruction(self, name: str, arguments: Mapping[str, Scalar | Area], span: Span) -> Scalar:
        self.calls.append(f"{name} {arguments['LADDR']} {span.line}")
        record = arguments["RECORD"]
        assert not isinstance(record, bool | int | float | str)
        if arguments["LADDR"] == 0xDEAD:
            raise RuntimeError("the module is broken")
        if name == "DPRD_DAT":
            record.write(bytes(range(1, record.length + 1)))
        else:
            self.sent.append(record.read())
        return record.length


def run(engine: str, text: str) -> tuple[Module, CompiledEngine | ReferenceEngine]:
    module = Module()
    program = read_program([Source("main.scl", text)])
    loaded = engine_named(engine)(program, module, Limits())
    assert isinstance(loaded, CompiledEngine | ReferenceEngine)
    loaded.run_block("Main")
    return module, loaded


DATA = """
TYPE "typeFrame" STRUCT
    head : BYTE; ok : BOOL; number : DINT; part : ARRAY[0..2] OF BYTE; last : BOOL;
END_STRUCT; END_TYPE
DATA_BLOCK "Data" STRUCT
    bytes : ARRAY[0..7] OF BYTE; frame : "typeFrame"; word : WORD; result : INT; text : STRING[4];
END_STRUCT; BEGIN END_DATA_BLOCK
"""


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("place", ["bytes", "frame", "word", "bytes[3]", "word.%B1"])
def test_a_place_of_any_kind_can_be_read_into(place: str, engine: str) -> None:
    text = f"""{DATA}
FUNCTION "Main" : VOID
BEGIN
    "Data".result := DPRD_DAT(LADDR := 16#0100, RECORD => "Data".{place});
END_FUNCTION
"""
    module, loaded = run(engine, text)
    data = loaded.global_value("Data")
    _, reference = run("reference", text)
    assert data == reference.global_value("Data")
    assert module.calls == ["DPRD_DAT 256 11"]
    assert loaded.global_value("Data.result") != 0


@pytest.mark.parametrize("engine", ENGINES)
def test_temporaries_can_be_read_into_and_sent(engine: str) -> None:
    text = f"""{DATA}
FUNCTION "Main" : VOID
VAR_TEMP word : WORD; bytes : ARRAY[1..3] OF BYTE; frame : "typeFrame"; address : WORD; END_VAR
BEGIN
    #address := 16#0200;
    "Data".result := DPRD_DAT(LADDR := #address, RECORD => #word);
    "Data".word := #word;
    "Data".result := DPRD_DAT(LADDR := #address, RECORD => #bytes)
        + DPRD_DAT(LADDR := #address, RECORD => #frame);
    #bytes[2] := 16#FF;
    #frame.number := -2;
    "Data".result := DPWR_DAT(LADDR := #address, RECORD := #bytes);
    "Data".result := DPWR_DAT(LADDR := #address, RECORD := #frame);
    "Data".result := DPWR_DAT(LADDR := #address, RECORD := #word);
    "Data".bytes[0] := #bytes[1];
END_FUNCTION
"""
    module, loaded = run(engine, text)
    assert loaded.global_value("Data.word") == 0x0102
    assert loaded.global_value("Data.bytes[0]") == 1
    assert module.sent[0][:3] == bytes((1, 0xFF, 3))
    assert module.sent[1][2:6] == b"\xff\xff\xff\xfe"
    assert module.sent[2] == b"\x01\x02"


@pytest.mark.parametrize("engine", ENGINES)
def test_an_error_of_the_controller_comes_through_as_it_is(engine: str) -> None:
    text = f"""{DATA}
FUNCTION "Main" : VOID
BEGIN
    "Data".result := DPRD_DAT(LADDR := 16#DEAD, RECORD => "Data".word);
END_FUNCTION
"""
    with pytest.raises(RuntimeError, match="the module is broken"):
        run(engine, text)


@pytest.mark.parametrize("engine", ENGINES)
def test_addresses_of_all_areas_and_widths(engine: str) -> None:
    text = """
FUNCTION "Main" : VOID
BEGIN
    %MB0 := 16#81;
    %MX1.3 := %MX0.7;
    %MX0.7 := %MX0.1;
    %MW2 := 16#1234;
    %MD4 := SHL(IN := %MD0, N := 1);
    %QB4 := %MB2;
    %QX4.0 := TRUE;
    %QW6 := %MW2 XOR 16#FFFF;
    %QB8:P := %IB9:P;
END_FUNCTION
"""
    module = Module()
    program = read_program([Source("main.scl", text)])
    loaded = engine_named(engine)(program, module, Limits())
    module.inputs[9] = 0x5A
    loaded.run_block("Main")
    assert module.markers[:8] == bytes.fromhex("01 08 12 34 02 10 24 68")
    assert module.outputs[4:10] == bytes.fromhex("13 00 ed cb 5a 00")


@pytest.mark.parametrize("engine", ENGINES)
def test_located_variables_are_their_address(engine: str) -> None:
    text = """
PROGRAM Main
VAR
    level AT %IW2 : INT; valve AT %QX1.2 : BOOL; speed AT %QD4 : REAL; count : INT;
END_VAR
    valve := level < 0;
    speed := speed + 1.5;
    count := level;
END_PROGRAM
"""
    module = Module()
    program = read_program([Source("main.st", text)], "iec")
    loaded = engine_named(engine)(program, module, Limits())
    module.inputs[2:4] = b"\xff\xfe"
    loaded.run_block("Main")
    assert loaded.global_value("Main.count") == -2
    assert loaded.global_value("Main.level") == -2
    assert module.outputs[1] == 4
    assert module.outputs[4:8] == bytes.fromhex("3fc00000")
    loaded.set_global("Main.speed", 2.0)
    loaded.run_block("Main")
    assert loaded.global_value("Main.speed") == 3.5


@pytest.mark.parametrize("engine", ENGINES)
def test_bytes_of_data_blocks(engine: str) -> None:
    text = """
DATA_BLOCK "DB7" STRUCT a : INT := -2; b : BOOL; c : BOOL; d : WORD; END_STRUCT;
BEGIN END_DATA_BLOCK
FUNCTION "Main" : VOID
BEGIN
    ;
END_FUNCTION
"""
    program = read_program([Source("main.scl", text)])
    (block,) = program.blocks.values()

    def at(bits: int, byte: int, bit: int = 0, number: int = 7) -> AddressRef:
        kind = {1: BOOL, 8: BYTE, 16: WORD}[bits]
        return AddressRef(block.span, Address("DB", bits, byte, bit, number), kind)

    def loaded(*statements: Assignment) -> CompiledEngine | ReferenceEngine:
        bodies = {block: statements}
        changed = Program(
            program.dialect,
            program.blocks,
            bodies,
            program.structures,
            program.globals,
            program.standard_blocks,
            byte_memory=frozenset(program.globals.values()),
            data_blocks={7: program.globals["db7"]},
        )
        engine_for_it = engine_named(engine)(changed, StandaloneEnvironment(), Limits())
        assert isinstance(engine_for_it, CompiledEngine | ReferenceEngine)
        return engine_for_it

    fine = loaded(
        Assignment(block.span, at(1, 2, 1), Constant(block.span, True, BOOL)),
        Assignment(block.span, at(16, 4), at(16, 0)),
        Assignment(block.span, at(8, 1), Constant(block.span, 0x12, BYTE)),
    )
    fine.run_block("Main")
    assert fine.global_value("DB7") == {"a": -238, "b": False, "c": True, "d": 0xFFFE}
    for target, code in ((at(16, 6), "FB6010"), (at(16, 0, number=8), "FB6011")):
        with pytest.raises(DiagnosticError, match=code):
            loaded(Assignment(block.span, target, at(16, 0))).run_block("Main")


READING = """
FUNCTION_BLOCK "Reader"
VAR_IN_OUT single : BYTE; END_VAR
VAR a : BYTE; b : WORD; bits : ARRAY[0..1] OF BYTE; END_VAR
BEGIN
{}
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(
    ("statements", "places"),
    [
        ("#a := %IB1:P; #b := %IW2:P;", "1:1 2:2"),
        ("#a := %IB1:P; #b := SHL(IN := #b, N := 1); #a := %IB2:P; #b := W#16#1;", "1:1 2:1"),
        ("#b := %IW3:P; #a := %IB1:P;", "3:2 1:1"),
        ("#a := %IB1:P; #b := %IW2:P; #a := %IB3:P;", "1:1 2:2"),
        ("#b := %IW1:P; #a := %IB2:P;", ""),
        ("#a := %IB1:P; #single := %IB2:P;", "1:1 2:1"),
        ("#a := %IB1:P; %QB1:P := #a; #a := %IB2:P;", ""),
        ("#a := %IB1:P; #bits[BYTE_TO_INT(#a)] := %IB2:P;", ""),
        ("#a := %IB1:P; #b := %IW2;", ""),
    ],
)
def test_only_what_nothing_can_come_between_is_read_at_once(statements, places):
    text = source_of("Reader", READING.format(statements))
    assert asked_for(text, "read_several") == places


WRITING = """
FUNCTION_BLOCK "Writer"
VAR_IN_OUT single : BYTE; END_VAR
VAR a : BYTE; b : WORD; bits : ARRAY[0..1] OF BYTE; END_VAR
VAR_TEMP t : BYTE; u : BYTE; END_VAR
BEGIN
{}
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(
    ("statements", "places"),
    [
        ("%QB5:P := #a; %QW1:P := #b;", "5:1 1:2"),
        ("%QB1:P := #a; #t := WORD_TO_BYTE(#b); %QB2:P := #t; #a := 0;", "1:1 2:1"),
        ("%QB1:P := #a; %QB2:P := #a; %QB1:P := 0;", "1:1 2:1"),
        ("%QB1:P := #a; %QB1:P := #a;", ""),
        ("%QB1:P := #a; #a := #a + 1; %QB2:P := #a;", ""),
        ("%QB1:P := #t; #t := #a; %QB2:P := #t;", ""),
        ("%QB1:P := #a; #t := #a; %QB1:P := #t; #t := #u; %QB2:P := #t;", ""),
        ("%QB1:P := #single; %QB2:P := #a;", "1:1 2:1"),
        ("%QB1:P := #bits[BYTE_TO_INT(#a)]; %QB2:P := #a;", ""),
        ("%QB1:P := #a; %QB2:P := %IB1:P;", ""),
    ],
)
def test_only_what_may_be_worked_out_before_is_written_at_once(statements, places):
    text = source_of("Writer", WRITING.format(statements))
    assert asked_for(text, "write_several") == places


def test_what_may_lie_among_the_inputs_itself_is_not_read_at_once():
    text = READING.replace("FUNCTION_BLOCK", "FUNCTION").replace('"Reader"\n', '"Reader" : VOID\n')
    text = source_of("Reader", text.format("#a := %IB1:P; #single := %IB2:P;"))
    assert asked_for(text, "read_several") == ""


def source_of(block, text):
    program = read_program([Source("main.scl", text)])
    return CompiledEngine(program, StandaloneEnvironment()).python_source(block)


def asked_for(text, method):
    """The places of the one call of a method of the environment, "" if there is none."""
    _, found, behind = text.partition(f"_environment.{method}('")
    return behind.partition("'")[0] if found else ""
