"""Which dialect a file without --dialect is in."""

from pathlib import Path

import pytest

from fbgen.cli.sources.plc_files import programs_of
from fbgen.lang.containers import read_document, told_dialect


@pytest.mark.parametrize(
    ("name", "text", "dialect"),
    [
        ("a.st", "PROGRAM p\nEND_PROGRAM\n", "iec"),
        ("a.st", "FUNCTION_BLOCK f\nMETHOD m\nEND_METHOD\nEND_FUNCTION_BLOCK\n", "iec"),
        ("a.st", "{attribute 'hide'}\nPROGRAM p\nEND_PROGRAM\n", "twincat"),
        ("a.st", "FUNCTION f : BOOL\nVAR p : POINTER TO INT; END_VAR\nEND_FUNCTION\n", "twincat"),
        ("a.xml", '<data name="http://www.3s-software.com/plcopenxml/method">', "twincat"),
        ("A.EXP", "PROGRAM p\nEND_PROGRAM\n", "twincat"),
        ("a.txt", "PROGRAM p\nEND_PROGRAM\n", None),
    ],
)
def test_a_file_tells_its_dialect(name: str, text: str, dialect: str | None) -> None:
    assert told_dialect(Path(name), text) == dialect


def test_the_st_beside_a_tcpou_is_of_the_same_program(tmp_path: Path) -> None:
    first, second = tmp_path / "a.st", tmp_path / "B.TcPOU"
    first.write_text("PROGRAM p\nEND_PROGRAM\n")
    second.write_text("<TcPlcObject/>")
    (program,) = programs_of([first, second], None)
    assert (program.dialect, program.paths) == ("twincat", (first, second))


def test_comments_of_codesys_stay_what_they_are(tmp_path: Path) -> None:
    path = tmp_path / "a.st"
    text = "PROGRAM p\nVAR x : INT; END_VAR\nx := 1; // one\nEND_PROGRAM\n"
    path.write_text("{attribute 'hide'}\n" + text)
    document = read_document(path)
    assert b"// one" in document.rewritten(document.file)


def test_code_in_c_is_read_over(tmp_path: Path) -> None:
    path = tmp_path / "a.st"
    path.write_text('PROGRAM p\n{{ if (x) { y("\'"); } }}\nEND_PROGRAM\n')
    document = read_document(path)
    assert document.findings == ()
    assert b'{{ if (x) { y("\'"); } }}' in document.rewritten(document.file)


def test_lists_of_plcopen_have_their_names(tmp_path: Path) -> None:
    path = tmp_path / "a.xml"
    path.write_text(
        '<project xmlns="http://www.plcopen.org/xml/tc6_0200"><types><dataTypes/><pous/></types>'
        '<addData><data name="x"><globalVars name="GVL"><variable name="a"><type><INT/></type>'
        "</variable></globalVars></data></addData></project>"
    )
    document = read_document(path)
    assert [getattr(unit, "name", None) for unit in document.file.units] == ["GVL"]
