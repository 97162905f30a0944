"""Whatever text is given, the YAML loader gives data or diagnostics, and never anything else."""

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from fbgen.catalog import load_yaml
from fbgen.diagnostics import Diagnostic, DiagnosticError, render
from fbgen.plant import read_plant, write_commented_plant
from fbgen.source import Source

PLANT = write_commented_plant()
YAML_LIKE = st.text(alphabet="ab:-[]{}&*!#|>'\"%@`,?\n\t 01.~<=\\\x85\ufeff\u2028é", max_size=60)


def findings(text: str) -> tuple[Diagnostic, ...]:
    """What is wrong with a YAML text."""
    try:
        load_yaml(Source("x.yaml", text))
    except DiagnosticError as failure:
        return failure.diagnostics
    return ()


def plant_findings(text: str) -> tuple[Diagnostic, ...]:
    """What is wrong with a plant file."""
    try:
        read_plant(Source("plant.yaml", text))
    except DiagnosticError as failure:
        return failure.diagnostics
    return ()


@given(text=st.text(max_size=80) | YAML_LIKE)
@example(text="\ufeffa: 1\r\n")
def test_any_text_gives_data_or_diagnostics_with_a_place(text: str) -> None:
    for item in findings(text):
        assert item.code.startswith("FB10")
        assert item.span is not None
        assert render(item)


@given(
    start=st.integers(0, len(PLANT)),
    length=st.integers(0, 30),
    text=YAML_LIKE | st.sampled_from(["-1", "99999", "x", "null", "[]", "{}", "1.5", "true", ""]),
)
def test_a_damaged_plant_file_gives_a_plant_or_diagnostics(
    start: int, length: int, text: str
) -> None:
    for item in plant_findings(PLANT[:start] + text + PLANT[start + length :]):
        assert item.code.startswith(("FB1", "FB2"))
        assert render(item)


LINES = [n for n, line in enumerate(PLANT.splitlines()) if ":" in line.partition("#")[0]]


@pytest.mark.parametrize("value", ["[[]]", "-1", "99999999999999999999", "x y", "{a: b}", "1.5e9"])
def test_a_wrong_value_in_any_line_is_reported(value: str) -> None:
    for number in LINES:
        lines = PLANT.splitlines()
        key, colon, _ = lines[number].partition(":")
        if key.strip() in ("title", "heartbeat_frame"):
            continue
        lines[number] = f"{key}{colon} {value}"
        found = plant_findings("\n".join(lines))
        assert found, lines[number]
        assert all(item.code.startswith(("FB1", "FB2")) for item in found)
