"""The whole installation: generated text against simulated gateway and inverters."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import load_plant
from fbgen.source import Source
from harness.drives import Load
from harness.installation import DriveConditions, PlantSetup, build_plant, generated_sources, plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc import CpuMode

EXAMPLES = Path(__file__).parents[3] / "examples"
FIVE = EXAMPLES / "five_drives" / "plant.yaml"
MANUAL = EXAMPLES / "manual_example" / "plant.yaml"


@pytest.fixture(scope="module")
def five_sources() -> list[Source]:
    catalog = load_catalog()
    return generated_sources(load_plant(FIVE, catalog), catalog)


def polled(sources: list[Source], seed: int = 0) -> list[tuple[int, bytes, bytes | None]]:
    installation = plant(FIVE, PlantSetup(seed=seed, engine="reference", sources=sources))
    recorder = installation.record_telegrams()["gw1"]
    installation.start()
    installation.run_for(2 * NS_PER_S)
    assert installation.cpu.mode is CpuMode.RUN
    return [(record.sent_ns, record.output, record.input) for record in recorder.records]


@pytest.mark.fact("tos.status.poll")
def test_the_generated_blocks_read_four_values_of_every_drive_in_turn(five_sources):
    records = polled(five_sources)
    asked = [(output[3], output[5:7].hex()) for _, output, _ in records]
    first, values = (0, "fc90"), ("fc90", "fd01", "fd00", "fe03")
    spacer = (0, "fd01")
    wanted = [first, spacer, *((inv_no, comno) for inv_no in range(5) for comno in values)]
    assert asked[: len(wanted)] == wanted
    assert all(reply is not None for _, _, reply in records[: len(wanted)])


def test_the_same_seed_gives_the_same_telegrams_at_the_same_times(five_sources):
    once = polled(five_sources, 3)
    assert polled(five_sources, 3) == once
    assert polled(five_sources, 4) != once


def test_drives_are_set_as_section_6_of_the_manual_says(five_sources):
    installation = plant(FIVE, PlantSetup(engine="reference", sources=five_sources))
    drive = installation.drives["drive3"]
    words = [drive.read_word(name) for name in ("0800", "0801", "0802", "0803", "0011")]
    assert words == [4, 1, 3, 1, 5000]


def test_conditions_of_a_drive_win_over_the_manual(five_sources):
    conditions = DriveConditions(
        load=Load(50.0), parameters={"0803": 0}, reply_time_ns=12 * NS_PER_MS
    )
    setup = PlantSetup(engine="reference", sources=five_sources, drives={"drive1": conditions})
    installation = plant(FIVE, setup)
    drive = installation.drives["drive1"]
    assert drive.read_word("0803") == 0
    assert drive.load == Load(50.0)


def test_gateways_and_the_cpu_are_off_until_the_start(five_sources):
    installation = plant(FIVE, PlantSetup(engine="reference", sources=five_sources))
    assert not installation.gateways["gw1"].powered
    assert installation.cpu.mode is CpuMode.STOP
    installation.start()
    installation.run_for(20 * NS_PER_MS)
    assert installation.gateways["gw1"].slave.online
    assert installation.cpu.mode is CpuMode.RUN


def test_the_generated_text_knows_where_its_lines_are_from(five_sources):
    assert any(source.origins for source in five_sources)


def test_with_the_cpu_in_stop_the_drives_keep_running():
    installation = plant(MANUAL, PlantSetup(engine="reference"))
    installation.start()
    installation.run_for(50 * NS_PER_MS)
    drive = installation.drives["drive11"]
    installation.cpu.engine.set_global("TOS_Plant.gw1.drive11.manual_example.execute", True)
    while not drive.running:
        installation.run_for(10 * NS_PER_MS)
    installation.cpu.stop()
    installation.run_for(20 * NS_PER_S)
    assert (drive.running, drive.tripped) == (True, False)


def test_conditions_for_an_unknown_drive_are_refused(five_sources):
    setup = PlantSetup(sources=five_sources, drives={"drive9": DriveConditions()})
    with pytest.raises(DiagnosticError) as caught:
        plant(FIVE, setup)
    (found,) = caught.value.diagnostics
    assert found.code == "FB7501"
    assert "drive" in found.help


def test_a_gateway_that_cannot_be_simulated_is_refused(five_sources):
    catalog = load_catalog()
    known = load_plant(FIVE, catalog)
    entry = known.gateways[0].model_copy(update={"type": "other"})
    strange = known.model_copy(update={"gateways": (entry,)})
    lent = catalog.gateway("tospbdp001")
    extended = type(catalog)(
        catalog.drives, {**catalog.gateways, "other": lent}, catalog.protocols, catalog.sequences
    )
    with pytest.raises(DiagnosticError) as caught:
        build_plant(strange, extended, PlantSetup(sources=five_sources))
    assert caught.value.diagnostics[0].code == "FB7502"
