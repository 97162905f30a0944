"""`fbgen run`."""

import json
from pathlib import Path

import pytest

from harness.engine.loading import Clock
from tests.unit.cli.running import Fbgen

RAMP = """\
FUNCTION_BLOCK "Ramp"
VAR_INPUT
    target : Real;
    enable : Bool;
END_VAR
VAR_OUTPUT
    value : Real;
    atTarget : Bool;
END_VAR
VAR
    passes : Array[0..3] of Int;
    wait {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME;
END_VAR
BEGIN
    #wait(IN := #enable, PT := T#15ms);
    IF #wait.Q AND #value < #target THEN
        #value := #value + 0.5;
    END_IF;
    #atTarget := #value >= #target;
    #passes[1] := #passes[1] + 1;
    IF #passes[1] = 8 THEN
        #passes[#passes[1]] := 1;
    END_IF;
END_FUNCTION_BLOCK
"""
SCALE = """\
FUNCTION "HzToWord" : Word
VAR_INPUT
    hz : Real;
END_VAR
VAR_OUTPUT
    limited : Bool;
END_VAR
VAR_TEMP
    tempRaw : Int;
END_VAR
BEGIN
    #tempRaw := REAL_TO_INT(#hz * 100.0);
    #limited := #hz > 400.0;
    #HzToWord := INT_TO_WORD(#tempRaw);
END_FUNCTION
"""
PROGRAM = """\
PROGRAM Counter
VAR
    up : BOOL;
    count : INT;
END_VAR
    IF up THEN
        count := count + 1;
    END_IF;
END_PROGRAM
"""


@pytest.fixture
def ramp(tmp_path: Path) -> str:
    path = tmp_path / "ramp.scl"
    path.write_text(RAMP, encoding="utf-8")
    return str(path)


@pytest.fixture
def scale(tmp_path: Path) -> str:
    path = tmp_path / "scale.scl"
    path.write_text(SCALE, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_a_block_is_called_cycle_by_cycle(fbgen: Fbgen, ramp: str, engine: str) -> None:
    run = fbgen(
        *("run", ramp, "--cycles", "5", "--set", "enable=1@2", "--set", "target=1.0@10ms"),
        *("--watch", "value", "--watch", "wait.ET", "--watch", "atTarget", "--engine", engine),
    )
    assert (run.status, run.err) == (0, "")
    assert run.out.splitlines() == [
        "cycle  ms  value  wait.ET  atTarget",
        "-----  --  -----  -------  --------",
        "1      0   0.0    T#0ms    TRUE",
        "2      10  0.0    T#0ms    FALSE",
        "3      20  0.0    T#10ms   FALSE",
        "4      30  0.5    T#15ms   FALSE",
        "5      40  1.0    T#15ms   TRUE",
    ]


def test_without_watch_the_outputs_are_shown(fbgen: Fbgen, ramp: str) -> None:
    run = fbgen("run", ramp, "--cycles", "2", "--every", "1s", "--format", "csv")
    assert run.out == "cycle,ms,value,atTarget\n1,0,0.0,TRUE\n2,1000,0.0,TRUE\n"


@pytest.mark.parametrize(
    ("every", "times"),
    [
        ("20d", ["0", "1728000000", "3456000000"]),
        ("1234567ms", ["0", "1234567", "2469134"]),
        ("100ns", ["0", "0.0001", "0.0002"]),
    ],
)
def test_times_are_written_out(fbgen: Fbgen, ramp: str, every: str, times: list[str]) -> None:
    run = fbgen("run", ramp, "--cycles", "3", "--every", every, "--format", "csv")
    assert [line.split(",")[1] for line in run.out.splitlines()[1:]] == times


def test_only_changes_are_shown_if_asked_for(fbgen: Fbgen, ramp: str) -> None:
    run = fbgen(
        *("run", ramp, "--cycles", "7", "--set", "target=0.5", "--set", "enable=TRUE@3"),
        *("--changes", "--format", "csv"),
    )
    assert run.out.splitlines()[1:] == ["1,0,0.0,FALSE", "5,40,0.5,TRUE"]


def test_json_has_plain_values(fbgen: Fbgen, ramp: str) -> None:
    run = fbgen("run", ramp, "--cycles", "1", "--watch", "passes", "--format", "json")
    assert json.loads(run.out) == {
        "watched": ["passes"],
        "rows": [{"cycle": 1, "ns": 0, "values": [[0, 1, 0, 0]]}],
    }


def test_a_fault_ends_the_run_behind_the_rows_before_it(fbgen: Fbgen, ramp: str) -> None:
    run = fbgen("run", ramp, "--cycles", "20", "--watch", "passes[1]")
    assert run.status == 1
    assert run.out.splitlines()[-1] == "7      60  7"
    assert run.err.startswith("error[FB6002]: the index is 8, the array has 0..3\n")
    assert run.err.endswith("the rows above end in front of the fault\n")


@pytest.mark.parametrize("form", ["table", "csv"])
def test_ctrl_c_ends_the_run_behind_the_rows_before_it(
    fbgen: Fbgen, ramp: str, monkeypatch: pytest.MonkeyPatch, form: str
) -> None:
    def interrupt(clock: Clock, *, ns: int) -> None:
        if clock.now_ns >= 20_000_000:
            raise KeyboardInterrupt
        clock.kernel.run_for(ns)

    monkeypatch.setattr(Clock, "advance", interrupt)
    run = fbgen("run", ramp, "--cycles", "1000", "--format", form)
    assert (run.status, run.err) == (130, "")
    assert run.out.splitlines()[-1].split("," if form == "csv" else None)[:2] == ["3", "20"]


def test_a_function_keeps_its_inputs_and_shows_result_and_outputs(fbgen: Fbgen, scale: str) -> None:
    run = fbgen("run", scale, "--set", "hz=50.0", "--cycles", "1", "--format", "csv")
    assert run.out == "cycle,ms,HzToWord,limited\n1,0,16#1388,FALSE\n"


def test_what_a_function_forgets_cannot_be_watched(fbgen: Fbgen, scale: str) -> None:
    run = fbgen("run", scale, "--watch", "tempRaw")
    assert run.status == 1
    assert run.err.startswith("error[FB9012]: 'tempRaw' of HzToWord cannot be watched\n")


def test_a_program_shows_its_own_variables(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "counter.st"
    path.write_text(PROGRAM, encoding="utf-8")
    run = fbgen("run", str(path), "--set", "up=1@2", "--cycles", "3", "--format", "csv")
    assert run.out == "cycle,ms,up,count\n1,0,FALSE,0\n2,10,TRUE,1\n3,20,TRUE,2\n"


def test_a_name_is_needed_where_it_is_not_clear(fbgen: Fbgen, ramp: str, scale: str) -> None:
    run = fbgen("run", ramp, scale)
    assert run.status == 1
    assert run.err.startswith("error[FB9011]: which of the 2 blocks shall run?\n")
    assert "Ramp" in run.err
    assert fbgen("run", ramp, scale, "--block", "ramp", "--cycles", "1").status == 0


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (("--set", "start"), "FB9010", "'start' does not say what to set"),
        (("--every", "10"), "FB9010", "'10' is no time"),
        (("--set", "enable=1@-5ms"), "FB9010", "'@-5ms' of 'enable=1@-5ms' is neither a cycle nor"),
        (("--set", "enable=1@soon"), "FB9010", "'@soon' of 'enable=1@soon' is neither a cycle nor"),
        (("--set", "enable=1@0"), "FB9010", "'@0' of 'enable=1@0' is neither a cycle nor a time"),
        (("--set", "target=T#5s"), "FB9013", "'T#5s' is no value for target"),
        (("--set", "enabel=1"), "FB6020", "there is no variable 'enabel'"),
        (("--watch", "valu"), "FB6020", "there is no variable 'valu'"),
        (("--block", "Rump"), "FB6020", "there is no block 'Rump'"),
    ],
)
def test_mistakes_are_named_with_a_way_out(
    fbgen: Fbgen, ramp: str, arguments: tuple[str, ...], code: str, message: str
) -> None:
    run = fbgen("run", ramp, *arguments)
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith(f"error[{code}]: {message}")
    assert "= help: " in run.err


def test_all_mistakes_come_together(fbgen: Fbgen, ramp: str) -> None:
    run = fbgen("run", ramp, "--set", "target=x", "--set", "enabel=1", "--watch", "valu")
    assert [line[:13] for line in run.err.splitlines() if line.startswith("error")] == [
        "error[FB6020]",
        "error[FB9013]",
        "error[FB6020]",
    ]


def test_an_st_of_codesys_runs_without_a_dialect(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "scale.st"
    path.write_text(
        "FUNCTION_BLOCK Scale\nVAR_INPUT raw : WORD; END_VAR\nVAR_OUTPUT value : INT; END_VAR\n"
        "value := raw;\nEND_FUNCTION_BLOCK\n",
        encoding="utf-8",
    )
    run = fbgen("run", str(path), "--cycles", "1", "--set", "raw=7", "--format", "csv")
    assert (run.status, run.out) == (0, "cycle,ms,value\n1,0,7\n")
