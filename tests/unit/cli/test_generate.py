"""`fbgen generate`."""

import re
import shutil
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen

BESIDE = {".csv", ".xlsx", ".md"}
"""The suffixes of files beside the PLC text."""

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
    assert {Path(line).suffix for line in run.out.splitlines()} - BESIDE == {".st"}
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
    assert [Path(line).name for line in run.out.splitlines()][:5] == [
        "manual_example.sdf",
        "manual_example.scl",
        "manual_example_parameters.scl",
        "manual_example_calls.scl",
        "manual_example_error_obs.scl",
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


def test_check_lists_what_would_change_and_writes_nothing(fbgen: Fbgen, plant: Path) -> None:
    out = plant.parent / "out"
    arguments = ("generate", str(plant), "-o", str(out))
    run = fbgen(*arguments, "--check")
    assert (run.status, out.exists()) == (1, False)
    assert str(out / "TOS_Main.scl") in run.out.splitlines()
    written = fbgen(*arguments).out
    assert run.out == written
    again = fbgen(*arguments, "--check")
    assert (again.status, again.out) == (0, "")
    (out / "TOS_Main.scl").unlink()
    last = fbgen(*arguments, "--check")
    assert (last.status, last.out) == (1, f"{out / 'TOS_Main.scl'}\n")
    assert "1 would be written" in last.err


def test_check_names_files_of_a_persons_own(fbgen: Fbgen, plant: Path) -> None:
    out = plant.parent / "out"
    arguments = ("generate", str(plant), "-o", str(out))
    fbgen(*arguments)
    with (out / "TOS_Main.scl").open("a") as file:
        file.write("// mine\n")
    run = fbgen(*arguments, "--check")
    assert (run.status, run.out) == (1, f"{out / 'TOS_Main.scl'}\n")
    assert "FB5020" in run.err
    assert "// mine" in (out / "TOS_Main.scl").read_text("ascii")


def test_diff_prints_what_would_change_and_writes_nothing(fbgen: Fbgen, plant: Path) -> None:
    out = plant.parent / "out"
    arguments = ("generate", str(plant), "-o", str(out))
    fbgen(*arguments)
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    text = plant.read_text("utf-8")
    plant.write_text(text.replace("inv_no: 11", "inv_no: 12"), "utf-8")
    run = fbgen(*arguments, "--diff")
    assert run.status == 0
    assert f"--- {out / 'TOS_Gateway_gw1.scl'}\n" in run.out
    assert re.search(r"(?m)^-.*16#0B", run.out)
    assert re.search(r"(?m)^\+.*16#0C", run.out)
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before
    assert fbgen(*arguments, "--diff", "--check").status == 1


def test_what_diff_prints_is_what_patch_applies(fbgen: Fbgen, plant: Path) -> None:
    out = plant.parent / "out"
    run = fbgen("generate", str(plant), "-o", str(out), "--diff")
    added = [line[1:] for line in run.out.splitlines() if re.match(r"\+(?!\+\+ )", line)]
    files = fbgen("generate", str(plant), "-o", str(out)).out.splitlines()
    texts = [path for path in files if not path.endswith(".xlsx")]
    assert added == [line for path in texts for line in Path(path).read_text().splitlines()]
    assert run.out.count("--- /dev/null\n") == len(texts)
    assert run.out.count("Binary files ") == len(files) - len(texts) > 0


@pytest.mark.parametrize(
    ("dialect", "layout", "names"),
    [
        ("tia", "one", {"manual_example.scl", "TOS_Parameters.db"}),
        ("tia", "per_block", {"TOS_Main.scl", "TOS_Plant.db", "typeTosDrive.udt"}),
        (
            "step7",
            "one",
            {
                "manual_example.scl",
                "manual_example_parameters.scl",
                "manual_example_calls.scl",
                "manual_example_error_obs.scl",
                "manual_example.sdf",
            },
        ),
        ("step7", "per_block", {"TOS_Main.scl", "OB86.scl", "TOS_Plant.scl", "manual_example.sdf"}),
        ("iec", "one", {"manual_example.st"}),
        ("iec", "per_block", {"TOS_Main.st", "typeTosDrive.st", "manual_example.st"}),
        ("twincat", "per_block", {"TOS_Main.TcPOU", "typeTosDrive.TcDUT"}),
        ("plcopen", "one", {"manual_example.xml"}),
    ],
)
def test_one_file_or_one_for_each_block(
    fbgen: Fbgen, plant: Path, dialect: str, layout: str, names: set[str]
) -> None:
    text = plant.read_text(encoding="utf-8")
    plant.write_text(text.replace("per_identifier", "process_image"), encoding="utf-8")
    out = plant.parent / "out"
    arguments = ("generate", str(plant), "-o", str(out), "--dialect", dialect, "--files", layout)
    run = fbgen(*arguments)
    assert run.status == 0, run.err
    text_files = [line for line in run.out.splitlines() if Path(line).suffix not in BESIDE]
    written = {Path(line).name for line in text_files if "_watch_" not in line}
    assert names <= written
    if layout == "one":
        assert names == written
    texts = [line for line in text_files if Path(line).name in written - {"manual_example.sdf"}]
    checked = fbgen("check", *texts, *(("--dialect", dialect) if dialect == "step7" else ()))
    assert checked.status == 0, checked.err


@pytest.mark.parametrize(("dialect", "layout"), [("twincat", "one"), ("plcopen", "per_block")])
def test_files_that_a_dialect_leaves_no_choice_about_are_fb2022(
    fbgen: Fbgen, plant: Path, dialect: str, layout: str
) -> None:
    text = plant.read_text(encoding="utf-8")
    plant.write_text(text.replace("per_identifier", "process_image"), encoding="utf-8")
    run = fbgen("generate", str(plant), "-o", "o", "--dialect", dialect, "--files", layout)
    assert (run.status, run.out) == (1, "")
    assert "error[FB2022]" in run.err


def test_a_layout_of_files_that_there_is_not_is_wrong_usage(fbgen: Fbgen, plant: Path) -> None:
    run = fbgen("generate", str(plant), "-o", "out", "--files", "two")
    assert run.status == 2
    assert "'two' is none of one, per_block" in run.err


@pytest.mark.parametrize(
    ("prefix", "hint"), [("1HALL", "underscore at the end: HALL_"), ("A" * 20 + "_", "at most")]
)
def test_a_wrong_prefix_is_wrong_usage_not_a_mistake_of_the_plant_file(
    fbgen: Fbgen, plant: Path, prefix: str, hint: str
) -> None:
    run = fbgen("generate", str(plant), "-o", "out", "--prefix", prefix)
    assert run.status == 2
    assert "--prefix" in run.err
    assert hint in " ".join(run.err.split())
    assert "plant.yaml" not in run.err


def test_renamed_removed_and_kept_are_told(fbgen: Fbgen, plant: Path) -> None:
    out = plant.parent / "out"
    arguments = ("generate", str(plant), "-o", str(out))
    fbgen(*arguments)
    (out / "TOS_Main.scl").write_text("mine\n")
    run = fbgen(*arguments, "--prefix", "HALL_")
    assert run.status == 0, run.err
    assert "renamed block: TOS_Main is now HALL_Main\n" in run.err
    assert f"kept: {out / 'TOS_Main.scl'} is not generated any more" in run.err
    assert (out / "TOS_Main.scl").read_text() == "mine\n"
    assert not (out / "TOS_Line.scl").exists()
