"""Properties: what is violated is told with its instant, what shows nothing is told as well."""

from pathlib import Path

import pytest

from fbgen.diagnostics import Severity
from harness.scenario import run_paths
from tests.unit.scenario.block_scenarios import only_failure, tank, tank_file
from tests.unit.scenario.scenario_files import marked, ran, steps

STEPS = """\
steps:
  - wait: 100 ms
  - set: {block.start: true, block.level: 10}
  - wait: 100 ms
  - set: {block.level: 90}
  - wait: 100 ms
  - set: {block.level: 20}
  - wait: 100 ms
"""
"""The pump runs from 150 ms to 200 ms and from 350 ms on."""


def properties(*lines: str) -> str:
    """A scenario of the tank with these properties."""
    return "properties:\n" + "".join(f"  {line}\n" for line in lines) + STEPS


HOLD = [
    "- never: {block.pump: true, block.start: false}",
    "- always: {block.level: {max: 90}}",
    "- {always: {block.level: {min: 10}}, during: {block.start: true}}",
    "- {after: {block.start: true}, within: 60 ms, then: {block.pump: true}}",
    "- {at_most: 1, per: 200 ms, of: {block.pump: true}}",
    "- {at_most: 2, per: 1 s, of: {block.pump: true}}",
    "- mutually_exclusive: {block.pump: true, block.level: 80}",
    "- eventually: {block.pump: true, block.level: 20}",
]
VIOLATED = [
    (
        "- never: {block.pump: true, block.level: {min: 15}}",
        "block.pump is true and block.level is 90, which must never be",
        "block.pump",
        0.2,
    ),
    (
        "- always: {block.start: false, block.level: {max: 50}}",
        "block.start is true, expected always false",
        "block.start",
        0.1,
    ),
    (
        "- {after: {block.start: true}, within: 40 ms, then: {block.pump: true}}",
        "block.pump is false 40 ms after block.start became true, expected true within 40 ms",
        "block.pump",
        0.14,
    ),
    (
        "- {at_most: 1, per: 1 s, of: {block.pump: true}}",
        "block.pump became true 2 times within 200 ms, expected at most 1 per 1 s",
        "block.pump",
        0.35,
    ),
    (
        "- mutually_exclusive: {block.pump: true, block.start: true, block.level: 0}",
        "block.start is true and block.level is 0 at the same instant, expected at most one",
        "block.start",
        0.1,
    ),
    (
        "- eventually: {block.level: 95}",
        "at the end block.level is 20, expected at some instant block.level 95",
        "block.level",
        0.4,
    ),
]


@pytest.mark.parametrize("line", HOLD)
def test_a_property_that_holds_counts_as_a_check(tmp_path: Path, line: str) -> None:
    result = tank(tmp_path, properties(line))
    assert result.passed, result.render()
    assert (result.checks, result.warnings) == (1, ())


@pytest.mark.parametrize(("line", "message", "place", "at_s"), VIOLATED)
def test_a_violated_property_says_what_was_and_when(
    tmp_path: Path, line: str, message: str, place: str, at_s: float
) -> None:
    text = properties(line)
    if "level: 0}" in line:
        text = text.replace("true, block.level: 10}", "true}")
    failure = only_failure(tank(tmp_path, text))
    assert failure.code == "FB8020"
    assert failure.message.startswith(message)
    assert marked(failure) == place
    assert failure.notes[0].message == f"at {at_s:.3f} s of the plant's time"


SHOW_NOTHING = [
    "- {never: {block.pump: true}, during: {block.level: 55}}",
    "- {always: {block.pump: true}, during: {block.level: 55}}",
    "- {after: {block.level: 55}, within: 1 s, then: {block.pump: true}}",
    "- {after: {block.level: 20}, within: 1 s, then: {block.level: 55}}",
    "- {at_most: 0, per: 1 s, of: {block.level: 55}}",
    "- mutually_exclusive: {block.level: 55, block.level: 56}".replace("level: 56", "calls: -1"),
]


@pytest.mark.parametrize("line", SHOW_NOTHING)
def test_a_property_that_decides_nothing_is_a_warning(tmp_path: Path, line: str) -> None:
    result = tank(tmp_path, properties(line))
    (warning,) = result.warnings
    assert result.passed
    assert (warning.code, warning.severity) == ("FB8021", Severity.WARNING)


def test_what_is_violated_while_the_guard_is_open_is_no_violation(tmp_path: Path) -> None:
    line = "- {name: full, never: {block.pump: true}, during: {block.level: {min: 80}}}"
    failure = only_failure(tank(tmp_path, properties(line)))
    assert failure.message == "full: block.pump is true, which must never be"
    assert failure.notes[0].message == "at 0.200 s of the plant's time"


def test_a_violation_names_the_line_that_wrote_the_value(tmp_path: Path) -> None:
    path = tank_file(tmp_path, properties("- never: {block.pump: true, block.level: 10}"))
    failure = only_failure(run_paths([path]).results[0])
    written, was_set = [note for note in failure.notes if note.span is not None]
    assert written.span is not None
    assert written.message == "it was last written here"
    assert written.span.text.startswith("#pump := #delay.Q")
    assert was_set.message == "it was last set here"


def test_mistakes_in_properties_are_told_before_anything_runs(tmp_path: Path) -> None:
    lines = ["- nver: {block.pump: true}", "- {at_most: 1, of: {block.pump: true}}"]
    codes = [item.code for item in _wrong(tmp_path, *lines)]
    assert sorted(codes) == ["FB1005", "FB1006"]
    lines = ["- never: {block.pmp: true}", "- {eventually: {block.calls: x}, during: {blck.x: 1}}"]
    assert [item.code for item in tank(tmp_path, properties(*lines)).failures] == [
        "FB8003",
        "FB8003",
        "FB8009",
    ]


def _wrong(folder: Path, *lines: str) -> tuple[object, ...]:
    from fbgen.diagnostics import DiagnosticError  # noqa: PLC0415

    with pytest.raises(DiagnosticError) as failure:
        tank(folder, properties(*lines))
    return failure.value.diagnostics


def test_a_violation_in_a_plant_shows_the_telegrams(tmp_path: Path) -> None:
    head = "properties:\n  - always: {drive.pump.word.FD01: {bits: {running: 1}}}\n"
    result = ran(tmp_path, head + steps("- wait: 100 ms"))
    failure = only_failure(result)
    assert failure.message.startswith("drive.pump.word.FD01 is 16#")
    notes = [note.message for note in failure.notes]
    assert any("means:" in note for note in notes)
