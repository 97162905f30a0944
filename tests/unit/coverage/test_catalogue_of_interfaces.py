"""Catalogue coverage of a gateway for process data: words, parameter channel, diagnosis."""

from pathlib import Path

import pytest

from harness.installation import Installation, PlantSetup, plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.verify.coverage import watch
from harness.verify.coverage.catalogue import (
    DIAGNOSIS,
    GATEWAY_WORDS,
    PARAMETER_ERRORS,
    READ,
    READ_WORDS,
    TRIPS,
    WRITTEN,
    WRITTEN_WORDS,
    CatalogueCoverage,
)

ROOT = Path(__file__).parents[3]
SCENARIOS = ROOT / "tests" / "scenarios" / "pbdp110"


def job(installation: Installation, mode: int, number: int, value: int = 0) -> None:
    """A job in the parameter channel of the pump, from its edge to its end."""
    engine, base = installation.cpu.engine, "TOS_Plant.gw1.pump.parameter"
    for name, what in (("mode", mode), ("number", number), ("value", value), ("execute", True)):
        engine.set_global(f"{base}.{name}", what)
    installation.run_for(600 * NS_PER_MS)
    engine.set_global(f"{base}.execute", False)
    installation.run_for(50 * NS_PER_MS)


@pytest.fixture(scope="module")
def seen() -> dict[str, set[str]]:
    """What is exercised by a drive that is run, trips, and is asked for what it does not have."""
    coverage = CatalogueCoverage()
    installation = plant(SCENARIOS / "two_channels.yaml", PlantSetup())
    watch(installation, coverage)
    installation.start()
    installation.run_for(2 * NS_PER_S)
    engine = installation.cpu.engine
    engine.set_global("TOS_Plant.gw1.pump.control.enable", True)
    engine.set_global("TOS_Plant.gw1.pump.control.frequency", 30.0)
    installation.run_for(200 * NS_PER_MS)
    engine.set_global("TOS_Plant.gw1.pump.control.run", True)
    job(installation, 1, 0x7FFF)
    job(installation, 1, 0xFC82)
    job(installation, 2, 0x0009, 0xFFFF)
    installation.drives["pump"].trip("OC3")
    installation.run_for(300 * NS_PER_MS)
    installation.drives["pump"].power_off()
    installation.run_for(500 * NS_PER_MS)
    installation.drives["fan"].trip("OC1")
    installation.drives["pump"].power_on()
    installation.run_for(8 * NS_PER_S)
    return {
        group: {item for item, found in items.items() if found}
        for group, items in coverage.items.items()
    }


def test_its_words_go_by_channel(seen: dict[str, set[str]]) -> None:
    words = seen[GATEWAY_WORDS]
    assert {f"pbdp110.a.command.run = {bit}" for bit in (0, 1)} <= words
    assert {f"pbdp110.a.status.running = {bit}" for bit in (0, 1)} <= words
    assert "pbdp110.b.command.run = 1" not in words
    assert {f"pbdp110.a.action.request = {code}" for code in (0, 1, 3)} <= words
    assert "pbdp110.a.action.request = 2" not in words
    assert {f"pbdp110.a.response.response = {code}" for code in (0, 1, 3)} <= words
    assert "pbdp110.a.response.response = 2" not in words


def test_error_codes_are_told_by_responses(seen: dict[str, set[str]]) -> None:
    found = {"pbdp110 0001 data_error", "pbdp110 0002 invalid_number"}
    assert seen[PARAMETER_ERRORS] == found


def test_diagnosis_is_told_when_it_begins_and_when_it_is_over(seen: dict[str, set[str]]) -> None:
    assert seen[DIAGNOSIS] == {
        "pbdp110.a.diagnosis = 1",
        "pbdp110.a.diagnosis = 0",
        "pbdp110.b.diagnosis = 1",
    }


def test_telegrams_at_the_cables_tell_comnos_and_bits(seen: dict[str, set[str]]) -> None:
    assert {"vf-s11 FA00 command_word", "vf-s11 FA01 frequency_setpoint"} <= seen[WRITTEN]
    assert "vf-s11.command.run = 1" in seen[WRITTEN_WORDS]
    assert "vf-s11.status.running = 1" in seen[READ_WORDS]
    assert "pbdp110 FC82 firmware" in seen[READ]
    assert seen[TRIPS] == {"vf-s11 OC3 (03)", "vf-s11 OC1 (01)"}


def test_a_module_without_parameter_channel_has_no_errors_of_one(tmp_path: Path) -> None:
    text = (SCENARIOS / "two_channels.yaml").read_text("utf-8")
    compact = tmp_path / "plant.yaml"
    compact.write_text(text.replace("module2", "module4"), encoding="utf-8")
    coverage = CatalogueCoverage()
    watch(plant(compact, PlantSetup()), coverage)
    assert PARAMETER_ERRORS not in coverage.items
    assert "pbdp110.b.status.online = 1" in coverage.items[GATEWAY_WORDS]
    assert not any("response" in item for item in coverage.items[GATEWAY_WORDS])
