"""Sources of STEP 7 with instruction lists: interfaces, types and data are read, bodies are not."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError, Severity
from fbgen.lang.containers import Document, read_document
from fbgen.lang.formatting import format_file
from harness import load_program
from harness.engine.loading import ENGINES

SOURCE = """FUNCTION FC 10 : VOID
TITLE =Pumpe 1: it's on
VERSION : 0.1
VAR_INPUT
  ein : BOOL ;
END_VAR
VAR_TEMP
  hilf : INT ;
END_VAR
BEGIN
NETWORK
TITLE =doesn't matter

      U     #ein;
      SPBN  M001;
      L     5;
      T     #hilf;
M001: NOP   0;
NETWORK
TITLE =
// Kommentar
      U     E      0.0;
      =     A      4.0;
      CALL FC    11 (
           p1                       := #hilf);
      BE    ;
END_FUNCTION

FUNCTION FC 11 : INT
VAR_INPUT
  p1 : INT;
  at : UDT 10;
END_VAR
BEGIN
  FC11 := p1 + at.a;
END_FUNCTION

TYPE UDT 10
STRUCT
  a : INT := 2;
  since : DATE_AND_TIME := DT#90-1-1-0:0:0.000;
END_STRUCT
END_TYPE

DATA_BLOCK DB 10
STRUCT
  a : ARRAY[1..3] OF INT := 1, 2, 3;
  b : UDT 10;
END_STRUCT
BEGIN
  a[1] := 7;
  b.a := 4;
END_DATA_BLOCK
"""


def _read(folder: Path, text: str, name: str = "old.awl") -> Document:
    path = folder / name
    path.write_bytes(text.encode("latin-1"))
    return read_document(path)


@pytest.mark.parametrize("name", ["old.awl", "old.scl"])
def test_a_list_is_one_warning_and_the_rest_is_read(name: str, tmp_path: Path) -> None:
    document = _read(tmp_path, SOURCE, name)
    (found,) = document.findings
    assert (found.code, found.severity) == ("FB3017", Severity.WARNING)
    assert found.span is not None
    assert (found.span.line, found.span.column) == (11, 1)
    assert found.message == "the body of FC 10 is written in STL"
    assert document.dialect == "step7"
    assert len(document.file.units) == 4


def test_what_is_behind_a_list_is_found_where_it_stands(tmp_path: Path) -> None:
    document = _read(tmp_path, SOURCE.replace("FC11 := p1 + at.a;", "FC11 := p1 +;"))
    assert [(one.code, one.span.line) for one in document.findings if one.span] == [
        ("FB3017", 11),
        ("FB3001", 35),
    ]


def test_the_formatter_leaves_it_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "old.awl"
    path.write_text(SOURCE.replace("\n", "\r\n"))
    formatted = format_file(path)
    assert not formatted.is_broken
    assert formatted.after == formatted.before


def test_the_word_network_alone_is_no_list(tmp_path: Path) -> None:
    text = (
        "FUNCTION FC1 : VOID\nVAR_TEMP\nNETWORK : INT;\nEND_VAR\n"
        "BEGIN\nNETWORK := 1;\nEND_FUNCTION\n"
    )
    assert _read(tmp_path, text).findings == ()


@pytest.mark.parametrize("engine", sorted(ENGINES))
def test_what_is_no_list_runs_and_a_list_stops_the_run(tmp_path: Path, engine: str) -> None:
    path = tmp_path / "old.awl"
    path.write_text(SOURCE)
    program = load_program([path], dialect="step7", engine=engine)
    assert program.call("FC11", p1=3, at={"a": 4}) == 7
    assert list(program.globals["DB10"].a) == [7, 2, 3]
    assert program.globals["DB10"].b.a == 4
    with pytest.raises(DiagnosticError, match="FB6072"):
        program.call("FC10", ein=True)
