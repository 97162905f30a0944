"""Catalogue coverage: what runs of a plant exercise of what the catalogue says."""

from pathlib import Path

import pytest

from harness.installation import PlantSetup, plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc.consistent_data import RetVal
from harness.verify.coverage import (
    Coverage,
    catalogue_of,
    catalogue_rows,
    load,
    parse_limits,
    too_little,
    watch,
    write,
)
from harness.verify.coverage.catalogue import (
    CODES,
    DIAGNOSIS,
    GATEWAY_WORDS,
    GENERAL_STATUS,
    GROUPS,
    LAMPS,
    PARAMETER_ERRORS,
    READ,
    READ_RESULTS,
    REFUSALS,
    STEPS,
    TIMEOUT_ACTIONS,
    TRIPS,
    WRITE_RESULTS,
    WRITTEN,
    WRITTEN_WORDS,
    CatalogueCoverage,
)

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def driven() -> Coverage:
    """A plant whose drive is started, trips and is asked for its current."""
    coverage = Coverage()
    source = ROOT / "tests" / "scenarios" / "one_drive.yaml"
    installation = plant(source, PlantSetup(probes=(coverage,)))
    coverage.name_plant(installation.plan.name)
    watch(installation, coverage.catalogue)
    installation.start()
    installation.run_for(200 * NS_PER_MS)
    drive = installation.drives["pump"]
    engine = installation.cpu.engine
    for sequence in ("start_forward", "read_current"):
        engine.set_global(f"TOS_Plant.gw1.pump.{sequence}.execute", True)
        installation.run_for(1 * NS_PER_S)
    drive.trip("OC1")
    installation.run_for(100 * NS_PER_MS)
    return coverage


def seen(coverage: Coverage, group: str) -> set[str]:
    """What was exercised of a group."""
    return {item for item, found in catalogue_of(coverage).items[group].items() if found}


def test_bits_of_control_and_status_word_are_seen_as_0_and_as_1(driven: Coverage) -> None:
    found = seen(driven, GATEWAY_WORDS)
    assert {f"tospbdp001.control.command_new = {bit}" for bit in (0, 1)} <= found
    assert "tospbdp001.control.data_valid = 1" in found


def test_comnos_and_bits_are_told_by_telegrams(driven: Coverage) -> None:
    assert seen(driven, WRITTEN) == {"vf-s11 FA00 command_word", "vf-s11 FA01 frequency_setpoint"}
    assert any(item.startswith("vf-s11 FE03") for item in seen(driven, READ))
    assert "vf-s11.command.run = 1" in seen(driven, WRITTEN_WORDS)


def test_trips_are_told_by_drives(driven: Coverage) -> None:
    assert seen(driven, TRIPS) == {"vf-s11 OC1 (01)"}


def test_steps_and_codes_follow_from_statements(driven: Coverage) -> None:
    assert {"start_forward step 1", "start_forward step 2", "read_current step 1"} <= seen(
        driven, STEPS
    )
    items = catalogue_of(driven).items
    assert items[CODES]["TOS_Telegram 16#8401"] is False
    assert "stop step 1" in items[STEPS]


def test_results_of_instructions_are_noted_where_a_program_calls_them() -> None:
    coverage = CatalogueCoverage()
    names = [f"16#{one:04X} {one.name.lower().replace('_', ' ')}" for one in RetVal]
    coverage.see(READ_RESULTS, names[0])
    assert not coverage.items
    coverage.know(READ_RESULTS, names)
    coverage.see(READ_RESULTS, names[0])
    (group,) = coverage.groups()
    assert (group.exercised.reached, group.missing) == (1, names[1:])


def test_it_is_kept_in_the_file_and_merged(driven: Coverage, tmp_path: Path) -> None:
    write(driven, tmp_path / "coverage.json")
    both = Coverage()
    both.merge([load(tmp_path / "coverage.json"), Coverage()])
    assert catalogue_of(both).items == catalogue_of(driven).items


def test_the_table_names_what_is_missing(driven: Coverage) -> None:
    rows = catalogue_rows(driven)
    others = {READ_RESULTS, WRITE_RESULTS, PARAMETER_ERRORS, DIAGNOSIS}
    others |= {REFUSALS, LAMPS, GENERAL_STATUS, TIMEOUT_ACTIONS}
    assert [row[0] for row in rows[:-1]] == [name for name in GROUPS if name not in others]
    assert "and 35 more" in {row[0]: row[2] for row in rows}[TRIPS]
    assert catalogue_rows(Coverage()) == []


def test_it_can_be_demanded(driven: Coverage) -> None:
    assert not list(too_little(driven, parse_limits("catalogue=5")))
    (found,) = too_little(driven, parse_limits("catalogue=90"))
    assert "catalogue coverage" in found.message
    (none,) = too_little(Coverage(), parse_limits("catalogue=5"))
    assert "nothing was counted" in none.message
