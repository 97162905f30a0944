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
    assert run.err == "files: 1, dialect: tia, errors: 0, warnings: 0\n"


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
    assert data["programs"] == [{"dialect": "tia", "files": [str(path)]}]
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


def test_folders_in_folders_are_looked_through_but_not_hidden_ones(
    fbgen: Fbgen, folder: Path
) -> None:
    for name in ("inner/deeper", ".git"):
        (folder / name).mkdir(parents=True)
        text = GOOD.replace("Twice", f"Of{name[-3:]}")
        (folder / name / "other.scl").write_text(text, encoding="utf-8")
    assert fbgen("check", str(folder)).err.startswith("files: 2, ")


def test_a_pattern_stands_for_the_files_that_match(fbgen: Fbgen, folder: Path) -> None:
    (folder / "inner").mkdir()
    (folder / "inner" / "bad.scl").write_text(BAD_TYPE, encoding="utf-8")
    assert fbgen("check", str(folder / "*.scl")).status == 0
    assert fbgen("check", str(folder / "inner" / "*.s?l")).status == 1
    assert fbgen("check", str(folder / "**" / "bad.scl")).status == 1
    run = fbgen("check", str(folder / "*.st"))
    assert (run.status, "no file is named like" in run.err) == (2, True)


def test_each_dialect_is_a_program_of_its_own(fbgen: Fbgen, folder: Path) -> None:
    text = "FUNCTION Twice : INT\nVAR_INPUT x : INT; END_VAR\nTwice := x * 2;\nEND_FUNCTION\n"
    (folder / "good.st").write_text(text, encoding="utf-8")
    run = fbgen("check", str(folder))
    assert (run.status, run.err) == (0, "files: 2, dialect: tia, iec, errors: 0, warnings: 0\n")
    assert fbgen("check", str(folder), "--jobs", "2").err == run.err


def test_files_whose_syntax_is_checked_are_shared_out(fbgen: Fbgen, folder: Path) -> None:
    for number in range(5):
        (folder / f"bad{number}.scl").write_text(BAD_SYNTAX, encoding="utf-8")
    alone = fbgen("check", str(folder), "--syntax-only")
    shared = fbgen("check", str(folder), "--syntax-only", "--jobs", "2")
    assert alone.status == 1
    assert shared == alone


def test_a_name_without_a_dialect_is_wrong_usage(fbgen: Fbgen, folder: Path) -> None:
    (folder / "a.txt").write_text(GOOD, encoding="utf-8")
    run = fbgen("check", str(folder / "a.txt"))
    assert (run.status, "does not tell its dialect" in run.err) == (2, True)
    assert fbgen("check", str(folder / "a.txt"), "--dialect", "tia").status == 0


@pytest.mark.parametrize("command", ["check", "fmt", "run"])
def test_a_name_that_is_not_there_is_called_that(
    fbgen: Fbgen, tmp_path: Path, command: str
) -> None:
    run = fbgen(command, str(tmp_path / "blokcs"))
    assert (run.status, run.out) == (2, "")
    assert f"there is no file or folder {tmp_path / 'blokcs'}" in " ".join(run.err.split())


def test_a_call_of_a_block_in_another_file_says_so(fbgen: Fbgen, folder: Path) -> None:
    (folder / "main.scl").write_text(GOOD.replace("#number * 2", '"Helper"(#number)'), "utf-8")
    run = fbgen("check", str(folder / "main.scl"))
    assert "error[FB4004]: there is no function or block 'Helper'" in run.err
    assert "name the file that has it as well" in run.err


@pytest.fixture
def warned(folder: Path) -> str:
    """A file with a warning and a hint."""
    path = folder / "warned.scl"
    path.write_text(
        GOOD.replace("#number *", "#NUMBER *").replace("END_VAR", "    spare : Int;\nEND_VAR")
    )
    return str(path)


def test_warnings_fail_only_when_asked_to(fbgen: Fbgen, warned: str) -> None:
    assert fbgen("check", warned).status == 0
    assert fbgen("check", warned, "--strict").status == 1
    assert fbgen("check", warned, "--strict", "--severity", "error").status == 1


@pytest.mark.parametrize(
    ("severity", "codes"),
    [("error", set()), ("warning", {"FB4201"}), ("info", {"FB4201", "FB4242"})],
)
def test_findings_are_shown_from_a_severity_on(
    fbgen: Fbgen, warned: str, severity: str, codes: set[str]
) -> None:
    run = fbgen("check", warned, "--severity", severity, "--format", "json")
    assert {item["code"] for item in json.loads(run.out)["diagnostics"]} == codes


@pytest.mark.parametrize(
    ("arguments", "status"),
    [
        ((), 0),
        (("--strict",), 1),
        (("--iec-check", "off", "--strict"), 0),
        (("--iec-check", "on"), 1),
        (("--cpu", "s7-300"), 0),
        (("--cpu", "s7-1500"), 1),
        (("--cpu", "s7-300", "--iec-check", "on"), 1),
    ],
)
def test_bytes_become_numbers_by_themselves_without_the_iec_check(
    fbgen: Fbgen, folder: Path, arguments: tuple[str, ...], status: int
) -> None:
    path = folder / "byte.scl"
    path.write_text(GOOD.replace("number : Int", "number : Byte").replace(" * 2", ""))
    assert fbgen("check", str(path), *arguments).status == status


def test_what_the_cpu_does_not_have_is_an_error(fbgen: Fbgen, folder: Path) -> None:
    path = folder / "long.scl"
    path.write_text(GOOD.replace("Int", "LInt"))
    assert fbgen("check", str(path), "--cpu", "s7-1500").status == 0
    assert (
        "error[FB4301]: s7-1200 has no type LINT"
        in fbgen("check", str(path), "--cpu", "s7-1200").err
    )


CODESYS = """\
FUNCTION_BLOCK Scale
VAR_INPUT raw : WORD; gain : DINT; END_VAR
VAR_OUTPUT value : REAL; n : INT; END_VAR
value := gain;
n := raw;
END_FUNCTION_BLOCK
"""


def test_conversions_of_codesys_make_an_st_one_of_dialect_twincat(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    path = tmp_path / "scale.st"
    path.write_text(CODESYS, encoding="utf-8")
    run = fbgen("check", str(path), "--format", "json")
    report = json.loads(run.out)
    assert run.status == 0
    assert [one["dialect"] for one in report["programs"]] == ["twincat"]
    assert [one["code"] for one in report["diagnostics"]] == ["FB9015", "FB4111"]
    assert (report["diagnostics"][0]["line"], report["diagnostics"][0]["column"]) == (4, 10)


def test_dialect_iec_names_the_dialect_that_converts_by_itself(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    path = tmp_path / "scale.st"
    path.write_text(CODESYS, encoding="utf-8")
    run = fbgen("check", str(path), "--dialect", "iec")
    assert run.status == 1
    assert run.err.count("--dialect twincat") == 2


def test_mistakes_that_no_dialect_mends_leave_an_st_what_it_is(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    path = tmp_path / "scale.st"
    text = CODESYS.replace("value := gain;", "value := TRUE;").replace("n := raw;", "")
    path.write_text(text, encoding="utf-8")
    run = fbgen("check", str(path))
    assert run.status == 1
    assert "dialect: iec, errors: 1" in run.err
