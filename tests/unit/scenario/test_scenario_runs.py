"""What steps do and when expectations hold, seen on one drive."""

from pathlib import Path

import pytest

from fbgen.diagnostics import render
from harness.kernel import NS_PER_MS
from tests.unit.scenario.scenario_files import FIRST_READ, READ, prepared, ran, steps

START = (
    "- wait: 100 ms",
    "- set:",
    "    plc.TOS_Plant.gw1.pump.start_forward.frequency: 30.0",
    "    plc.TOS_Plant.gw1.pump.start_forward.execute: true",
)
FAST = "drives: {pump: {parameters: {acceleration_time: 1.0}}}\n"


def test_an_expectation_without_time_is_looked_at_once(tmp_path: Path) -> None:
    result = ran(tmp_path, steps("- wait: 5 ms", "- expect: {cpu.mode: STARTUP}"))
    assert (result.passed, result.checks, result.virtual_ns) == (True, 1, 5 * NS_PER_MS)


def test_an_input_terminal_is_switched_and_shows_in_fd06(tmp_path: Path) -> None:
    text = steps("- set: {drive.pump.terminal.s2: true}",
                 "- expect: {drive.pump.terminal.s2: true, drive.pump.word.FD06: 16}",
                 "- set: {drive.pump.terminal.s2: false}",
                 "- expect: {drive.pump.terminal.s2: false, drive.pump.word.FD06: 0}")  # fmt: skip
    assert ran(tmp_path, text).passed


def test_a_drive_that_was_told_to_speak_modbus_is_not_heard_by_the_gateway(tmp_path: Path) -> None:
    told = "drives: {pump: {port: serial, parameters: {protocol_selection: 1}}}\n"
    text = steps("- wait: 100 ms", f"- set: {{{READ}.execute: true}}",
                 f"- expect: {{{READ}.status: 16#8401}}", "  within: 3 s")  # fmt: skip
    assert ran(tmp_path, told + text).passed


def test_within_ends_the_wait_as_soon_as_all_hold_at_once(tmp_path: Path) -> None:
    text = steps(*START, "- expect: {drive.pump.frequency: 30.0, drive.pump.running: true}",
                 "  within: 10 s")  # fmt: skip
    result = ran(tmp_path, FAST + text)
    assert (result.passed, result.checks) == (True, 2)
    assert 700 * NS_PER_MS < result.virtual_ns < 1000 * NS_PER_MS


def test_within_that_is_too_short_fails_at_its_end(tmp_path: Path) -> None:
    text = steps(*START, "- expect: {drive.pump.frequency: 30.0}", "  within: 200.6 ms")
    result = ran(tmp_path, FAST + text)
    (found,) = result.failures
    assert 300_600_000 <= result.virtual_ns < 300_610_000, "a scan in progress is not torn apart"
    assert found.message.startswith("drive.pump.frequency is ")
    assert found.message.endswith(" after 0.201 s, expected 30")
    assert found.notes[0].message == "at 0.301 s of the plant's time"


def test_stays_for_needs_no_within_and_lets_its_time_pass(tmp_path: Path) -> None:
    result = ran(tmp_path, steps("- expect: {drive.pump.running: false}", "  stays_for: 2 s"))
    assert result.passed
    assert 2_000_000_000 <= result.virtual_ns < 2_000_010_000


def test_stays_for_fails_at_the_instant_at_which_it_breaks(tmp_path: Path) -> None:
    text = steps(*START, "- expect: {drive.pump.running: false}", "  stays_for: 2 s")
    result = ran(tmp_path, FAST + text)
    (found,) = result.failures
    assert result.virtual_ns < 400 * NS_PER_MS
    assert found.message.startswith("drive.pump.running is true 0.")
    assert found.message.endswith(" s after it was right, of 2.000 s to stay so, expected false")


def test_stays_for_counts_from_the_instant_at_which_it_holds(tmp_path: Path) -> None:
    text = steps(*START, "- expect: {drive.pump.frequency: 30.0}", "  within: 5 s",
                 "  stays_for: 3 s")  # fmt: skip
    result = ran(tmp_path, FAST + text)
    assert result.passed
    assert 3700 * NS_PER_MS < result.virtual_ns < 4000 * NS_PER_MS


def test_values_are_set_in_the_order_written(tmp_path: Path) -> None:
    run = prepared(tmp_path, steps(*START, "- expect: {cpu.mode: RUN}"))
    run.run()
    engine = run.installation.cpu.engine
    assert engine.global_value("TOS_Plant.gw1.pump.start_forward.frequency") == 30.0
    assert engine.global_value("TOS_Plant.gw1.pump.start_forward.execute") is True


def test_parameters_of_a_drive_are_set_as_at_its_panel_and_read_back(tmp_path: Path) -> None:
    text = steps(
        "- set: {drive.pump.comno.acceleration_time: 2.5}",
        "- expect: {drive.pump.comno.acceleration_time: 2.5, drive.pump.writes.0009: 1}",
    )
    assert ran(tmp_path, text).passed


def test_a_parameter_that_the_drive_refuses_is_told_at_its_value(tmp_path: Path) -> None:
    text = steps(
        "- expect: {cpu.mode: STARTUP}",
        "- set: {drive.pump.comno.acceleration_time: 99999}",
    )
    (found,) = ran(tmp_path, text).failures
    assert (found.code, found.span and found.span.text) == ("FB7101", "99999")


def test_the_first_step_that_fails_ends_the_scenario(tmp_path: Path) -> None:
    text = steps(
        "- wait: 10 ms",
        "- expect: {drive.pump.running: true, drive.pump.tripped: true, drive.pump.powered: true}",
        "- expect: {cpu.mode: STOP}",
    )
    result = ran(tmp_path, text)
    assert [found.message.split()[0] for found in result.failures] == [
        "drive.pump.running",
        "drive.pump.tripped",
    ]


CURRENT = "plc.TOS_Plant.gw1.pump.read_current"


def test_telegrams_are_compared_since_the_last_comparison(tmp_path: Path) -> None:
    text = steps(
        "- wait: 100 ms",
        FIRST_READ,
        "- {telegrams: [], gateway: gw1}",
        f"- set: {{{CURRENT}.execute: true}}",
        "- wait: 200 ms",
        "- gateway: gw1",
        "  telegrams:",
        '    - {output: "xx xx 01 0b 47 FE 03 xx xx", input: "xx xx 0B 47 FE 03 00 00"}',
        "- {telegrams: [], gateway: gw1}",
    )
    result = ran(tmp_path, text)
    assert (result.passed, result.checks) == (True, 4)


@pytest.mark.parametrize(
    ("telegrams", "messages"),
    [
        ("[]", ["1 telegrams went out on gw1, expected 0"]),
        (
            '[{output: "xx xx 01 0B 47 FE 04 xx xx", input: "9F 00 0B 47 FE 03 00 00"}]',
            [
                "the output of telegram 1 is E0 00 01 0B 47 FE 03 00 00, "
                "expected xx xx 01 0B 47 FE 04 xx xx",
                "the input of telegram 1 is DF 00 0B 47 FE 03 00 00, "
                "expected 9F 00 0B 47 FE 03 00 00",
            ],
        ),
    ],
)
def test_telegrams_that_differ_are_told_with_what_went_out(
    tmp_path: Path, telegrams: str, messages: list[str]
) -> None:
    text = steps(
        "- wait: 100 ms",
        FIRST_READ,
        f"- set: {{{CURRENT}.execute: true}}",
        "- wait: 200 ms",
        f"- {{telegrams: {telegrams}, gateway: gw1}}",
    )
    found = ran(tmp_path, text).failures
    assert [item.message for item in found] == messages
    assert "drive 11: read FE03 Output current" in found[0].notes[0].message


def test_a_failed_expectation_tells_all_that_a_person_needs(tmp_path: Path) -> None:
    text = steps(
        *START,
        "- expect:",
        "    drive.pump.word.FA00: 16#C401",
        "    gateway.gw1.status: {bits: {status_code: 0}}",
        "  within: 300 ms",
    )
    result = ran(tmp_path, FAST + text)
    word, status = [render(found).splitlines() for found in result.failures]
    assert word[0] == (
        "error[FB8001]: drive.pump.word.FA00 is 16#C400 (50176) after 0.300 s, "
        "expected 16#C401 (50177)"
    )
    assert word[1].endswith("tried.scenario.yaml:11:7")
    assert word[5] == "   = note: at 0.400 s of the plant's time"
    assert word[6].startswith("   = note: 16#C400 (50176) means: network_command=1 (")
    assert word[7].startswith("   = note: 16#C401 (50177) means: network_command=1 (")
    assert "preset_speed_1=1" in word[7]
    assert (
        status[6] == "   = note: 16#9F00 (40704) means: status_changed=1, status_code=31 (no error)"
    )
    assert status[7:] == [
        "   = note: gw1 at 12.000 ms: drive 11: read FC90 Trip code, 0000 while ready = 0000 (0)",
        "      A0 00 FF 0B 47 FC 90 00 00  ->  9F 00 0B 47 FC 90 00 00  at 52.000 ms",
        "   = note: gw1 at 112.000 ms: drive 11: write FA01 Frequency set-point = 0BB8 (30.00 Hz)",
        "      E0 00 01 0B 50 FA 01 0B B8  ->  DF 00 0B 50 FA 01 0B B8  at 150.000 ms",
        "   = note: gw1 at 172.000 ms: drive 11: write FA00 Command word = C400 "
        "(network_command, network_frequency, run)",
        "      A0 00 02 0B 50 FA 00 C4 00  ->  9F 00 0B 50 FA 00 C4 00  at 206.000 ms",
    ]


def test_a_failure_tells_what_was_on_a_line_without_reply_and_that_the_cpu_is_stopped(
    tmp_path: Path,
) -> None:
    text = steps(
        "- wait: 100 ms",
        "- {inject: line_broken, on: gw1}",
        f"- set: {{{READ}.execute: true}}",
        "- wait: 100 ms",
        "- inject: cpu_stopped",
        "- expect: {drive.pump.tripped: true}",
    )
    (found,) = ran(tmp_path, text).failures
    notes = "\n".join(note.message for note in found.notes)
    assert "->  no reply; on the line: gateway 2F 0B 47 FD 01 00 00 7F" in notes
    assert notes.endswith("the CPU is in STOP, so the PLC writes nothing")
