"""The `iec` text keeps to what MATIEC takes. What it refuses stands in `matiec_subset`."""

from pathlib import Path

import pytest
from matiec_subset import refused

from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.plant import in_dialect, load_plant

EXAMPLES = Path(__file__).parents[3] / "examples"
CATALOG = load_catalog()


def generated(example: str) -> str:
    plant = load_plant(EXAMPLES / example / "plant.yaml", CATALOG)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in plant.gateways)
    changed = plant.model_copy(update={"gateways": gateways})
    files = generate(in_dialect(changed, "iec", CATALOG), CATALOG).files
    (text,) = (file.text for file in files if file.name.endswith(".st"))
    return text


@pytest.mark.parametrize("example", ["manual_example", "five_drives", "devicenet"])
def test_nothing_in_a_generated_plant_is_refused(example: str) -> None:
    text = generated(example)
    assert text.count("END_FUNCTION_BLOCK") >= 5
    assert refused(text) == []


BLOCK = """FUNCTION_BLOCK Fan
    VAR_INPUT
        on1 : BOOL;   (* run *)
    END_VAR
    VAR
        count : INT := 5;
        timer : TON;
    END_VAR
    timer(IN := on1, PT := T#1s500ms);
    IF timer.Q AND NOT (count > 16#0A) THEN
        count := ABS(count) + 1;
    END_IF;
END_FUNCTION_BLOCK
"""


def test_a_plain_block_is_taken() -> None:
    assert refused(BLOCK) == []


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("(* run *)", "// run", "// is no operator"),
        ("(* run *)", "(* run (* now *)", "a comment in a comment"),
        ("count := ABS", "count.%X0 := ABS", "no token|no located"),
        ("on1 : BOOL", "on : BOOL", "the name ON is taken"),
        ("on1 : BOOL", "step : BOOL", "the name STEP is taken"),
        ("on1 : BOOL", "limit : BOOL", "the name LIMIT is taken"),
        ("on1 : BOOL", "run_ : BOOL", "underscore"),
        ("count : INT", "count : LINT", "the type LINT is not there yet"),
        ("timer : TON", "timer : Later", "the type LATER is not there yet"),
        ("END_IF;", "END_IF", "END_IF without a semicolon"),
        ("        count := ABS(count) + 1;\n", "", "nothing stands behind THEN"),
        ("ABS(count)", "BITREVERSE(count)", "BITREVERSE is no function"),
        ("T#1s500ms", "T#1.5s500ms", "no token"),
        ("    VAR\n", "    VAR_TEMP\n", "VAR_TEMP takes no initial values"),
        ("VAR_INPUT", "VAR_IN_OUT", None),
        ("BOOL;", "BOOL := TRUE;", None),
        ("16#0A", "16#0a", "no token"),
        ("count := ABS", "count += ABS", "is no operator"),
        ("count := ABS", "%QB0 := ABS", "no located global variable"),
    ],
)
def test_what_is_refused_is_told(old: str, new: str, why: str | None) -> None:
    assert old in BLOCK
    found = refused(BLOCK.replace(old, new, 1))
    if why is None:
        assert found == []
    else:
        assert any(part in " ".join(found) for part in why.split("|")), found
