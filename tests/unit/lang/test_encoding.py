"""Files as they come."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.containers import read_document
from fbgen.lang.encoding import decode, read_source

_TEXT = "x := 'Größe';\r\n"


@pytest.mark.parametrize(
    "data",
    [
        _TEXT.encode("utf-8"),
        _TEXT.encode("utf-8-sig"),
        _TEXT.encode("utf-16"),
        b"\xfe\xff" + _TEXT.encode("utf-16-be"),
        _TEXT.encode("cp1252"),
    ],
)
def test_every_encoding_gives_the_same_text(data: bytes) -> None:
    assert decode(data, "x") == _TEXT


@pytest.mark.parametrize("data", [b"\x81\x8d", b"\xff\xfea", b"\xef\xbb\xbf\xff"])
def test_what_is_no_text_is_a_finding(data: bytes) -> None:
    with pytest.raises(DiagnosticError) as problem:
        decode(data, "x")
    assert [found.code for found in problem.value.diagnostics] == ["FB3013"]


def test_the_broken_file_is_no_text() -> None:
    path = Path(__file__).parent.parent / "bad" / "FB3013_bytes.scl"
    with pytest.raises(DiagnosticError, match="FB3013"):
        read_source(path)


def test_a_file_is_named_by_its_path(tmp_path: Path) -> None:
    path = tmp_path / "pump.scl"
    path.write_bytes(b"\xef\xbb\xbfx")
    source = read_source(path)
    assert (source.name, source.text) == (str(path), "x")


@pytest.mark.parametrize("name", ["missing.scl", "."])
def test_a_file_that_cannot_be_read_is_a_finding(tmp_path: Path, name: str) -> None:
    with pytest.raises(DiagnosticError) as problem:
        read_source(tmp_path / name)
    assert [found.code for found in problem.value.diagnostics] == ["FB3014"]


_BLOCK = 'FUNCTION "F" : Void\nVERSION : 0.1\n\nBEGIN\n   // Größe\n   #x := 1;\nEND_FUNCTION\n'


@pytest.mark.parametrize("line_end", ["\n", "\r\n"])
@pytest.mark.parametrize(
    ("bom", "codec"),
    [
        (b"", "utf-8"),
        (b"\xef\xbb\xbf", "utf-8"),
        (b"\xff\xfe", "utf-16-le"),
        (b"\xfe\xff", "utf-16-be"),
        (b"", "cp1252"),
    ],
)
def test_a_printed_file_keeps_encoding_mark_and_line_ends(
    tmp_path: Path, bom: bytes, codec: str, line_end: str
) -> None:
    path = tmp_path / "f.scl"
    data = bom + _BLOCK.replace("\n", line_end).encode(codec)
    path.write_bytes(data)
    document = read_document(path)
    assert document.findings == ()
    assert document.rewritten(document.file) == data
