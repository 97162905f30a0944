"""`fbgen diff`."""

import json
import shutil
from pathlib import Path

import pytest

from fbgen.resources import shipped
from tests.unit.cli.running import Fbgen

EXAMPLE = Path(__file__).parents[3] / "examples" / "manual_example" / "plant.yaml"


@pytest.fixture
def changed_catalog(tmp_path: Path) -> Path:
    """The shipped catalogue with one ComNo renumbered."""
    folder = Path(shutil.copytree(shipped("catalog"), tmp_path / "ours"))
    path = folder / "drives" / "vf-s11.yaml"
    path.write_text(path.read_text("utf-8").replace("number: FD01", "number: FD91"), "utf-8")
    for name in ("vf-as1", "vf-mb1", "vf-s15"):  # they name it, too
        path = folder / "drives" / f"{name}.yaml"
        path.write_text(path.read_text("utf-8").replace("FD01", "FD91"), "utf-8")
    return folder


def test_two_catalogues_and_a_plant(fbgen: Fbgen, changed_catalog: Path) -> None:
    run = fbgen("diff", "shipped", str(changed_catalog), "--plant", str(EXAMPLE))
    assert run.status == 1
    assert ": vf-s11.comnos.status.number: FD01 -> FD91\n" in run.out
    assert "   typeTosPolled.udt\n" in run.out
    assert "15 entries differ, " in run.err  # with the series that are like it, and their words


def test_the_same_as_json(fbgen: Fbgen, changed_catalog: Path) -> None:
    run = fbgen("diff", "shipped", str(changed_catalog), "--plant", str(EXAMPLE), "--json")
    data = json.loads(run.out)
    (entry,) = (item for item in data["entries"] if item["entry"].startswith("vf-s11."))
    assert (entry["kind"], entry["before"], entry["after"]) == ("changed", "FD01", "FD91")
    assert entry["file"].endswith("ours/drives/vf-s11.yaml")
    assert {line["sign"] for line in entry["lines"]} == {"-", "+"}
    assert (data["other_lines"], data["new_blocks"], data["removed_blocks"]) == ([], [], [])


def test_what_is_the_same_ends_with_0(fbgen: Fbgen) -> None:
    run = fbgen("diff", str(EXAMPLE), str(EXAMPLE))
    assert (run.status, run.out) == (0, "")


def test_two_plants_with_blocks_that_are_new_and_gone(fbgen: Fbgen, tmp_path: Path) -> None:
    other = tmp_path / "plant.yaml"
    text = EXAMPLE.read_text("utf-8")
    other.write_text(text.replace("[manual_example]", "[stop]"), "utf-8")
    run = fbgen("diff", str(EXAMPLE), str(other))
    assert run.status == 1
    assert "sequences: [manual_example] -> [stop]\n" in run.out
    assert "1 entry differs, " in run.err
    assert "new block: TOS_Seq_stop\n" in run.out
    assert "removed block: TOS_Seq_manual_example\n" in run.out


@pytest.mark.parametrize(
    "arguments",
    [
        ("shipped", "shipped"),
        (str(EXAMPLE), "shipped"),
        (str(EXAMPLE), str(EXAMPLE), "--plant", "x"),
    ],
)
def test_things_that_cannot_be_compared_are_wrong_usage(
    fbgen: Fbgen, arguments: tuple[str, ...]
) -> None:
    run = fbgen("diff", *arguments)
    assert (run.status, run.out) == (2, "")
