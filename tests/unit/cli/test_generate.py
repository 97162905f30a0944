"""`fbgen generate`."""

import re
import shutil
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen

EXAMPLE = Path(__file__).parents[3] / "examples" / "manual_example" / "plant.yaml"


@pytest.fixture
def plant(tmp_path: Path) -> Path:
    return Path(shutil.copy(EXAMPLE, tmp_path / "plant.yaml"))


def test_standard_output_lists_what_was_written(fbgen: Fbgen, plant: Path) -> None:
    out = plant.parent / "out"
    run = fbgen("generate", str(plant), "-o", str(out))
    assert run.status == 0, run.err
    written = [Path(line) for line in run.out.splitlines()]
    assert written
    assert all(path.parent == out and path.is_file() for path in written)
    assert f"{len(written)} written, 0 unchanged, 0 removed in {out} (dialect tia)" in run.err


def test_a_second_run_writes_nothing(fbgen: Fbgen, plant: Path) -> None:
    arguments = ("generate", str(plant), "-o", str(plant.parent / "out"))
    count = len(fbgen(*arguments).out.splitlines())
    again = fbgen(*arguments)
    assert (again.status, again.out) == (0, "")
    assert f"0 written, {count} unchanged, 0 removed" in again.err


def test_what_is_generated_passes_the_check(fbgen: Fbgen, plant: Path) -> None:
    out = str(plant.parent / "out")
    assert fbgen("generate", str(plant), "-o", out).status == 0
    run = fbgen("check", out)
    assert run.status == 0, run.err


def test_another_dialect_can_be_asked_for(fbgen: Fbgen, plant: Path) -> None:
    text = plant.read_text(encoding="utf-8")
    plant.write_text(text.replace("per_identifier", "process_image"), encoding="utf-8")
    out = plant.parent / "out"
    run = fbgen("generate", str(plant), "-o", str(out), "--dialect", "iec")
    assert run.status == 0, run.err
    assert {Path(line).suffix for line in run.out.splitlines()} == {".st"}
    assert fbgen("check", str(out)).status == 0


@pytest.mark.parametrize("dialect", ["codesys", "cobol"])
@pytest.mark.parametrize("access", ["per_identifier", "process_image"])
def test_a_dialect_that_blocks_are_not_generated_in_is_wrong_usage(
    fbgen: Fbgen, plant: Path, dialect: str, access: str
) -> None:
    text = plant.read_text(encoding="utf-8")
    plant.write_text(text.replace("per_identifier", access), encoding="utf-8")
    out = plant.parent / "out"
    run = fbgen("generate", str(plant), "-o", str(out), "--dialect", dialect)
    assert (run.status, run.out, out.exists()) == (2, "", False)
    assert f"'{dialect}' is none of tia, step7, iec, twincat, plcopen" in run.err


def test_a_mistake_in_a_template_of_the_users_own_names_that_file(
    fbgen: Fbgen, plant: Path
) -> None:
    mine = plant.parent / "mine" / "blocks" / "TOS_TriggerCounter.scl.jinja"
    mine.parent.mkdir(parents=True)
    for text in ("{{ nothing_of_that_name }}\n", "FUNCTION_BLOCK\n"):
        mine.write_text(text, encoding="utf-8")
        run = fbgen("generate", str(plant), "-o", "out", "--templates", str(plant.parent / "mine"))
        assert (run.status, run.out) == (1, "")
        assert f"{mine}:1" in run.err


def test_a_file_changed_by_hand_is_kept_unless_forced(fbgen: Fbgen, plant: Path) -> None:
    arguments = ("generate", str(plant), "-o", str(plant.parent / "out"))
    path = Path(fbgen(*arguments).out.splitlines()[0])
    original = path.read_bytes()
    path.write_bytes(original + b"// mine\n")
    run = fbgen(*arguments)
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith(f"error[FB5020]: {path} ")
    assert path.read_bytes() == original + b"// mine\n"
    assert fbgen(*arguments, "--force").out == f"{path}\n"
    assert path.read_bytes() == original


def test_all_mistakes_of_a_plant_file_are_reported_and_nothing_is_written(
    fbgen: Fbgen, plant: Path
) -> None:
    text = plant.read_text(encoding="utf-8")
    plant.write_text(
        text.replace("profibus_address:", "profibus_adress:").replace("inv_no: 11", "inv_no: 1x"),
        encoding="utf-8",
    )
    out = plant.parent / "out"
    run = fbgen("generate", str(plant), "-o", str(out))
    assert (run.status, run.out) == (1, "")
    assert run.err.count("error[FB") >= 2
    assert f"--> {plant.as_posix()}:" in run.err
    assert not out.exists()


def test_a_missing_plant_file_is_a_diagnostic(fbgen: Fbgen, tmp_path: Path) -> None:
    run = fbgen("generate", str(tmp_path / "plant.yaml"), "-o", str(tmp_path / "out"))
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB1008]: ")


def test_step7_gets_one_source_and_the_symbol_table_in_front_of_it(
    fbgen: Fbgen, plant: Path
) -> None:
    out = plant.parent / "out"
    run = fbgen("generate", str(plant), "-o", str(out), "--dialect", "step7")
    assert run.status == 0, run.err
    assert [Path(line).name for line in run.out.splitlines()] == [
        "manual_example.sdf",
        "manual_example.scl",
    ]
    assert fbgen("check", str(out), "--dialect", "step7").status == 0
    table = (out / "manual_example.sdf").read_bytes()
    assert re.search(rb'"TOS_Main                ","FC    (2\d\d)   ","FC    \1 ","', table)


def test_block_numbers_of_the_command_line_take_the_place_of_the_plants(
    fbgen: Fbgen, plant: Path
) -> None:
    arguments = ("generate", str(plant), "-o", str(plant.parent / "out"), "--dialect", "step7")
    assert fbgen(*arguments, "--block-numbers", "500-599").status == 0
    table = (plant.parent / "out" / "manual_example.sdf").read_text("ascii")
    assert '"FC    500   ","FC    500 "' in table
    run = fbgen(*arguments, "--block-numbers", "500-502")
    assert run.status == 1
    assert "FB5011" in run.err


@pytest.mark.parametrize("given", ["500", "510-500", "0-20", "1-8000", "a-b"])
def test_what_is_no_range_of_block_numbers_is_wrong_usage(
    fbgen: Fbgen, plant: Path, given: str
) -> None:
    arguments = ("generate", str(plant), "-o", str(plant.parent / "out"), "--dialect", "step7")
    run = fbgen(*arguments, "--block-numbers", given)
    assert run.status == 2
    assert "is no range of numbers" in run.err


def test_block_numbers_are_for_step7_only(fbgen: Fbgen, plant: Path) -> None:
    run = fbgen("generate", str(plant), "-o", "out", "--block-numbers", "200-300")
    assert run.status == 2
    assert "dialect tia numbers no blocks" in run.err
