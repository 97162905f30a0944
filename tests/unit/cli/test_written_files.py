"""Files that commands write: `fbgen init`, `fbgen schemas`."""

import json
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]


def test_init_writes_a_plant_file_that_is_valid(fbgen: Fbgen, tmp_path: Path) -> None:
    run = fbgen("init", str(tmp_path / "new" / "folder"))
    path = tmp_path / "new" / "folder" / "plant.yaml"
    sequence = path.parent / "sequences" / "start_and_wait.yaml"
    assert (run.status, run.out) == (0, f"{path}\n{sequence}\n")
    assert load_plant(path, load_catalog()).gateways


def test_the_sequence_that_init_writes_becomes_a_block(fbgen: Fbgen, tmp_path: Path) -> None:
    assert fbgen("init", str(tmp_path)).status == 0
    path = tmp_path / "plant.yaml"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("# - start_and_wait", "- start_and_wait"), encoding="utf-8")
    run = fbgen("generate", str(path), "-o", str(tmp_path / "out"))
    assert (run.status, run.err.count("warning")) == (0, 0), run.err
    assert (tmp_path / "out" / "TOS_Seq_start_and_wait.scl").is_file()


def test_init_never_overwrites_without_force(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "plant.yaml"
    path.write_text("mine", encoding="utf-8")
    run = fbgen("init", str(tmp_path))
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith(f"error[FB9001]: {path} is already there\n")
    assert path.read_text(encoding="utf-8") == "mine"
    assert fbgen("init", str(tmp_path), "--force").status == 0
    assert path.read_text(encoding="utf-8") != "mine"


def test_init_twice_without_a_change_is_no_error(fbgen: Fbgen, tmp_path: Path) -> None:
    assert [fbgen("init", str(tmp_path)).status for _ in range(2)] == [0, 0]


def test_a_place_that_cannot_be_written_is_fb9002(fbgen: Fbgen, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    run = fbgen("init", str(tmp_path / "file"))
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9002]: ")
    assert "cannot be written: a file stands where a folder is meant\n" in run.err


def test_a_failed_write_leaves_nothing_behind(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    run = fbgen("init", str(tmp_path))
    assert "No space left on device" in run.err
    assert list(tmp_path.iterdir()) == []


def test_the_schemas_in_the_repository_are_what_the_command_writes(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    run = fbgen("schemas", str(tmp_path))
    assert run.status == 0
    written = {path.name: path.read_text(encoding="utf-8") for path in tmp_path.iterdir()}
    checked_in = {
        path.name: path.read_text(encoding="utf-8") for path in (ROOT / "schemas").iterdir()
    }
    assert written == checked_in, "make schemas writes them anew"
    assert len(run.out.splitlines()) == len(written)


def test_every_shipped_yaml_file_names_a_schema_that_exists() -> None:
    for folder in ("catalog", "examples"):
        for path in set((ROOT / folder).rglob("*.yaml")) - set((ROOT / "examples/ci").iterdir()):
            first = path.read_text(encoding="utf-8").splitlines()[0]
            assert first.startswith("# yaml-language-server: $schema="), path
            schema = path.parent / first.partition("=")[2]
            assert json.loads(schema.read_text(encoding="utf-8"))["title"], path
