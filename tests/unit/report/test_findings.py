"""Failures as findings at places: the line of the scenario, then the lines of PLC text."""

from fbgen.diagnostics import Severity
from harness.report.findings import findings_of
from harness.results import ScenarioReport
from tests.unit.report.results import EXPECTED, FAILED, FOUND, SESSION, WARNED


def test_failures_and_their_notes_stand_at_their_places_in_order() -> None:
    found = [(item.code, item.severity, str(item.span)) for item in findings_of(SESSION)]
    assert found == [
        ("FB8001", Severity.ERROR, "tests/start.scenario.yaml:2:14"),
        ("FB8001", Severity.INFO, "TOS_Drive.scl:2:5"),
        ("FB8012", Severity.ERROR, "tests/start.scenario.yaml:1:1"),
        ("FB1001", Severity.ERROR, "tests/broken.scenario.yaml:1:1"),
    ]


def test_expected_failures_are_no_findings_and_warnings_are() -> None:
    found = [(item.code, item.severity) for item in findings_of(ScenarioReport((EXPECTED, WARNED)))]
    assert found == [("FB8021", Severity.WARNING)]


def test_a_finding_says_which_scenario_and_how_to_run_it_again() -> None:
    first = next(iter(findings_of(SESSION)))
    assert first.message == f"A drive starts [step7]: {FOUND}"
    assert first.help.splitlines() == [
        "at 0.400 s of the plant's time",
        "FALSE was written here",
        f"run it again: {FAILED.replay}",
    ]
