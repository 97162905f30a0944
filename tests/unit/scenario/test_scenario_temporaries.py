"""Scenarios in which temporary variables hold anything before they are written."""

from pathlib import Path

from fbgen.catalog import load_catalog
from harness.engine.loading import ENGINES
from harness.scenario import RunOptions, run_case, run_paths, scenario_cases
from tests.unit.scenario.block_scenarios import tank, tank_file, tanks
from tests.unit.scenario.scenario_files import PLANT

FORGETFUL = """\
FUNCTION_BLOCK "Tank"
VAR_INPUT
  level : INT;
END_VAR
VAR_OUTPUT
  full : BOOL;
END_VAR
VAR_TEMP
  alarm : BOOL;
END_VAR
BEGIN
  IF #level > 80 THEN
    #alarm := TRUE;
  END_IF;
  #full := #alarm;
END_FUNCTION_BLOCK
"""
NEVER_FULL = """\
block: Tank
properties:
  - never: {block.full: true}
steps:
  - wait: 200 ms
"""
MAIN = """\
DATA_BLOCK "Seen"
STRUCT
  count : INT;
END_STRUCT
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK "Main"
VAR_TEMP
  told : ARRAY[0..19] OF BYTE;
  often : BOOL;
END_VAR
BEGIN
  IF #often THEN
    "Seen".count := "Seen".count + 1;
  END_IF;
END_ORGANIZATION_BLOCK
"""
HALF = """\
sources: [main.scl]
temporaries: undefined
steps:
  - wait: 1 s
  - expect: {plc.Seen.count: {min: 20, max: 80}}
"""


def test_what_nobody_has_written_shows_with_undefined_temporaries_only(tmp_path: Path) -> None:
    assert tank(tmp_path, NEVER_FULL, FORGETFUL).passed
    found = tank(tmp_path, "temporaries: undefined\n" + NEVER_FULL, FORGETFUL)
    assert [one.code for one in found.failures] == ["FB8020"]


def test_another_seed_leaves_other_values_and_both_engines_the_same(tmp_path: Path) -> None:
    text = "temporaries: undefined\nseeds: [0, 1, 2, 3]\n" + NEVER_FULL
    ends = [
        [result.virtual_ns for result in tanks(tmp_path, f"engine: {engine}\n{text}", FORGETFUL)]
        for engine in ENGINES
    ]
    assert ends[0] == ends[1]
    assert len(set(ends[0])) > 1


def test_who_asks_for_it_beside_the_files_can_replay_it(tmp_path: Path) -> None:
    path = tank_file(tmp_path, NEVER_FULL, FORGETFUL)
    (found,) = run_paths([path], RunOptions(temporaries="undefined")).results
    assert not found.passed
    assert "--temporaries undefined" in found.replay
    (found,) = run_paths([path]).results
    assert found.passed
    assert "--temporaries" not in found.replay


def test_the_blocks_of_a_plant_find_anything_too(tmp_path: Path) -> None:
    (tmp_path / "main.scl").write_text(MAIN, "utf-8")
    path = tmp_path / "half.scenario.yaml"
    path.write_text(f"version: 1\ntitle: T\nplant: {PLANT.as_posix()}\n" + HALF, "utf-8")
    (case,) = scenario_cases(path)
    assert run_case(case, load_catalog()).failures == ()
