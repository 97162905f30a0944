"""The page on scenario files has every key, path, fault and unit, and its examples run."""

import re
from pathlib import Path

import pytest
from pydantic import BaseModel

from fbgen.catalog import load_catalog
from harness.durations import read_duration
from harness.faults import FAULTS
from harness.gateways.pbdp110 import Leds as InterfaceLeds
from harness.gateways.tospbdp001 import Leds
from harness.scenario import (
    block_stage,
    expectations,
    model,
    property_model,
    run_case,
    scenario_cases,
)
from harness.scenario.devicenet_paths import DEVICENET_ITEMS
from harness.scenario.paths import COMNO_ITEMS, DRIVE_ITEMS, GATEWAY_ITEMS, LINE_ITEMS, ROOTS
from tests.unit.scenario.scenario_files import PLANT, ROOT

PAGE = (ROOT / "docs" / "reference" / "scenario-files.md").read_text("utf-8")
EXAMPLES = re.findall(r"^```yaml\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
CODE = set(re.findall(r"`([^`\n]+)`", PAGE))
TANK = """\
FUNCTION_BLOCK "Tank"
VAR_INPUT
  start : BOOL;
END_VAR
VAR_OUTPUT
  pump : BOOL;
  level : INT;
END_VAR
VAR
  delay : TON_TIME;
  status : INT;
END_VAR
BEGIN
  #status := READ_LEVEL(tank := 1, level => #level);
  #delay(IN := #start AND #level < 80, PT := T#500ms);
  #pump := #delay.Q;
END_FUNCTION_BLOCK
"""
"""The block that an example of the page tests."""
MODELS = [
    kind
    for part in (model, expectations, property_model)
    for kind in vars(part).values()
    if isinstance(kind, type) and issubclass(kind, BaseModel) and kind.__module__ == part.__name__
]


@pytest.mark.parametrize("kind", MODELS, ids=lambda kind: kind.__name__)
def test_every_key_is_explained(kind: type[BaseModel]) -> None:
    assert [name for name in kind.model_fields if name not in CODE] == []


@pytest.mark.parametrize("kind", MODELS, ids=lambda kind: kind.__name__)
def test_every_key_is_described_for_editors(kind: type[BaseModel]) -> None:
    assert [name for name, field in kind.model_fields.items() if not field.description] == []


def test_every_path_is_explained_and_none_that_there_is_not() -> None:
    roots = {*ROOTS, *block_stage.ROOTS}
    paths = {
        re.sub(r"[A-Z]{3,}", "*", path)
        for path in CODE
        if path.split(".")[0] in roots and ":" not in path
    }
    wanted = {"cpu.mode", "cpu.scans", "bus.mode", "plc.*", "gateway.*.led.*", "block.*"}
    wanted |= {"drive.*.terminal.*"}
    wanted |= {f"gateway.*.{item}" for item in GATEWAY_ITEMS}
    wanted |= {"gateway.*.input.*", "gateway.*.*.online", "gateway.*.diagnosis"}
    wanted |= {f"drive.*.{item}" for item in DRIVE_ITEMS}
    wanted |= {f"drive.*.{item}.*" for item in COMNO_ITEMS}
    wanted |= {f"devicenet.*.{item}" for item in DEVICENET_ITEMS}
    wanted |= {"devicenet.*.output.*", "devicenet.*.led.*", "devicenet.*.connection.*"}
    wanted |= {"devicenet.*.mode", *(f"line.*.{item}" for item in LINE_ITEMS)}
    generic = {path for path in paths if "*" in path or path.startswith(("cpu", "bus"))}
    assert generic == wanted


def test_every_lamp_is_named() -> None:
    assert {*Leds._fields, *InterfaceLeds._fields} <= CODE


@pytest.mark.parametrize("name", sorted(FAULTS))
def test_every_fault_is_explained_with_its_place_and_its_settings(name: str) -> None:
    (row,) = [line for line in PAGE.splitlines() if line.startswith(f"| `{name}` |")]
    kind = FAULTS[name]
    assert row.split("|")[2].strip() == {"plant": "-"}.get(kind.target.value, kind.target.value)
    for setting, field in kind.settings.model_json_schema().get("properties", {}).items():
        assert f"`{setting}`" in row
        if field["default"] is not None:
            assert str(field["default"]) in row


def test_no_fault_is_explained_that_there_is_not() -> None:
    table = PAGE.partition("| fault |")[2].partition("\n\n")[0]
    assert set(re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE)) == set(FAULTS)


def test_every_unit_of_time_is_named() -> None:
    for unit in ("us", "ms", "s", "min", "h"):
        assert unit in CODE
        assert read_duration(f"1 {unit}") > 0


@pytest.mark.parametrize("text", EXAMPLES, ids=lambda text: text.partition("title: ")[2][:30])
def test_every_example_passes(text: str, tmp_path: Path) -> None:
    path = tmp_path / "example.scenario.yaml"
    path.write_text(text.replace("plant: plant.yaml", f"plant: {PLANT.as_posix()}"), "utf-8")
    (tmp_path / "tank.scl").write_text(TANK, "utf-8")
    for case in scenario_cases(path):
        result = run_case(case, load_catalog())
        assert result.passed, result.render()
        assert result.warnings == ()
