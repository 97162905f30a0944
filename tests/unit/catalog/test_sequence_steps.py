"""What can be wrong in the steps of a sequence, each with its place."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError

ROOT = Path(__file__).parents[3]
OWN = (ROOT / "tests" / "unit" / "blocks" / "own_sequence.yaml").read_text("utf-8")


@pytest.mark.parametrize(
    ("change", "code", "text", "advice"),
    [
        (("to: stopping", "to: stoping"), "FB1107", "stoping", "did you mean 'stopping'?"),
        (("repeat: start", "repeat: reading"), "FB1107", "reading", ""),
        (("label: reading", "label: stopping"), "FB1102", "stopping", "keep one of the two"),
        (("label: start", "label: end"), "FB1107", "end", ""),
        (("branch: trip\n", "branch: trp\n"), "FB1107", "trp", "did you mean 'trip'?"),
        (("when: {equals: 0}", "when: {}"), "FB1107", "{}", "give equals, at_least"),
        (("{equals: 0}", "{bits: {a: 1}}"), "FB1107", "{a: 1}", "wait for the bits of a ComNo"),
        (("{bits: {running: 1, tripped: 0}}", "{bits: {runing: 1}}"), "FB1105", "1", "'running'"),
        (("wait: output_frequency", "wait: output_freq"), "FB1105", "output_freq", "did you"),
        (("at_most: 10.5", "at_most: 1000.0"), "FB1107", "1000.0", "use 0 to 655.35 Hz"),
        (("repeat: start", "repeat: reading"), "FB1107", "reading", "a repetition goes back"),
        (("at_least: 9.5", "at_least: 11.0"), "FB1107", None, "exchange the two numbers"),
        (("name: trip, type: WORD", "name: trip, type: BOOL"), "FB1107", "trip", ""),
        (
            ("scaled_by: frequency_setpoint", "scaled_by: acceleration_time"),
            *("FB1107", "frequency", "say scaled_by: frequency_setpoint"),
        ),
        (
            ("scaled_by: output_current_held", "scaled_by: output_frequency"),
            *("FB1107", "current", "say scaled_by: output_current_held"),
        ),
        (
            (
                "  - wait: status\n",
                "  - {write: '0011', literal: C351, note: x}\n  - wait: status\n",
            ),
            *("FB1107", "C351", "use 0BB8 to C350, 30 to 500 Hz"),
        ),
        (("times: 3", "times: 1"), "FB1007", "1", ""),
        (("    limit_ms: 1000\n", ""), "FB1006", None, ""),
    ],
)
def test_a_wrong_step_is_found_at_its_place(
    change: tuple[str, str], code: str, text: str | None, advice: str, tmp_path: Path
) -> None:
    assert change[0] in OWN
    (tmp_path / "sequences").mkdir()
    (tmp_path / "sequences" / "pulse.yaml").write_text(OWN.replace(*change), "utf-8")
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path])
    found = next(item for item in failure.value.diagnostics if item.code == code)
    assert advice in (found.help or "")
    assert found.span is not None
    assert text is None or found.span.text == text


def test_the_example_of_the_page_is_a_sequence(tmp_path: Path) -> None:
    page = (ROOT / "docs" / "reference" / "sequences.md").read_text("utf-8")
    (tmp_path / "sequences").mkdir()
    text = page.split("```yaml\n")[1].split("```")[0]
    (tmp_path / "sequences" / "start_and_wait.yaml").write_text(text, "utf-8")
    sequence = load_catalog([tmp_path]).sequence("start_and_wait")
    assert len(sequence.steps) == 5
    assert all(f"`{key}:" in page for key in ("write", "read", "delay", "wait", "branch", "repeat"))
