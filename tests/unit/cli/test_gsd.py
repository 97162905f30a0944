"""`fbgen gsd`."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
ESCO = str(ROOT / "examples" / "manual_example" / "esco1803.gsd")
MADE_UP = str(ROOT / "tests" / "unit" / "wire" / "made_up_pbdp110.gsd")
MODULES = [
    "Module 1: one drive with parameters",
    "Module 2: two drives with parameters",
    "Module 3: one drive",
]


def shown(run_out: str) -> str:
    return run_out.replace(str(ROOT), "ROOT")


def test_the_file_of_the_tospbdp001_with_slots_and_addresses(
    fbgen: Fbgen, golden: Callable[[str, str], None]
) -> None:
    run = fbgen("gsd", ESCO, "--address", "256")
    assert (run.status, run.err) == (0, "")
    golden("gsd/esco1803.txt", shown(run.out))


def test_the_same_as_json(fbgen: Fbgen, golden: Callable[[str, str], None]) -> None:
    run = fbgen("gsd", ESCO, "--json")
    assert (run.status, run.err) == (0, "")
    golden("gsd/esco1803.json", run.out)


@pytest.mark.parametrize("name", MODULES)
def test_a_module_of_a_modular_station(
    name: str, fbgen: Fbgen, golden: Callable[[str, str], None]
) -> None:
    run = fbgen("gsd", MADE_UP, "--module", name, "--address", "512")
    assert (run.status, run.err) == (0, "")
    golden(f"gsd/made_up_{name[7]}.txt", shown(run.out))


def test_without_a_module_a_modular_station_shows_what_there_is(fbgen: Fbgen) -> None:
    run = fbgen("gsd", MADE_UP)
    assert run.status == 0
    assert "Module 4: two drives" in run.out
    assert run.out.endswith("--module NAME shows slots, addresses and access ways of a module.\n")
    assert json.loads(fbgen("gsd", MADE_UP, "--json").out)["chosen"] is None


def test_the_lines_for_the_plant_file_are_yaml(fbgen: Fbgen) -> None:
    out = fbgen("gsd", ESCO, "--address", "256").out
    lines = yaml.safe_load(out.partition("For the plant file\n")[2])
    assert lines == {
        "gsd": Path(ESCO).as_posix(),
        "modules": ["Binary Mode"],
        "access": "per_identifier",
        "input_address": 256,
        "output_address": 256,
    }


def test_directions_in_slots_of_their_own_are_told(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "two.gsd"
    path.write_text('#Profibus_DP\nIdent_Number = 1\nModule = "A" 0xA7,0x97\nEndModule\n')
    out = fbgen("gsd", str(path)).out
    assert "Here each direction is a slot of its own; dpxx_dat needs one slot for both." in out
    assert out.count("SFC14/15 only") == 2


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ((ESCO, "--module", "ASCII Mode"), "FB1310"),
        ((MADE_UP, "--module", MODULES[0], "--module", MODULES[1]), "FB1311"),
        (("no_such.gsd",), "FB1008"),
        ((str(ROOT / "tests" / "unit" / "bad" / "FB1301_no_gsd.gsd"),), "FB1301"),
    ],
)
def test_what_is_wrong_is_told(arguments: tuple[str, ...], code: str, fbgen: Fbgen) -> None:
    run = fbgen("gsd", *arguments)
    assert (run.status, run.out) == (1, "")
    assert f"error[{code}]" in run.err


def test_warnings_do_not_stop_it(fbgen: Fbgen) -> None:
    run = fbgen("gsd", str(ROOT / "tests" / "unit" / "bad" / "FB1308_misspelt.gsd"))
    assert run.status == 0
    assert "warning[FB1308]" in run.err
    assert "did you mean Freeze_Mode_supp?" in run.err
