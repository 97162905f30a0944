"""Whatever is done to a scenario file, it runs, fails or is refused with diagnostics: no traceback.

What is accepted is run too, unless it takes long in the plant's own time.
"""

from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError, render
from harness.kernel import NS_PER_S
from harness.scenario import prepare, scenario_cases
from harness.scenario.model import ExpectStep, WaitStep
from harness.scenario.selection import parse_selection

ROOT = Path(__file__).parents[2]
TEXT = f"""\
version: 1
title: Everything a scenario can hold
plant: {(ROOT / "tests" / "scenarios" / "one_drive.yaml").as_posix()}
seed: 3
engine: compiled
tags: [all]
facts: [tos.trig]
variations:
  - {{layout: doc9}}
drives:
  pump:
    load: {{torque: 20.0, shape: linear, at_hz: 40.0, inertia: 1.0}}
    parameters: {{acceleration_time: 1.0, communication_timeout: 0}}
    reply_time: 12 ms
steps:
  - wait: 100 ms
  - set:
      plc.TOS_Plant.gw1.pump.start_forward.frequency: 30.0
      plc.TOS_Plant.gw1.pump.start_forward.execute: true
      drive.pump.comno.deceleration_time: 2
  - expect:
      plc.TOS_Plant.gw1.pump.start_forward.done: true
      drive.pump.frequency: {{min: 0.5, max: 40.0, differs_from: 3}}
      gateway.gw1.status: {{word: tospbdp001.status, bits: {{status_code: 16#1F}}}}
      gateway.gw1.led.device_status: green_flashing
    within: 500 ms
    stays_for: 20 ms
  - of_sequence: manual_example
    gateway: gw1
  - inject: line_noise
    on: gw1
    settings: {{bit_error_rate: 0.01}}
  - gateway: gw1
    telegrams:
      - {{output: "E0 xx 01 0B 50 FA 00 C4 00", input: "DF 00 0B 50 FA 00 C4 00"}}
  - clear: line_noise
    on: gw1
  - inject: drive_tripped
    on: pump
    settings: {{display: OC1}}
"""
VALUES = ("-1", "99999", "x", "null", "[]", "{}", "1.5", "true", "''", "16#FF", "T#2s", "1.0e308")
PIECES = ("", "- ", ": ", "\n", "  ", "plc", "drive.pump", "gw1", "&a ", "*a", "'", '"', "#", "|")
KEYS = ("bits", "word: vf-s11.status", "- wait: 1 ms\n", "[0]", "[1,2]", ".", "..", "\t", "\x00")
TOKENS = st.sampled_from((*VALUES, *PIECES, *KEYS))
LINES = [n for n, line in enumerate(TEXT.splitlines()) if ": " in line]
LONGEST_NS = 5 * NS_PER_S


def outcome(path: Path) -> list[str]:
    """The codes of what is wrong with a scenario file, before or while it runs."""
    codes: list[str] = []
    try:
        scenario = scenario_cases(path)[0].scenario
        time_ns = sum(
            step.wait if isinstance(step, WaitStep) else step.within + step.stays_for
            for step in scenario.steps
            if isinstance(step, WaitStep | ExpectStep)
        )
        for case in scenario_cases(path)[:2]:
            run = prepare(case, load_catalog())
            if time_ns < LONGEST_NS:
                run.run()
    except DiagnosticError as wrong:
        for item in wrong.diagnostics:
            assert render(item)
            codes.append(item.code)
        assert codes
    return codes


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("damaged") / "damaged.scenario.yaml"


def test_the_undamaged_file_gets_as_far_as_its_telegrams(file: Path) -> None:
    file.write_text(TEXT, "utf-8")
    assert set(outcome(file)) == {"FB8006"}


@settings(max_examples=150)
@given(
    edits=st.lists(
        st.tuples(st.integers(0, len(TEXT)), st.integers(0, 12), TOKENS), min_size=1, max_size=3
    )
)
@example(edits=[(TEXT.index("100 ms"), 6, "9" * 30 + " h")])
@example(edits=[(TEXT.index("40.0"), 4, "0.0")])
@example(edits=[(TEXT.index("40.0"), 4, "1.0e-300")])
@example(edits=[(TEXT.index("12 ms"), 5, "0 s")])
def test_a_damaged_scenario_is_run_or_refused(
    file: Path, edits: list[tuple[int, int, str]]
) -> None:
    text = TEXT
    for start, length, token in edits:
        text = text[:start] + token + text[start + length :]
    file.write_text(text, "utf-8")
    for code in outcome(file):
        assert code.startswith("FB")


@settings(max_examples=60)
@given(number=st.sampled_from(LINES), value=st.sampled_from(VALUES))
def test_a_wrong_value_in_any_line_is_run_or_refused(file: Path, number: int, value: str) -> None:
    lines = TEXT.splitlines()
    key, colon, _ = lines[number].partition(": ")
    lines[number] = f"{key}{colon}{value}"
    file.write_text("\n".join(lines), "utf-8")
    for code in outcome(file):
        assert code.startswith("FB")


WORDS = st.sampled_from(["a", "and", "or", "not", "(", ")", "'b c'", '"', " ", "[x]", "\n", "é"])


@given(st.lists(WORDS, max_size=12).map(" ".join) | st.text(max_size=30))
def test_any_text_is_an_expression_or_is_refused(text: str) -> None:
    try:
        chosen = parse_selection(text)
    except DiagnosticError as wrong:
        found = wrong.diagnostics
    else:
        found = ()
        assert chosen(["a", "b c"]) in (True, False)
    assert [item.code for item in found] in ([], ["FB8011"])
    assert all(render(item) for item in found)
