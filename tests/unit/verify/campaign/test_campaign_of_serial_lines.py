"""A campaign of a plant without gateways: its drives are on a serial line."""

from pathlib import Path

from harness.verify.campaign.files import campaign_settings
from harness.verify.campaign.trials import case_from, drawn, subject_of, try_seeds

PLANT = Path(__file__).parents[4] / "examples" / "serial" / "plant.yaml"


def test_every_language_is_drawn_and_can_run() -> None:
    settings = campaign_settings([PLANT], [])
    entries = [drawn(settings, seed) for seed in range(0, 400, 10)]
    for entry in entries[:10]:
        case_from(entry, PLANT)
    dialects = {entry["variations"][0].get("dialect") for entry in entries}
    assert dialects >= {"tia", "step7", "iec", "twincat"}


def test_faults_are_those_of_lines_and_drives() -> None:
    places = subject_of(PLANT.as_posix()).places
    assert places["line_noise"] == ("line1",)
    assert places["drive_disconnected"] == ("pump", "fan")
    assert places["gateway_unpowered"] == ()


def test_a_seed_ends_well() -> None:
    assert try_seeds(campaign_settings([PLANT], []), 0, 1).failures == ()
