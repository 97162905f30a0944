"""Mistakes in scenario files: code, the text under the carets, and what the help says.

Everything is found before the plant starts, and all of it at once.
"""

from pathlib import Path

import pytest

from tests.unit.scenario.scenario_files import READ, findings, marked, steps

FINE = "- expect: {cpu.mode: STOP}"


def one(folder: Path, text: str) -> tuple[str, str, str]:
    """The only finding: code, marked text, help."""
    (found,) = findings(folder, text)
    return found.code, marked(found), found.help


@pytest.mark.parametrize(
    ("path", "help_text"),
    [
        ("drve.pump.running", "did you mean 'drive'?"),
        ("drive.pmp.running", "did you mean 'pump'?"),
        ("drive.pump.runing", "did you mean 'running'?"),
        ("drive.pump.comno.FE99", "FE"),
        ("drive.pump.terminal.s9", "known: f, r, res, s1, s2, s3"),
        ("drive.pump.word.output_curent", "did you mean 'output_current'"),
        ("gateway.gw2.online", "did you mean 'gw1'?"),
        ("gateway.gw1.onlin", "did you mean 'online'"),
        ("gateway.gw1.led.device", "did you mean 'device_status'?"),
        ("cpu.mod", "did you mean 'mode'?"),
        ("bus.cycle", "known: mode"),
        ("plc.TOS_Plant.gw1.pump.read_status.eror", "did you mean 'error'?"),
        ("plc.TOS_Plan.gw1", "did you mean 'TOS_Plant'?"),
        ("plc", "TOS_Plant"),
        ("plc.TOS_Plant..gw1", ""),
        ("drive.pump", "running"),
        ("drive", "known: pump"),
    ],
)
def test_an_unknown_path_is_marked_and_the_nearest_name_is_told(
    tmp_path: Path, path: str, help_text: str
) -> None:
    code, text, advice = one(tmp_path, steps(f"- expect: {{{path}: true}}"))
    assert (code, text) == ("FB8003", path)
    assert help_text in advice


@pytest.mark.parametrize(
    "path", ["drive.pump.running", "cpu.mode", "drive.pump.comno.FE03", "gateway.gw1.status"]
)
def test_what_cannot_be_set_says_what_can(tmp_path: Path, path: str) -> None:
    code, text, advice = one(tmp_path, steps(f"- set: {{{path}: 1}}", FINE))
    assert (code, text) == ("FB8003", path)
    assert "set" in advice or "read" in advice


@pytest.mark.parametrize(
    ("item", "value", "help_text"),
    [
        (f"{READ}.execute", "on", "write true or false"),
        (f"{READ}.execute", "1", "write true or false"),
        (f"{READ}.status", "70000", "0 to 65535, also as 16#FFFF"),
        (f"{READ}.status", "16#1_0000_0", "0 to 65535"),
        (f"{READ}.status", "-1", "0 to 65535"),
        (f"{READ}.status", "1.5", "whole number"),
        (f"{READ}.status", "16#XY", "16#FF or 2#1010"),
        (f"{READ}.status", "open", "whole number"),
        ("plc.TOS_Plant.gw1.pump.start_forward.frequency", "fast", "a number"),
        ("plc.TOS_Plant.gw1.pump", "1", "polled, alarms, start_forward"),
        ("drive.pump.comno.acceleration_time", "soon", "write a number"),
        ("drive.pump.comno.acceleration_time", "1.0e308", "nothing in a plant"),
    ],
)
def test_a_value_that_does_not_fit_its_variable_is_marked(
    tmp_path: Path, item: str, value: str, help_text: str
) -> None:
    code, text, advice = one(tmp_path, steps("- set:", f"    {item}: {value}", FINE))
    assert (code, text) == ("FB8009", value)
    assert help_text in advice


@pytest.mark.parametrize(
    ("path", "expected", "text"),
    [
        ("drive.pump.running", "1", "1"),
        ("drive.pump.frequency", "50 Hz", "50 Hz"),
        ("drive.pump.direction", "forwards", "forwards"),
        ("drive.pump.trip", "OC77", "OC77"),
        ("cpu.mode", "run", "run"),
        ("cpu.scans", "many", "many"),
        ("gateway.gw1.outputs", '"00 01"', '"00 01"'),
        ("gateway.gw1.outputs", "none", "none"),
        ("gateway.gw1.led.device_status", "blue", "blue"),
        ("gateway.gw1.status", "16#9Z00", "16#9Z00"),
        (f"{READ}.error", "{equals: 0}", "0"),
        (f"{READ}.error", "{min: 0}", "0"),
        ("drive.pump.direction", "{max: reverse}", "reverse"),
        (f"{READ}.trip_code", "{differs_from: Err5}", "Err5"),
    ],
)
def test_an_expectation_that_can_never_hold_is_a_mistake(
    tmp_path: Path, path: str, expected: str, text: str
) -> None:
    code, where, advice = one(tmp_path, steps(f"- expect: {{{path}: {expected}}}"))
    assert (code, where) == ("FB8009", text)
    assert advice


@pytest.mark.parametrize(
    ("path", "expected", "text", "help_text"),
    [
        ("gateway.gw1.status", "{bits: {status_cod: 1}}", "status_cod", "'status_code'"),
        ("gateway.gw1.status", "{bits: {status_code: 32}}", "32", "0 to 31"),
        ("gateway.gw1.status", "{bits: {status_code: -1}}", "-1", "0 to 31"),
        ("gateway.gw1.status", "{bits: {status_code: full}}", "full", "0 to 31"),
        ("gateway.gw1.status", "{word: vf-s11.stats, bits: {a: 1}}", "vf-s11.stats", "vf-s11."),
        (f"{READ}.status", "{bits: {tripped: 1}}", "{tripped: 1}", "word:"),
        ("cpu.mode", "{word: vf-s11.status, bits: {tripped: 1}}", "{tripped: 1}", "equals"),
    ],
)
def test_an_unknown_word_or_bit_is_marked(
    tmp_path: Path, path: str, expected: str, text: str, help_text: str
) -> None:
    code, where, advice = one(tmp_path, steps(f"- expect: {{{path}: {expected}}}"))
    assert (code, where) == ("FB8010", text)
    assert help_text in advice


@pytest.mark.parametrize(
    "expected",
    ["{}", "{word: vf-s11.status}", "{tolerance: 1.0, min: 3.0}", "{bits: {}}", "{min: 5, max: 4}"],
)
def test_an_expectation_that_contradicts_itself_is_a_mistake(tmp_path: Path, expected: str) -> None:
    found = findings(tmp_path, steps(f"- expect: {{drive.pump.frequency: {expected}}}"))
    assert {item.code for item in found} == {"FB8002"}
    assert all(item.help for item in found)


@pytest.mark.parametrize(
    ("lines", "text", "help_text"),
    [
        (["- inject: line_brocken", "  on: gw1"], "line_brocken", "did you mean 'line_broken' or"),
        (["- inject: Line", "  on: gw1"], "Line", "'line_broken'"),
        (["- inject: line_broken"], "line_broken", "on: gw1"),
        (["- inject: line_broken", "  on: pump"], "pump", "known: gw1"),
        (["- inject: drive_tripped", "  on: pmp"], "pmp", "did you mean 'pump'?"),
        (["- inject: cpu_stopped", "  on: gw1"], "gw1", "leave out on:"),
        (
            ["- inject: line_noise", "  on: gw1", "  settings: {bit_error_rate: 2.0}"],
            "2.0",
            "at most 1.0",
        ),
        (
            ["- inject: line_noise", "  on: gw1", "  settings: {bit_error_rate: true}"],
            "true",
            "a number",
        ),
        (
            ["- inject: line_noise", "  on: gw1", "  settings: {rate: 0.1}"],
            "0.1",
            "did you mean 'bit_error_rate'?",
        ),
        (["- inject: profibus_interrupted", "  settings: {for: 1}"], "1", "it has none"),
        (["- inject: drive_tripped", "  on: pump", "  settings: {display: 5}"], "5", "a text"),
        (["- clear: line_brocken", "  on: gw1"], "line_brocken", "did you mean 'line_broken' or"),
        (["- of_sequence: manual_exampl", "  gateway: gw1"], "manual_exampl", "'manual_example'"),
        (["- of_sequence: start_forward", "  gateway: gw1"], "start_forward", "manual_example"),
        (["- of_sequence: manual_example", "  gateway: gw2"], "gw2", "did you mean 'gw1'?"),
    ],
)
def test_an_unknown_fault_place_setting_or_sequence_is_marked(
    tmp_path: Path, lines: list[str], text: str, help_text: str
) -> None:
    code, where, advice = one(tmp_path, steps(*lines, FINE))
    assert (code, where) == ("FB8004", text)
    assert help_text in advice


def test_a_trip_that_the_series_does_not_have_is_marked(tmp_path: Path) -> None:
    lines = ["- inject: drive_tripped", "  on: pump", "  settings: {display: OC77}", FINE]
    code, where, advice = one(tmp_path, steps(*lines))
    assert (code, where) == ("FB7102", "{display: OC77}")
    assert "OC1" in advice


def test_a_fault_is_cleared_only_where_it_is_and_injected_only_where_it_is_not(
    tmp_path: Path,
) -> None:
    text = steps(
        "- inject: line_noise",
        "  on: gw1",
        "- clear: line_broken",
        "  on: gw1",
        "- inject: line_noise",
        "  on: gw1",
        "- clear: line_noise",
        "  on: gw1",
        "- inject: line_noise",
        "  on: gw1",
        FINE,
    )
    clear, inject = findings(tmp_path, text)
    assert (clear.code, marked(clear)) == ("FB8005", "line_broken")
    assert clear.help == "at this step there is: line_noise on gw1"
    assert (inject.code, marked(inject)) == ("FB8005", "line_noise")
    assert inject.span is not None
    assert inject.span.line == 9


@pytest.mark.parametrize(
    ("key", "pattern"),
    [
        ("output", "E0 0"),
        ("output", "E0 00 01 0B 50 FA 00 C4 0G"),
        ("output", "E0 00 01 0B 50 FA 00 C4 00 00"),
        ("input", "DF 00"),
    ],
)
def test_an_expected_telegram_is_the_right_number_of_bytes(
    tmp_path: Path, key: str, pattern: str
) -> None:
    output = "" if key == "output" else ', output: "xx xx xx xx xx xx xx xx xx"'
    text = steps("- gateway: gw1", f'  telegrams: [{{{key}: "{pattern}"{output}}}]')
    code, where, _ = one(tmp_path, text)
    assert (code, where) == ("FB8013", f'"{pattern}"')


@pytest.mark.parametrize(
    "time",
    ["5", "-5 s", "5 sec", "soon", "99 h", "0 s", "1e3 s", "0.1234 us", "9" * 400 + " s", "''"],
)
def test_an_impossible_time_is_marked(tmp_path: Path, time: str) -> None:
    (found,) = findings(tmp_path, steps(f"- wait: {time}", FINE))
    assert (found.code, marked(found)) == ("FB1007", time)


@pytest.mark.parametrize(
    ("line", "text", "help_text"),
    [
        ("- expects: {cpu.mode: RUN}", "expects", "did you mean 'expect'?"),
        ("- {expect: {cpu.mode: RUN}, wthin: 1 s}", "wthin", "did you mean 'within'?"),
        ("- expect: {drive.pump.frequency: {minn: 3}}", "minn", "did you mean 'min'?"),
    ],
)
def test_an_unknown_key_is_marked_and_the_nearest_is_told(
    tmp_path: Path, line: str, text: str, help_text: str
) -> None:
    found = [item for item in findings(tmp_path, steps(line, FINE)) if item.code == "FB1005"]
    assert [marked(item) for item in found] == [text]
    assert help_text in found[0].help


@pytest.mark.parametrize(
    "line",
    ["- 5", "- {}", "- {wait: 1 s, expect: {cpu.mode: RUN}}", "- {xyzzy: 1}", "- [wait]", "-"],
)
def test_a_step_has_exactly_one_of_the_keys(tmp_path: Path, line: str) -> None:
    (found,) = findings(tmp_path, steps(line, FINE))
    assert found.code == "FB1007"
    assert "set, wait, wait_until, call, expect, inject, clear, " in found.message


@pytest.mark.parametrize("value", ["null", "[1]", "{a: 1}", ""])
def test_what_is_no_single_value_cannot_be_set_and_is_told_once(tmp_path: Path, value: str) -> None:
    (found,) = findings(tmp_path, steps(f"- set: {{{READ}.execute: {value}}}", FINE))
    assert (found.code, found.span and found.span.line) == ("FB1007", 5)


@pytest.mark.parametrize("text", ["", "steps: []\n", "steps:\n", "steps: 5\n"])
def test_a_scenario_needs_steps(tmp_path: Path, text: str) -> None:
    (found,) = findings(tmp_path, text)
    assert found.code in ("FB1006", "FB1007")
    assert found.span is not None


def test_a_scenario_that_checks_nothing_is_a_mistake(tmp_path: Path) -> None:
    (found,) = findings(tmp_path, steps("- wait: 1 s"))
    assert (found.code, found.help) == ("FB8008", "add a step with expect:, or properties:")


def test_unknown_drives_and_refused_parameters_are_marked(tmp_path: Path) -> None:
    text = (
        "drives:\n"
        "  pmp: {load: {torque: 3.0}}\n"
        "  pump: {parameters: {aceleration_time: 1.0, acceleration_time: 99999.0, FA00: 1.0}}\n"
    )
    found = findings(tmp_path, text + steps(FINE))
    assert [(item.code, marked(item)) for item in found] == [
        ("FB8003", "pmp"),
        ("FB1105", "1.0"),
        ("FB7101", "99999.0"),
        ("FB7101", "1.0"),
    ]
    assert "did you mean 'pump'?" in found[0].help
    assert "did you mean 'acceleration_time'" in found[1].help


@pytest.mark.parametrize("load", ["{at_hz: 0.0}", "{torque: 1.0e999}", "{shape: cubic}"])
def test_an_impossible_load_is_a_mistake(tmp_path: Path, load: str) -> None:
    (found,) = findings(tmp_path, f"drives: {{pump: {{load: {load}}}}}\n" + steps(FINE))
    assert found.code == "FB1007"


def test_a_variation_that_the_plant_does_not_allow_is_marked(tmp_path: Path) -> None:
    text = "variations:\n  - {layout: gsd11}\n"
    (found,) = findings(tmp_path, text + steps(FINE))
    assert (found.code, marked(found)) == ("FB2002", "{layout: gsd11}")
    assert "gsd10" in found.help
    assert "plant file" in found.notes[-1].message


def test_everything_is_found_at_once(tmp_path: Path) -> None:
    text = steps(
        "- set: {drive.pump.running: true}",
        "- expect: {drive.pump.runing: true, cpu.mode: run}",
        "- inject: fire",
    )
    assert [item.code for item in findings(tmp_path, text)] == [
        "FB8003",
        "FB8003",
        "FB8009",
        "FB8004",
    ]


def test_a_port_that_the_series_does_not_have_is_marked(tmp_path: Path) -> None:
    text = "drives: {pump: {port: four_wire}}\n" + steps(FINE)
    code, marked_text, advice = one(tmp_path, text)
    assert (code, marked_text) == ("FB7104", "four_wire")
    assert advice == "free ports: serial"
