"""Campaigns of plants with gateways for process data, alone and beside others."""

from pathlib import Path

import pytest

from harness.verify.campaign.files import campaign_settings
from harness.verify.campaign.trials import case_from, drawn, subject_of, try_seeds

ROOT = Path(__file__).parents[4]
TWO = ROOT / "tests" / "scenarios" / "pbdp110" / "two_channels.yaml"
LINE = """\
  - name: gw2
    type: tospbdp001
    layout: whole10
    profibus_address: 4
    access: dpxx_dat
    hardware_identifier: 280
    input_address: 64
    output_address: 64
    drives:
      - {name: mixer, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}
"""


@pytest.fixture(scope="module")
def both(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A plant with a gateway of each kind."""
    file = tmp_path_factory.mktemp("both") / "plant.yaml"
    file.write_text(TWO.read_text("utf-8") + LINE, encoding="utf-8")
    return file


def test_every_module_that_the_plant_allows_is_drawn_and_can_run() -> None:
    settings = campaign_settings([TWO], [])
    entries = [drawn(settings, seed) for seed in range(0, 600, 10)]
    for entry in entries[:20]:
        case_from(entry, TWO)
        assert "gateways" not in entry
    programs = [entry["variations"][0] for entry in entries]
    assert {program.get("layout") for program in programs} == {"module2", "module4", None}
    assert {program.get("dialect") for program in programs} >= {"tia", "step7", "iec", "twincat"}
    assert any("bus_lost" in program.get("options", ()) for program in programs)


def test_faults_are_those_that_the_gateway_can_have() -> None:
    places = subject_of(TWO.as_posix()).places
    assert places["drive_disconnected"] == ("pump", "fan")
    assert places["gateway_unpowered"] == ("gw1",)
    assert places["gateway_trigger_stuck"] == places["line_noise"] == ()


def test_parameters_are_read_and_written_meanwhile() -> None:
    settings = campaign_settings([TWO], [])
    paths = {
        path: value
        for seed in range(20)
        for step in drawn(settings, seed)["steps"]
        for path, value in step.get("set", {}).items()
    }
    assert "plc.TOS_Plant.gw1.fan.parameter.number" in paths
    assert not any("instTrigger" in path for path in paths)


def test_gateways_of_both_kinds_keep_their_layouts(both: Path) -> None:
    subject = subject_of(both.as_posix())
    assert len(subject.variations) > 4
    assert not any("layout" in entry for entry in subject.variations)
    settings = campaign_settings([both], [])
    triggers = [step for step in drawn(settings, 3)["steps"] if "Trigger" in str(step)]
    assert len(triggers) == 1
    assert try_seeds(settings, 3, 4).failures == ()


def test_seeds_of_the_shipped_blocks_hold_all_rules_and_recover() -> None:
    chunk = try_seeds(campaign_settings([TWO], []), 9, 11)
    assert chunk.failures == ()
    assert len(chunk.configurations) == 2


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, 200, 20))
def test_many_seeds_of_the_shipped_blocks_hold_all_rules_and_recover(first: int) -> None:
    assert try_seeds(campaign_settings([TWO], []), first, first + 20).failures == ()
