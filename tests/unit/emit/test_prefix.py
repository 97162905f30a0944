"""A prefix of the plant's own: every name follows, and what does not fit is told."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.plant import LANGUAGES, Plant, PlantDialect, changed, in_dialect, load_plant, with_prefix
from harness.scenario import run_case, scenario_cases
from harness.scenario.model import Variation

ROOT = Path(__file__).parents[3]
PLANT = ROOT / "examples" / "five_drives" / "plant.yaml"
CATALOG = load_catalog()


def plant(dialect: str, **values: object) -> Plant:
    read = load_plant(PLANT, CATALOG)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in read.gateways)
    there = in_dialect(read.model_copy(update={"gateways": gateways}), dialect, CATALOG)
    return changed(there, CATALOG, **values)


def texts(files: GeneratedSet) -> str:
    """Everything that is generated, without the hash of the inputs and ids made from names."""
    text = "".join(f"{file.name}\n{file.text}" for file in files.files)
    without_ids = re.sub(r'Id="\{[0-9a-f-]+\}"', "Id", text)
    return without_ids.replace(files.inputs_hash, "HASH")


def refused(**values: object) -> Diagnostic:
    with pytest.raises(DiagnosticError) as failure:
        generate(plant("step7", **values), CATALOG)
    return failure.value.diagnostics[0]


@pytest.mark.parametrize("dialect", LANGUAGES)
def test_the_text_is_the_same_but_for_the_prefix(dialect: str) -> None:
    usual = texts(generate(plant(dialect), CATALOG))
    own = texts(generate(plant(dialect, prefix="HAL_"), CATALOG))
    assert not re.search("TOS_|typeTos", own)
    assert with_prefix(usual.replace("instTOS_", "instHAL_"), "HAL_") == own


@pytest.mark.parametrize(
    ("prefix", "block", "type_"),
    [
        ("ACME_", "ACME_Main", "typeAcmeDrive"),
        ("Hall2_", "Hall2_Main", "typeHall2Drive"),
        ("myLine_", "myLine_Main", "typeMyLineDrive"),
    ],
)
def test_types_have_the_prefix_in_their_own_way(prefix: str, block: str, type_: str) -> None:
    names = {one.name for one in generate(plant("tia", prefix=prefix), CATALOG).blocks}
    assert {block, type_} <= names


@pytest.mark.parametrize("dialect", ["tia", "iec"])
@pytest.mark.parametrize("written", ["TOS_", "HAL_"])
def test_a_scenario_runs_on_a_plant_with_a_prefix_whichever_it_names(
    dialect: PlantDialect, written: str, tmp_path: Path
) -> None:
    scenario = ROOT / "tests" / "scenarios" / "start_and_stop.scenario.yaml"
    text = with_prefix(scenario.read_text("utf-8"), written)
    home = scenario.parent.as_posix()
    moved = re.sub(r"(?m)^plant: ", f"plant: {home}/", text)
    path = tmp_path / "own.scenario.yaml"
    path.write_text(moved, "utf-8")
    variation = Variation(dialect=dialect, prefix="HAL_", access="process_image", plc=None)
    if dialect == "iec":
        variation = variation.model_copy(update={"plc": "iec"})
    case = replace(scenario_cases(path)[0], variation=variation)
    result = run_case(case, CATALOG)
    assert result.passed, result


@pytest.mark.parametrize("prefix", ["", "_", "ACME", "2ND_", "A__", "A B_", "Halle_2_", "x;y_"])
def test_what_makes_no_names_is_fb2021(prefix: str) -> None:
    found = refused(prefix=prefix)
    assert found.code == "FB2021"
    assert re.search(r"[A-Za-z][A-Za-z0-9]*_$", found.help)


def test_a_prefix_that_is_too_long_is_fb2021() -> None:
    assert "at most 12" in refused(prefix="LONG_LONG_LONG".replace("_", "") + "_").help


def test_a_prefix_that_is_too_long_for_the_dialect_is_fb5010() -> None:
    found = refused(prefix="CONVEYOR_")
    assert found.code == "FB5010"
    assert "shorter than CONVEYOR_" in found.help or "a prefix of at most" in found.help


def test_a_drive_may_not_be_called_like_a_block() -> None:
    read = plant("tia")
    gateway = read.gateways[0]
    drives = (gateway.drives[0].model_copy(update={"name": "acme_main"}), *gateway.drives[1:])
    named = read.model_copy(update={"gateways": (gateway.model_copy(update={"drives": drives}),)})
    assert changed(named, CATALOG)
    with pytest.raises(DiagnosticError) as failure:
        changed(named, CATALOG, prefix="ACME_")
    assert failure.value.diagnostics[0].code == "FB2012"


def test_a_variable_that_is_called_like_a_block_is_fb5012() -> None:
    read = plant("tia")
    gateway = read.gateways[0]
    drives = (gateway.drives[0].model_copy(update={"name": "MAIN"}), *gateway.drives[1:])
    named = read.model_copy(update={"gateways": (gateway.model_copy(update={"drives": drives}),)})
    assert generate(named, CATALOG)
    with pytest.raises(DiagnosticError) as failure:
        generate(changed(named, CATALOG, prefix="inst_"), CATALOG)
    found = failure.value.diagnostics[0]
    assert found.code == "FB5012"
    assert "'inst_MAIN'" in found.message
    assert len(found.notes) == 2


def test_the_broken_plant_file_is_fb5012_at_its_prefix() -> None:
    bad = load_plant(Path(__file__).parents[1] / "bad" / "FB5012_clash.yaml", CATALOG)
    with pytest.raises(DiagnosticError) as failure:
        generate(bad, CATALOG)
    assert {item.code for item in failure.value.diagnostics} == {"FB5012"}
    span = failure.value.diagnostics[0].span
    assert span is not None
    assert (span.line, span.column) == (5, 9)
