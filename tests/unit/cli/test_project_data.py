"""Constants, tags and numbers of data blocks, given to `fbgen check` and `fbgen run`."""

import json
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen

_BLOCK = """\
DATA_BLOCK "Exchange" { S7_Optimized_Access := 'FALSE' }
STRUCT
    first : Int;
    second : Int := 7;
END_STRUCT;
BEGIN
END_DATA_BLOCK

FUNCTION_BLOCK "Count"
VAR_OUTPUT
    most : Int;
    wait : Time;
    seen : Int;
    level : Int;
END_VAR
BEGIN
    #most := "MAX_PUMPS";
    #wait := "DELAY";
    #seen := WORD_TO_INT(%DB100.DBW2);
    #level := "Level";
END_FUNCTION_BLOCK
"""
_TAGS = "<Tagtable><Tag type='Int' addr='%MW20'>Level</Tag></Tagtable>\n"
_SYMBOLS = '"Level","MW     20  ","INT       ",""\n'
_CONSTANTS = ("--constant", "MAX_PUMPS=8", "--constant", '"DELAY"=T#1m30s')
_NUMBER = ("--db-number", "exchange=DB100")


@pytest.fixture
def block(tmp_path: Path) -> str:
    path = tmp_path / "count.scl"
    path.write_text(_BLOCK, encoding="utf-8")
    return str(path)


@pytest.fixture(params=[("tags.xml", _TAGS), ("symbols.sdf", _SYMBOLS)], ids=["xml", "sdf"])
def tags(tmp_path: Path, request: pytest.FixtureRequest) -> str:
    name, text = request.param
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_without_them_the_names_are_unknown(fbgen: Fbgen, block: str) -> None:
    run = fbgen("check", block)
    assert run.status == 1
    assert all(name in run.err for name in ("MAX_PUMPS", "DELAY", "Level"))
    assert "give it with --tags FILE or --constant NAME=VALUE" in run.err


def test_with_them_a_source_is_checked(fbgen: Fbgen, block: str, tags: str) -> None:
    run = fbgen("check", block, *_CONSTANTS, "--tags", tags, *_NUMBER)
    assert (run.status, "errors: 0" in run.err) == (0, True), run.err


def test_with_them_a_block_runs(fbgen: Fbgen, block: str, tags: str) -> None:
    given = (*_CONSTANTS, "--tags", tags, *_NUMBER)
    run = fbgen("run", block, "--cycles", "1", "--format", "json", *given)
    assert run.status == 0, run.err
    assert json.loads(run.out)["rows"][0]["values"] == [8, 90_000, 7, 0]


def test_without_its_number_a_data_block_is_not_found(fbgen: Fbgen, block: str, tags: str) -> None:
    run = fbgen("run", block, "--cycles", "1", *_CONSTANTS, "--tags", tags)
    assert run.status == 1
    assert run.err.startswith("error[FB6011]: there is no data block DB100")
    assert "--db-number NAME=100" in run.err


def test_several_processes_know_them_too(fbgen: Fbgen, block: str, tmp_path: Path) -> None:
    text = "PROGRAM p\nVAR n : INT; END_VAR\nn := MAX_PUMPS;\nEND_PROGRAM\n"
    (tmp_path / "p.st").write_text(text, encoding="utf-8")
    run = fbgen("check", str(tmp_path / "p.st"), block, *_CONSTANTS, "--jobs", "2")
    assert "MAX_PUMPS" not in run.err
    assert "Level" in run.err


def test_a_table_that_cannot_be_read_is_told_once_and_the_syntax_is_checked(
    fbgen: Fbgen, block: str, tmp_path: Path
) -> None:
    (tmp_path / "tags.xml").write_text(_TAGS.replace("%MW20", "%MW2000.9"), encoding="utf-8")
    (tmp_path / "p.st").write_text("PROGRAM p\nx := ;\nEND_PROGRAM\n", encoding="utf-8")
    run = fbgen(
        *("check", block, str(tmp_path / "p.st"), "--tags", str(tmp_path / "tags.xml")),
        *("--format", "json"),
    )
    assert run.status == 1
    found = [one["code"] for one in json.loads(run.out)["diagnostics"]]
    assert found.count("FB3060") == 1
    assert len(found) == 2


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (("--constant", "MAX"), "'MAX' gives no constant a value"),
        (("--constant", "=8"), "'=8' gives no constant a value"),
        (("--constant", "MAX=8", "--constant", "max=9"), "'max' is given twice"),
        (("--db-number", "Exchange"), "'Exchange' gives no data block a number (1 to 65535)"),
        (("--db-number", "Exchange=0"), "'Exchange=0' gives no data block a number (1 to 65535)"),
        (
            ("--db-number", "Exchange=first"),
            "'Exchange=first' gives no data block a number (1 to 65535)",
        ),
    ],
)
@pytest.mark.parametrize("command", ["check", "run"])
def test_what_gives_no_value_is_named(
    fbgen: Fbgen, block: str, command: str, given: tuple[str, ...], message: str
) -> None:
    run = fbgen(command, block, *given)
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith(f"error[FB9014]: {message}\n")


@pytest.mark.parametrize("command", ["check", "run"])
def test_a_constant_that_is_no_plc_value_is_named(fbgen: Fbgen, block: str, command: str) -> None:
    run = fbgen(command, block, "--constant", "MAX_PUMPS=many")
    assert run.status == 1
    assert "error[FB3060]: constant 'MAX_PUMPS' has the value 'many', which is none" in run.err


@pytest.mark.parametrize("command", ["check", "run"])
def test_a_number_for_a_data_block_that_is_not_there_is_an_error(
    fbgen: Fbgen, block: str, tags: str, command: str
) -> None:
    more = ("--cycles", "1") if command == "run" else ()
    given = (*_CONSTANTS, "--tags", tags, *_NUMBER, "--db-number", "Exchnage=101")
    run = fbgen(command, block, *more, *given)
    assert run.status == 1
    assert "error[FB4062]: a number is given to 'Exchnage', which is no data block" in run.err
    assert "did you mean 'Exchange'?" in run.err


def test_a_number_may_be_meant_for_another_program(
    fbgen: Fbgen, block: str, tags: str, tmp_path: Path
) -> None:
    other = tmp_path / "other.st"
    other.write_text("PROGRAM p\nVAR a : INT; END_VAR\na := 1;\nEND_PROGRAM\n", encoding="utf-8")
    given = (*_CONSTANTS, "--tags", tags, *_NUMBER)
    run = fbgen("check", block, str(other), *given)
    assert (run.status, "FB4062" in run.err) == (0, False), run.err
    again = fbgen("check", block, str(other), *given, "--db-number", "Nobody=3")
    assert (again.status, again.err.count("error[FB4062]")) == (1, 1)
