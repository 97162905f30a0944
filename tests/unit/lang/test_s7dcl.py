"""Text documents of TIA Portal V20 and later: what an external source says, in another frame."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError, Severity
from fbgen.lang.ast import Block, DataBlock
from fbgen.lang.containers import Document, read_document
from fbgen.lang.formatting import format_file
from harness import load_program
from harness.engine.loading import ENGINES

PUMP = """{
    S7_Author := "Some Body";
    S7_EditorMode := "SCL";
    S7_Optimized := "TRUE";
    S7_Version := "1.2"
}
FUNCTION_BLOCK "Pump"
    VAR_INPUT
        {
            S7_Access := "ReadOnly := External";
            S7_Visibility := "Hidden := External"
        }
        start : Bool;
        network : Int;
    END_VAR
    VAR_OUTPUT
        running : Bool;
        total : Real;
    END_VAR
    VAR
        limits : _.typeLimits;
        edge : R_TRIG;
    END_VAR

    { S7_Language := "SCL"; S7_NetworkTitle := "MLC_1" }
    NETWORK
        REGION Description { S7_Language := "LAD" }
            { S7_MLC := "" }
        END_REGION
        // { no attribute } and no NETWORK
        #edge(CLK := #start);
        IF #edge.Q THEN
            #running := TRUE;
        END_IF;
    END_NETWORK
    { S7_Language := "SCL" }
    NETWORK
        #total := #limits.most + "Settings".offset + "Scaled"(raw := #network);
    END_NETWORK
END_FUNCTION_BLOCK
"""
LIMITS = """TYPE
    typeLimits : STRUCT
        least : Real;
        most : Real := 2.5;
    END_STRUCT;
END_TYPE
"""
SETTINGS = """{
    S7_Optimized := "TRUE"
}
DATA_BLOCK Settings
    VAR
        offset : Real;
        table : Array[0..2] of Int;
    END_VAR
    VAR RETAIN
        count : Int;
    END_VAR
    offset := 0.25;
    table[1] := 7;
END_DATA_BLOCK
"""
PRESET = "DATA_BLOCK Preset : _.typeLimits\n    most := 9.5;\nEND_DATA_BLOCK\n"
SCALED = """{ S7_Optimized := "FALSE" }
FUNCTION "Scaled" : _.Real
    VAR_INPUT
        raw : Int;
    END_VAR
    { S7_Language := "SCL" }
    NETWORK
        #Scaled := INT_TO_REAL(#raw) / 10.0;
    END_NETWORK
END_FUNCTION
"""
MIXED = """{ S7_PreferredLanguage := "LAD" }
FUNCTION "Mixed" : Void
    VAR_OUTPUT
        on : Bool;
    END_VAR
    { S7_Language := "LAD" }
    NETWORK
        RUNG wire#powerrail
            Contact( "start" )
            { S7_Templates := "time_type := Time" }
            Coil( #on )
        END_RUNG
    END_NETWORK
    { S7_Language := "SCL" }
    NETWORK
        #on := 1;
    END_NETWORK
END_FUNCTION
"""


def read(folder: Path, text: str) -> Document:
    path = folder / "Block.s7dcl"
    path.write_bytes(text.encode("utf-8-sig"))
    return read_document(path)


def test_a_block_is_read_as_from_an_external_source(tmp_path: Path) -> None:
    document = read(tmp_path, PUMP)
    assert (document.dialect, document.findings) == ("tia", ())
    (block,) = document.file.units
    assert isinstance(block, Block)
    header = [(item.keyword, item.text) for item in block.header]
    assert header[1:] == [("AUTHOR", "Some Body"), ("VERSION", "1.2")]
    assert [one.names[0].name for one in block.sections[0].declarations] == ["start", "network"]
    assert len(block.body) == 4


def test_places_are_those_in_the_document(tmp_path: Path) -> None:
    broken = PUMP.replace("#edge.Q THEN", "#edge.Q")
    (found,) = read(tmp_path, broken).findings
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == ("FB3001", 33, 13)
    assert found.span.source.line_text(33).strip() == "#running := TRUE;"


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_documents_run(tmp_path: Path, engine: str) -> None:
    texts = {"Pump": PUMP, "typeLimits": LIMITS, "Settings": SETTINGS, "Preset": PRESET}
    for name, text in {**texts, "Scaled": SCALED}.items():
        (tmp_path / f"{name}.s7dcl").write_text(text)
    program = load_program(sorted(tmp_path.iterdir()), engine=engine)
    pump = program.instance("Pump")
    pump(start=True, network=15)
    assert (pump.running, pump.total) == (True, 4.25)
    assert list(program.globals.Settings.table) == [0, 7, 0]
    assert program.globals.Preset.most == 9.5


def test_a_network_in_ladder_is_known_to_be_there(tmp_path: Path) -> None:
    document = read(tmp_path, MIXED)
    (found,) = document.findings
    assert (found.code, found.severity) == ("FB3017", Severity.WARNING)
    assert (found.span.line, found.span.column) == (7, 5)
    assert "Mixed is written in LAD" in found.message
    (block,) = document.file.units
    assert isinstance(block, Block)
    assert len(block.body) == 2
    assert block.body[1].span.line == 16


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_a_network_in_ladder_stops_the_run(tmp_path: Path, engine: str) -> None:
    path = tmp_path / "Mixed.s7dcl"
    path.write_text(MIXED)
    program = load_program([path], engine=engine)
    with pytest.raises(DiagnosticError, match="FB6072"):
        program.call("Mixed")


def test_start_values_need_no_begin(tmp_path: Path) -> None:
    for text, count in ((SETTINGS, 2), (PRESET, 1)):
        document = read(tmp_path, text)
        assert document.findings == ()
        (block,) = document.file.units
        assert isinstance(block, DataBlock)
        assert len(block.assignments) == count


@pytest.mark.parametrize("text", [PUMP, LIMITS, SETTINGS, MIXED, PUMP.replace("\n", "\r\n")])
def test_its_layout_is_left_to_tia_portal(tmp_path: Path, text: str) -> None:
    path = tmp_path / "Block.s7dcl"
    path.write_bytes(text.encode("utf-8-sig"))
    formatted = format_file(path)
    assert not formatted.is_broken
    assert formatted.after == formatted.before
