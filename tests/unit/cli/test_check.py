"""`fbgen check`."""

import json
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen

GOOD = """\
FUNCTION "Twice" : Int
VAR_INPUT
    number : Int;
END_VAR
BEGIN
    #Twice := #number * 2;
END_FUNCTION
"""
BAD_SYNTAX = GOOD.replace("#number * 2", "#number *")
BAD_TYPE = GOOD.replace("#number * 2", "TRUE")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "good.scl").write_text(GOOD, encoding="utf-8")
    return tmp_path


def test_text_without_mistakes_is_status_0(fbgen: Fbgen, folder: Path) -> None:
    run = fbgen("check", str(folder / "good.scl"))
    assert (run.status, run.out) == (0, "")
    assert run.err == "files: 1, dialect: tia, errors: 0, other findings: 0\n"


def test_a_mistake_is_shown_with_its_place(fbgen: Fbgen, folder: Path) -> None:
    path = folder / "bad.scl"
    path.write_text(BAD_SYNTAX, encoding="utf-8")
    run = fbgen("check", str(path))
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB3")
    assert f"--> {path}:6:" in run.err


def test_a_wrong_type_is_found_unless_only_syntax_is_asked_for(fbgen: Fbgen, folder: Path) -> None:
    path = folder / "bad.scl"
    path.write_text(BAD_TYPE, encoding="utf-8")
    assert "error[FB4" in fbgen("check", str(path)).err
    assert fbgen("check", str(path), "--syntax-only").status == 0


def test_json_lists_the_findings_on_standard_output(fbgen: Fbgen, folder: Path) -> None:
    path = folder / "bad.scl"
    path.write_text(BAD_SYNTAX, encoding="utf-8")
    run = fbgen("check", str(path), "--format", "json")
    data = json.loads(run.out)
    assert (run.status, run.err) == (1, "")
    assert (data["dialect"], data["files"]) == ("tia", [str(path)])
    assert [item["line"] for item in data["diagnostics"]] == [6]


def test_a_folder_stands_for_the_plc_texts_in_it(fbgen: Fbgen, folder: Path) -> None:
    (folder / "other.SCL").write_text(GOOD.replace("Twice", "Thrice"), encoding="utf-8")
    (folder / "notes.txt").write_text("no PLC text", encoding="utf-8")
    run = fbgen("check", str(folder))
    assert (run.status, run.err.partition(",")[0]) == (0, "files: 2")


def test_a_folder_without_plc_text_is_wrong_usage(fbgen: Fbgen, tmp_path: Path) -> None:
    run = fbgen("check", str(tmp_path))
    assert (run.status, run.out) == (2, "")
    assert "there is no file with PLC text" in run.err


def test_all_files_are_read_before_the_command_gives_up(fbgen: Fbgen, folder: Path) -> None:
    bad = folder / "bad.scl"
    bad.write_text(BAD_SYNTAX, encoding="utf-8")
    run = fbgen("check", str(folder / "missing.scl"), str(bad))
    assert run.status == 1
    assert "missing.scl" in run.err
    assert f"--> {bad}:6:" in run.err


@pytest.mark.parametrize("content", [b"", b"\x00\xff\xfe", b"\xff\xfe\x00", bytes(range(256))])
def test_any_bytes_give_an_answer(fbgen: Fbgen, tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "any.scl"
    path.write_bytes(content)
    assert fbgen("check", str(path)).status in (0, 1)
