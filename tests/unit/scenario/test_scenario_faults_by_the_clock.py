"""Faults that come by the clock, and rules of the plant."""

import re
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from harness.installation.programs import generated_sources
from harness.kernel import NS_PER_MS
from tests.unit.scenario.scenario_files import PLANT, findings, prepared, ran, steps

RANDOM = "faults: [{random: 5, after: 100 ms, before: 2 s, lasts: 300 ms}]\nrules: [all]\n"
WAIT = steps("- wait: 3 s")


def test_a_fault_begins_and_ends_at_its_instant(tmp_path: Path) -> None:
    faults = "faults: [{at: 300 ms, lasts: 100 ms, inject: gateway_unpowered, on: gw1}]\n"
    lines = [
        "- expect: {gateway.gw1.powered: true}",
        "  stays_for: 299 ms",
        "- wait: 2 ms",
        "- expect: {gateway.gw1.powered: false}",
        "  stays_for: 98 ms",
        "- wait: 2 ms",
        "- expect: {gateway.gw1.powered: true}",
    ]
    result = ran(tmp_path, faults + steps(*lines))
    assert result.passed, result.render()


def test_a_fault_comes_again_until_its_last_time(tmp_path: Path) -> None:
    faults = (
        "faults: [{at: 1 s, lasts: 10 ms, every: 500 ms, until: 2 s, inject: profibus_interrupted}]"
        "\nrules: [cpu_runs]\n"
    )
    run = prepared(tmp_path, faults + WAIT)
    assert [event.at_ns // NS_PER_MS for event in run.faults] == [1000, 1500, 2000]
    assert {event.lasts_ns for event in run.faults} == {10 * NS_PER_MS}


def test_what_is_drawn_depends_on_the_seed_only(tmp_path: Path) -> None:
    first = prepared(tmp_path, RANDOM + WAIT).faults
    assert prepared(tmp_path, RANDOM + WAIT).faults == first
    assert prepared(tmp_path, "seed: 1\n" + RANDOM + WAIT).faults != first
    assert len(first) == 5
    for event in first:
        assert event.at_ns >= 100 * NS_PER_MS
        assert event.lasts_ns is not None
        assert event.end_ns <= 2000 * NS_PER_MS


def test_only_what_the_plant_can_have_is_drawn(tmp_path: Path) -> None:
    kinds = "faults: [{random: 20, before: 2 s, lasts: 1 s, kinds: [%s]}]\nrules: [all]\n"
    alone = prepared(tmp_path, kinds % "drive_number_doubled" + WAIT)
    assert alone.faults == (), "there is one drive on the line"
    both = prepared(tmp_path, kinds % "line_noise, drive_slow" + WAIT)
    assert {(event.name, event.on) for event in both.faults} == {
        ("line_noise", "gw1"),
        ("drive_slow", "pump"),
    }


def test_equal_faults_that_overlap_end_with_the_last_of_them(tmp_path: Path) -> None:
    faults = (
        "faults: [{at: 100 ms, lasts: 200 ms, inject: gateway_unpowered, on: gw1}, "
        "{at: 200 ms, lasts: 200 ms, inject: gateway_unpowered, on: gw1}]\n"
    )
    lines = [
        "- wait: 101 ms",
        "- expect: {gateway.gw1.powered: false}",
        "  stays_for: 298 ms",
        "- wait: 2 ms",
        "- expect: {gateway.gw1.powered: true}",
    ]
    result = ran(tmp_path, faults + steps(*lines))
    assert result.passed, result.render()


@pytest.mark.parametrize(
    ("entry", "code"),
    [
        ("{at: 1 s, every: 1 s, inject: profibus_clear}", "FB7521"),
        ("{at: 3 s, lasts: 1 s, every: 1 s, until: 2 s, inject: profibus_clear}", "FB7521"),
        ("{random: 3, after: 1 s, before: 2 s, lasts: 3 s}", "FB7521"),
        ("{random: 3, before: 2 s, lasts: 1 s, kinds: [line_nose]}", "FB8004"),
        ("{at: 1 s, inject: line_noise}", "FB8004"),
        ("{at: 1 s, inject: line_noise, on: gw2}", "FB8004"),
        ("{at: 1 s, inject: line_noise, on: gw1, settings: {bit_error_rate: 7}}", "FB8004"),
        ("{at: 1 s, inject: drive_tripped, on: pump, settings: {display: OC9}}", "FB7102"),
    ],
)
def test_what_is_wrong_with_a_schedule_is_found_before_the_start(
    tmp_path: Path, entry: str, code: str
) -> None:
    found = findings(tmp_path, f"faults:\n  - {entry}\nrules: [all]\n" + WAIT)
    assert [item.code for item in found] == [code]
    assert found[0].span is not None


def test_rules_hold_while_drives_and_gateway_come_and_go(tmp_path: Path) -> None:
    result = ran(tmp_path, RANDOM + WAIT, seed=3)
    assert result.passed, result.render()


def test_a_run_command_that_nobody_asked_for_breaks_a_rule(tmp_path: Path) -> None:
    """The request is put straight into the channel of the drive, past everything that asks."""
    channel = "plc.TOS_Gateway_gw1_DB.statChannels"
    request = (
        f'- set: {{"{channel}[1].request.invNo": 11, "{channel}[1].request.cmd": 16#50, '
        f'"{channel}[1].request.comNo": 16#FA00, "{channel}[1].request.data": 16#C400, '
        f'"{channel}[1].request.replyExpected": true, "{channel}[1].request.execute": true}}'
    )
    lines = ["- wait: 500 ms", request, "- wait: 300 ms"]
    result = ran(tmp_path, "rules: [no_command_unasked]\n" + steps(*lines))
    assert {item.code for item in result.failures} == {"FB8070"}
    assert "unasked" in result.failures[0].message


def test_a_lost_drive_that_is_shown_running_breaks_a_rule(tmp_path: Path) -> None:
    """The drive is polled by nobody, so what is set stays."""
    shown = "plc.TOS_Plant.gw1.pump"
    wrong = f"- set: {{{shown}.polled.lost: true, {shown}.state.running: true}}"
    lines = ["- wait: 100 ms", wrong, "- wait: 50 ms"]
    result = ran(tmp_path, "rules: [all]\n" + steps(*lines))
    assert {item.code for item in result.failures} == {"FB8070"}
    assert "running" in result.failures[0].message


def test_blocks_of_two_generations_break_a_rule(tmp_path: Path) -> None:
    catalog = load_catalog()
    names = []
    for source in generated_sources(load_plant(PLANT, catalog), catalog):
        path = tmp_path / Path(source.name).name
        text = re.sub(r"inputsHash := 16#\w+", "inputsHash := 16#1", source.text)
        path.write_text(text, "utf-8")
        names.append(path.name)
    text = f"sources: [{', '.join(names)}]\nrules: [inputs_shown]\n"
    result = ran(tmp_path, text + steps("- wait: 50 ms"))
    assert {item.code for item in result.failures} == {"FB8070"}
    assert "in the heads stands" in result.failures[0].message
