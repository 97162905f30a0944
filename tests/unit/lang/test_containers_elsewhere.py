"""TwinCAT files that we write, read by a parser that we did not write: blark."""

from pathlib import Path

import pytest
from blark.parse import parse
from trees import read

from fbgen.lang.containers import new_files, read_document

_OBJECTS = sorted((Path(__file__).parent / "objects").iterdir())
_CORPUS = Path(__file__).parent.parent.parent / "corpus" / "twincat"
_NEWER_THAN_BLARK = "    rLocal : REFERENCE TO INT REF= counter;\n"
"""Since TwinCAT 3.1.4026."""


@pytest.mark.parametrize("path", _OBJECTS, ids=lambda path: path.name)
def test_blark_reads_formatted_objects(path: Path, tmp_path: Path) -> None:
    document = read_document(path)
    formatted = tmp_path / path.name
    formatted.write_bytes(document.rewritten(document.file))
    results = list(parse(formatted))
    assert results
    assert [(one.identifier, one.exception) for one in results if one.exception] == []


def test_blark_reads_new_objects(tmp_path: Path) -> None:
    text = (_CORPUS / "conveyor.st").read_text(encoding="utf-8")
    assert _NEWER_THAN_BLARK in text
    tree = read(text.replace(_NEWER_THAN_BLARK, ""), "twincat")
    identifiers: list[str | None] = []
    for new in new_files([tree], "twincat", "Lists"):
        path = tmp_path / new.name
        path.write_bytes(new.data)
        for result in parse(path):
            assert result.exception is None
            identifiers.append(result.identifier)
    assert {"Conveyor/implementation", "Conveyor.Count.set/implementation"} <= set(identifiers)
