"""Fixtures of the pytest plugin: programs, and plants that are on."""

import re
import shutil

import pytest

from tests.unit.scenario.block_scenarios import TANK
from tests.unit.scenario.scenario_files import PLANT, ROOT

pytest_plugins = ["pytester"]
PLUGIN = ("-p", "harness.pytest_plugin", "-p", "no:cacheprovider", "--strict-markers")
MARK = f"import pytest\n\n@pytest.mark.fbgen(plant={PLANT.as_posix()!r}, seed=3)\n"


def ran(pytester: pytest.Pytester, text: str, *arguments: str) -> pytest.RunResult:
    """A module with these tests."""
    pytester.makepyfile(text)
    return pytester.runpytest(*PLUGIN, *arguments)


def test_plc_loads_the_files_beside_the_test(pytester: pytest.Pytester) -> None:
    (pytester.path / "tank.scl").write_text(TANK, "utf-8")
    text = """
def test_tank(plc):
    tank = plc("tank.scl", engine="reference").instance("Tank")
    tank(start=True)
    assert tank.calls == 1
"""
    ran(pytester, text).assert_outcomes(passed=1)


def test_a_plant_is_on_and_has_its_line_drive_and_faults(pytester: pytest.Pytester) -> None:
    text = f"""{MARK}
def test_drive(plant, line, drive, faults):
    assert plant.kernel.seed == 3
    assert line is plant.lines["gw1"]
    plant.run_for(100_000_000)
    assert plant.gateways["gw1"].slave.online
    faults.inject("drive_unpowered", on="pump")
    assert not drive.powered
    faults.clear("drive_unpowered", on="pump")
    assert drive.powered
"""
    ran(pytester, text).assert_outcomes(passed=1)


def test_the_seed_of_the_command_takes_the_place_of_the_markers(
    pytester: pytest.Pytester,
) -> None:
    text = f"{MARK}def test_seed(plant):\n    assert plant.kernel.seed == 9\n"
    ran(pytester, text, "--fbgen-seed", "9").assert_outcomes(passed=1)


def test_a_setting_names_the_plant_of_all_tests(pytester: pytest.Pytester) -> None:
    pytester.makeini(f"[pytest]\nfbgen_plant = {PLANT.as_posix()}\n")
    text = "def test_plant(plant):\n    assert list(plant.drives) == ['pump']\n"
    ran(pytester, text).assert_outcomes(passed=1)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("def test_x(plant):\n    pass\n", "*no plant is named: mark the test with*"),
        (
            "import pytest\n\n@pytest.mark.fbgen(plnt='a')\ndef test_x(plant):\n    pass\n",
            "*the marker fbgen does not take 'plnt'; known: plant, seed*",
        ),
        (
            f"{MARK}def test_x(faults):\n    faults.inject('line_brocken', on='gw1')\n",
            "*there is no fault 'line_brocken'*",
        ),
        (
            f"{MARK}def test_x(faults):\n    faults.clear('line_broken', on='gw1')\n",
            "*there is no fault 'line_broken' to clear*",
        ),
    ],
)
def test_mistakes_say_what_to_do(pytester: pytest.Pytester, text: str, message: str) -> None:
    result = ran(pytester, text)
    assert result.ret != 0
    result.stdout.fnmatch_lines([message])


def test_the_example_of_the_page_passes(pytester: pytest.Pytester) -> None:
    page = (ROOT / "docs" / "reference" / "pytest-plugin.md").read_text("utf-8")
    (example,) = re.findall(r"^```python[^\n]*\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    (pytester.path / "tank.scl").write_text(TANK, "utf-8")
    shutil.copy(PLANT, pytester.path / "plant.yaml")
    ran(pytester, example).assert_outcomes(passed=2)
