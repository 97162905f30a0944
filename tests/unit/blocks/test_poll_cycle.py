"""The calculated poll cycle, compared with what the simulated plant takes; the warning about it."""

from pathlib import Path

import pytest

from fbgen.blocks.plan import plan_blocks
from fbgen.blocks.poll_cycle import poll_cycle, slow_polls
from fbgen.catalog import Catalog
from fbgen.diagnostics import Severity
from fbgen.plant import Plant, load_plant, read_plant
from fbgen.source import Source
from harness.installation import DriveConditions, PlantSetup, build_plant
from harness.kernel import NS_PER_MS
from tests.unit.blocks.programs import FIVE_DRIVES, shipped_catalog

ROUNDS = 4
BAD = Path(__file__).parents[1] / "bad" / "FB5014_slow_poll.yaml"


def five_drives(cycle_ms: int, access: str) -> Plant:
    text = FIVE_DRIVES.replace("cycle_time_ms: 10", f"cycle_time_ms: {cycle_ms}")
    if access == "process_image":
        text = text.replace("address: 256", "address: 0").replace("per_identifier", access)
    return read_plant(Source("plant.yaml", text), shipped_catalog())


def measured_round_ms(plant: Plant, catalog: Catalog) -> float:
    """The mean of some rounds, with drives that take as long as they may."""
    reply_ns = round(catalog.drive("vf-s11").times.reply_max.ms * NS_PER_MS)
    slow = {drive.name: DriveConditions(reply_time_ns=reply_ns) for drive in plant.drives}
    installation = build_plant(plant, catalog, PlantSetup(drives=slow))
    recorder = installation.record_telegrams()["gw1"]
    installation.start()
    begins: list[int] = []
    while len(begins) <= ROUNDS:
        installation.run_for(500 * NS_PER_MS)
        begins = [
            record.sent_ns
            for record in recorder.records
            if record.output[3] == 1 and record.output[5:7] == b"\xfc\x90"
        ]
    return (begins[ROUNDS] - begins[0]) / ROUNDS / NS_PER_MS


@pytest.mark.parametrize(
    ("cycle_ms", "access"),
    [(5, "per_identifier"), (10, "per_identifier"), (10, "process_image"), (20, "per_identifier")],
)
def test_the_simulated_plant_takes_what_was_calculated(cycle_ms: int, access: str) -> None:
    catalog = shipped_catalog()
    plant = five_drives(cycle_ms, access)
    calculated = poll_cycle(plant, plant.gateways[0], catalog).round_ms
    assert measured_round_ms(plant, catalog) == pytest.approx(calculated, rel=0.2)


def test_five_drives_on_one_gateway_take_more_than_a_second() -> None:
    plant = five_drives(10, "per_identifier")
    found = poll_cycle(plant, plant.gateways[0], shipped_catalog())
    assert (found.reads, found.read_ms, found.round_ms) == (20, 70, 1400)
    assert list(slow_polls(plant, shipped_catalog())) == []


def test_a_round_that_is_longer_than_the_plant_allows_is_a_warning() -> None:
    (found,) = plan_blocks(load_plant(BAD, shipped_catalog()), shipped_catalog()).warnings
    assert (found.code, found.severity) == ("FB5014", Severity.WARNING)
    assert found.span is not None
    assert found.span.source.line_column(found.span.start) == (7, 11)
    assert "1400 ms, more than poll_limit_ms (1000)" in found.message
    assert "at most 3 drives" in found.help


def test_without_a_poll_nothing_is_said() -> None:
    text = BAD.read_text("utf-8").replace("status_poll: true", "status_poll: false")
    plant = read_plant(Source("plant.yaml", text), shipped_catalog())
    assert list(slow_polls(plant, shipped_catalog())) == []


@pytest.mark.parametrize(
    ("limit_ms", "advice"), [(300, "put at most one drive"), (100, "call TOS_Main more often")]
)
def test_the_advice_is_one_that_helps(limit_ms: int, advice: str) -> None:
    plant = five_drives(10, "per_identifier").model_copy(update={"poll_limit_ms": limit_ms})
    (found,) = slow_polls(plant, shipped_catalog())
    assert advice in (found.help or "")
