"""One broken scenario file for each code, reported at its place."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from harness.scenario import run_case, scenario_cases

BAD = Path(__file__).parents[1] / "bad"
FILES = [
    ("FB7503_no_port_on_devicenet", 6, 24),
    ("FB7520_no_other_drive", 7, 15),
    ("FB7521_overlaps_itself", 5, 34),
    ("FB7523_no_such_assemblies", 8, 15),
    ("FB8001_not_fulfilled", 6, 14),
    ("FB8002_contradiction", 6, 35),
    ("FB8003_unknown_path", 5, 14),
    ("FB8004_unknown_fault", 5, 13),
    ("FB8005_clear_without_inject", 5, 12),
    ("FB8006_other_telegram", 12, 17),
    ("FB8007_no_plant_file", 3, 8),
    ("FB8008_checks_nothing", 5, 3),
    ("FB8009_wrong_value", 5, 48),
    ("FB8010_unknown_bit", 6, 37),
    ("FB8013_no_bytes", 7, 17),
    ("FB8014_passes_after_all", 4, 17),
    ("FB8015_no_column", 7, 67),
    ("FB8016_incomplete_row", 6, 8),
    ("FB8017_unused_column", 5, 18),
    ("FB8018_call_in_a_plant", 5, 11),
    ("FB8019_no_block", 4, 8),
    ("FB8020_violated", 5, 14),
    ("FB8021_shows_nothing", 5, 5),
    ("FB8070_rule_broken", 4, 8),
    ("FB8071_unknown_rule", 4, 8),
]


@pytest.mark.parametrize(("name", "line", "column"), FILES)
def test_a_broken_scenario_is_reported_at_its_place(name: str, line: int, column: int) -> None:
    try:
        result = run_case(scenario_cases(BAD / f"{name}.yaml")[0], load_catalog())
        found = (*result.failures, *result.warnings)
    except DiagnosticError as wrong:
        found = wrong.diagnostics
    places = [(item.code, item.span and (item.span.line, item.span.column)) for item in found]
    assert places == [(name[:6], (line, column))]


def test_every_broken_file_is_tried() -> None:
    codes = (
        "FB750",
        "FB752",
        "FB80[0-5]",
        "FB807[01]",
    )  # the others are of files of other commands
    assert {path.stem for code in codes for path in BAD.glob(f"{code}*.yaml")} == {
        name for name, _, _ in FILES
    }
