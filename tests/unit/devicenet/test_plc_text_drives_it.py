"""PLC text runs in the engine, the scanner carries its bytes, the drive does what the text says."""

from pathlib import Path

import pytest

from fbgen.wire.devicenet import Choice
from harness import load_program
from tests.unit.devicenet.bench import words
from tests.unit.devicenet.test_scanner import network

TEXT = """
FUNCTION_BLOCK "Fan"
VAR_INPUT
    start : Bool;
    reverse : Bool;
    wanted : Int;
    status : Word;
    speed : Int;
END_VAR
VAR_OUTPUT
    control : Word;
    reference : Int;
    atSpeed : Bool;
    enabled : Bool;
    faulted : Bool;
END_VAR
BEGIN
    #control := W#16#0060;
    IF #start AND #reverse THEN
        #control := #control OR W#16#0002;
    ELSIF #start THEN
        #control := #control OR W#16#0001;
    END_IF;
    #faulted := (#status AND W#16#0001) <> W#16#0000;
    IF #faulted AND NOT #start THEN
        #control := #control OR W#16#0004;
    END_IF;
    #reference := #wanted;
    #enabled := (#status AND W#16#0700) = W#16#0400;
    #atSpeed := (#status AND W#16#0080) <> W#16#0000 AND #speed = #wanted;
END_FUNCTION_BLOCK
"""


@pytest.mark.fact("dev.scanner")
@pytest.mark.parametrize("choice", [Choice.POLLED, Choice.POLLED | Choice.CHANGE_OF_STATE])
def test_a_block_starts_turns_resets_and_stops_the_drive(tmp_path: Path, choice: Choice) -> None:
    file = tmp_path / "fan.scl"
    file.write_text(TEXT, encoding="utf-8")
    program = load_program([file], dialect="tia")
    fan = program.instance("Fan")
    made = network({4: 21}, choice)
    slave, drive = made.scanner.slaves[4], made.drives[4]

    def scans(count: int, *, start: bool = False, reverse: bool = False, wanted: int = 0) -> None:
        for _ in range(count):
            data = slave.inputs
            fan(
                start=start,
                reverse=reverse,
                wanted=wanted,
                status=int.from_bytes(data[:2], "little"),
                speed=int.from_bytes(data[2:], "little"),
            )
            slave.outputs = words(fan.control, fan.reference)
            program.clock.advance(ms=10)
            made.run(10)

    scans(300)
    assert not drive.running
    scans(50, start=True, wanted=1500)
    assert fan.enabled
    assert fan.atSpeed
    assert (drive.direction, drive.frequency_hz) == ("forward", 50.0)
    scans(5)
    scans(60, start=True, reverse=True, wanted=900)
    assert fan.atSpeed
    assert (drive.direction, drive.frequency_hz) == ("reverse", 30.0)
    drive.trip("OC1")
    scans(20, start=True, reverse=True, wanted=900)
    assert fan.faulted
    assert not drive.running
    scans(20)
    assert not drive.tripped
    assert not fan.faulted
    scans(50, start=True, wanted=600)
    assert fan.atSpeed
    assert drive.frequency_hz == 20.0
