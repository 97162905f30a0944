"""The 20 bytes that the operating system of an S7-300/400 puts into an organization block."""

import pytest

from fbgen.source import Source
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.loading import engine_named, read_program

START = bytes.fromhex("39 C4 1A 56 12 34 07 FF 01 02 03 04 24 02 29 13 14 15 67 85")

DATA = """
DATA_BLOCK "D"
STRUCT
    class : BYTE;
    station : DWORD;
    low : BYTE;
    racks : ARRAY[0..31] OF BOOL;
    minute : BYTE;
    own : INT;
END_STRUCT;
BEGIN
END_DATA_BLOCK
"""

SINGLE = """
ORGANIZATION_BLOCK OB86
VAR_TEMP
    EV_CLASS : BYTE;
    FLT_ID : BYTE;
    PRIORITY : BYTE;
    OB_NUMBR : BYTE;
    RESERVED_1 : BYTE;
    RESERVED_2 : BYTE;
    MDL_ADDR : WORD;
    Z23 : DWORD;
    DATE_TIME : ARRAY[0..7] OF BYTE;
    own : INT;
END_VAR
BEGIN
    D.class := EV_CLASS;
    D.station := Z23;
    D.minute := DATE_TIME[4];
    D.own := own;
    EV_CLASS := B#16#0;
    own := 5;
END_ORGANIZATION_BLOCK
"""

RACKS = """
ORGANIZATION_BLOCK OB86
VAR_TEMP
    HEAD : STRUCT
        EV_CLASS : BYTE;
        REST : ARRAY[2..7] OF BYTE;
    END_STRUCT;
    RACKS : ARRAY[0..31] OF BOOL;
    STAMP : DATE_AND_TIME;
    PARTS AT STAMP : ARRAY[0..7] OF BYTE;
END_VAR
BEGIN
    D.class := HEAD.EV_CLASS;
    D.racks := RACKS;
    D.minute := PARTS[4];
END_ORGANIZATION_BLOCK
"""


@pytest.fixture(params=["compiled", "reference"])
def run(request):
    """A program whose OB86 runs with a start information; gives what D holds afterwards."""

    def run(text, *starts, dialect="step7"):
        program = read_program([Source("ob86.scl", DATA + text)], dialect)
        engine = engine_named(request.param)(program, StandaloneEnvironment(), Limits())
        for start in starts:
            engine.run_block("OB86", start)
        return engine.global_value("D")

    return run


def test_the_temporary_data_begin_with_the_start_information(run):
    data = run(SINGLE, START)
    assert (data["class"], data["station"], data["minute"]) == (0x39, 0x01020304, 0x14)


def test_what_lies_behind_20_bytes_is_the_blocks_own(run):
    assert run(SINGLE, START)["own"] == 0


def test_without_start_information_it_is_zero(run):
    data = run(SINGLE, START, b"")
    assert (data["class"], data["station"]) == (0, 0)


def test_structures_arrays_and_overlays_show_their_bytes(run):
    data = run(RACKS, START)
    assert (data["class"], data["minute"]) == (0x39, 0x14)
    # 01 02 03 04: bit 0 of the first byte comes first
    assert [n for n, rack in enumerate(data["racks"]) if rack] == [0, 9, 16, 17, 26]
