"""Each mutant has a name of its own, also where one plant has several versions of a block."""

from dataclasses import replace
from pathlib import Path

from fbgen.catalog import load_catalog
from harness.scenario import scenario_cases
from harness.verify.mutation.stage import Stage
from harness.verify.mutation.subjects import targets_of

BYTES = Path(__file__).parents[2] / "scenarios" / "blocks" / "cyclic_data_bytes.scenario.yaml"
ROWS = ("gsd10_per_identifier", "gsd10_process_image", "doc9_per_identifier", "doc9_process_image")


def test_versions_of_a_block_in_one_plant_are_named_by_what_the_scenario_changes() -> None:
    stage = Stage(scenario_cases(BYTES), load_catalog())
    targets = targets_of(stage)
    assert [target.name for target in targets] == [
        f"one_drive[{row}]/TOS_ConsistentIo_gw1" for row in ROWS
    ]
    ids = [target.id_of(one) for target in targets for one in range(len(target.subject.mutants))]
    assert len(set(ids)) == len(ids)
    assert ids[0].startswith("one_drive[gsd10_per_identifier]/TOS_ConsistentIo_gw1:")


def test_what_is_changed_alike_is_numbered() -> None:
    cases = [replace(case, row="alike") for case in scenario_cases(BYTES)[:2]]
    assert [target.name for target in targets_of(Stage(cases, load_catalog()))] == [
        "one_drive[alike] 1/TOS_ConsistentIo_gw1",
        "one_drive[alike] 2/TOS_ConsistentIo_gw1",
    ]
