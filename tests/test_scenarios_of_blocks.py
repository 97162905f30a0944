"""Every generated block has scenarios that show it, and these depend on it.

A scenario names the blocks that it shows by tags: the block's name in snake case, without the name
of its gateway or line (`tos_consistent_io` for `TOS_ConsistentIo_gw1`). That it really shows them
is seen by taking the statements out of the block: then one of its variations has to fail.
"""

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from fbgen.catalog import Catalog, load_catalog
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Program
from fbgen.plant import Plant, changed, load_plant
from harness.installation.programs import generated_program
from harness.scenario import ScenarioCase, find_scenarios, run_case, scenario_cases, staging

ROOT = Path(__file__).parents[1]
FILES = find_scenarios([ROOT / "tests" / "scenarios", ROOT / "examples"])
CATALOG = load_catalog()
OF_A_BLOCK = re.compile(r"(?:tos|pbdp|tip|mb|dev)_\w+|ob\d+")
PER_UNIT = re.compile(r"_(?:gw|line|net)\d+$")
PAGE = ROOT / "docs" / "reference" / "scenario-files.md"
ACCESS_WAYS = {"per_identifier", "dpxx_dat", "process_image"}


def tag_of(block: str) -> str:
    """`tos_consistent_io` for `TOS_ConsistentIo_gw1`."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", PER_UNIT.sub("", block))
    return words.casefold()


def everything(family: str) -> Plant:
    """A polled line with every sequence of the catalogue, on a CPU of this family."""
    plant = load_plant(ROOT / "examples" / "five_drives" / "plant.yaml", CATALOG)
    return changed(plant, CATALOG, plc=family, sequences=tuple(sorted(CATALOG.sequences)))


def process_data() -> Plant:
    """A gateway for process data with a drive at each channel, whose diagnosis is read."""
    plant = load_plant(ROOT / "examples" / "pbdp110" / "plant.yaml", CATALOG)
    (gateway,) = plant.gateways
    gateway = gateway.model_copy(update={"diagnosis_address": 2046})
    return plant.model_copy(update={"gateways": (gateway,)})


def example_plant(example: str) -> Plant:
    """A serial line of the PLC, by the Toshiba protocol or MODBUS, or a DeviceNet network."""
    return load_plant(ROOT / "examples" / example / "plant.yaml", CATALOG)


def blocks_of(program: Program) -> dict[str, Block]:
    """The blocks with statements that were generated, by their tags."""
    return {
        tag_of(block.name): block
        for block in program.blocks.values()
        if block.kind is not BlockKind.PROGRAM
    }


@cache
def generated_tags() -> frozenset[str]:
    """The tags of all blocks that are generated, whatever drives are connected to."""
    plants = (
        everything("s7-1500"),
        everything("s7-400"),
        process_data(),
        *map(example_plant, ("serial", "modbus", "devicenet")),
    )
    return frozenset(tag for plan in plants for tag in blocks_of(generated_program(plan, CATALOG)))


CASES = [case for path in FILES for case in scenario_cases(path)]


def plant_of(case: ScenarioCase) -> Path:
    """The plant file of a scenario."""
    return case.path.parent / case.scenario.plant


@cache
def tagged(path: Path) -> tuple[str, ...]:
    """The blocks that a scenario says it shows."""
    first, *_ = scenario_cases(path)
    return tuple(tag for tag in first.scenario.tags if OF_A_BLOCK.fullmatch(tag))


def test_the_tag_of_a_block_is_its_name() -> None:
    assert tag_of("TOS_ConsistentIo_gw1") == "tos_consistent_io"
    assert tag_of("TOS_HzToWord") == "tos_hz_to_word"
    assert tag_of("TOS_Seq_start_forward") == "tos_seq_start_forward"
    assert tag_of("PBDP_TripText_vf_s11") == "pbdp_trip_text_vf_s11"
    assert tag_of("OB122") == "ob122"
    assert tag_of("TIP_Port_line1") == "tip_port"
    assert tag_of("DEV_Network_net1") == "dev_network"


def test_every_generated_block_has_a_scenario() -> None:
    named = {tag for path in FILES for tag in tagged(path)}
    assert {"tos_telegram", "tos_seq_stop", "pbdp_io", "ob86"} <= generated_tags()
    assert generated_tags() - named == set()


def test_every_tag_of_a_block_is_that_of_a_generated_one() -> None:
    wrong = {path.name: set(tagged(path)) - generated_tags() for path in FILES}
    assert {name: tags for name, tags in wrong.items() if tags} == {}


def test_every_access_way_has_scenarios_of_its_own() -> None:
    ways = {
        case.variation.access or load_plant(plant_of(case), CATALOG).gateways[0].access
        for case in CASES
        if "tos_consistent_io" in case.scenario.tags
    }
    assert ways == ACCESS_WAYS


def test_every_situation_of_the_reference_has_its_scenario() -> None:
    _, _, section = PAGE.read_text("utf-8").partition("| situation | scenario |")
    table, _, _ = section.partition("\n\n")
    rows = re.findall(r"^\| [^`|]+ \| (.+) \|$", table, re.M)
    named = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    assert len(rows) > 10
    assert named - {path.name.partition(".")[0] for path in FILES} == set()


FIRST = {tag: path for path in reversed(FILES) for tag in tagged(path)}
SHOWN = [
    pytest.param(
        path,
        tag,
        id=f"{path.name.partition('.')[0]}-{tag}",
        marks=() if FIRST[tag] == path else pytest.mark.slow,
    )
    for path in FILES
    for tag in tagged(path)
]
"""Each block with its first scenario; the others are slow."""


@pytest.mark.parametrize(("path", "tag"), SHOWN)
def test_a_scenario_fails_without_what_its_block_does(
    path: Path, tag: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    emptied: list[str] = []

    def without(plan: Plant, catalog: Catalog) -> Program:
        program = generated_program(plan, catalog)
        block = blocks_of(program).get(tag)
        if block is None:
            return program
        emptied.append(block.name)
        return replace(program, bodies={**program.bodies, block: ()})

    monkeypatch.setattr(staging, "generated_program", without)
    results = (run_case(case, CATALOG) for case in scenario_cases(path))
    failure = next((result for result in results if not result.passed), None)
    assert emptied, f"no plant of this scenario has a block {tag}"
    assert failure is not None, f"{emptied[0]} does nothing, and nobody notices"
    assert {found.code for found in failure.failures} <= {"FB8001", "FB8006", "FB8012", "FB8070"}
