"""A PBDP-110 in a whole installation: what is built, recorded, and can happen to it."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import load_plant
from harness.faults import FAULTS, Target
from harness.gateways.tospbdp001 import Memory
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.scenario.paths import Paths
from harness.serial import gateways_to_serve

SCENARIOS = Path(__file__).parents[2] / "scenarios" / "pbdp110"
CATALOG = load_catalog()


@pytest.fixture
def installation() -> Installation:
    plan = load_plant(SCENARIOS / "plant.yaml", CATALOG)
    return build_plant(plan, CATALOG, PlantSetup(sources=[SCENARIOS / "words.scl"]))


def test_drives_at_an_interface_have_the_highest_speed_and_no_time_out(
    installation: Installation,
) -> None:
    drive = installation.drives["pump"]
    assert [drive.read_word(name) for name in ("0800", "0803", "0011")] == [4, 0, 6000]
    assert installation.gateways == {}
    assert set(installation.lines) == {"gw1.a", "gw1.b"}


def test_what_an_interface_does_is_recorded(installation: Installation) -> None:
    recorder = installation.record()
    installation.start()
    installation.run_for(1 * NS_PER_S)
    installation.cpu.engine.set_global("Words.a_command", 0xC400)
    installation.run_for(500 * NS_PER_MS)
    trace = recorder.finish()
    words = {change.value for change in trace.changes_of("gateway.gw1.output.a_command")}
    assert words == {0, 0xC400}
    assert trace.changes_of("gateway.gw1.input.a_status")[-1].value & 0x8400 == 0x8400
    assert trace.changes_of("gateway.gw1.led.data_exchange")[-1].value == "green"
    meanings = {frame.meaning for frame in trace.frames if frame.sender == "gw1"}
    assert any("write FA00" in text for text in meanings)
    assert {frame.sender for frame in trace.frames} == {"gw1", "pump", "fan"}


@pytest.mark.parametrize(
    "path",
    [
        *("telegrams", "diagnosis", "outputs", "inputs", "a.online", "b.tripped"),
        *("input.a_status", "output.b_action", "led.mmi", "powered"),
    ],
)
def test_scenarios_can_ask_an_interface(installation: Installation, path: str) -> None:
    Paths(installation, CATALOG).readable(f"gateway.gw1.{path}", None).get()


@pytest.mark.parametrize(
    ("path", "hint"),
    [
        ("status", "did you mean"),
        ("a.onlin", "did you mean 'online'?"),
        ("input.a_statsu", "did you mean 'a_status'"),
        ("led.drive_c", "did you mean"),
        ("a", "known:"),
    ],
)
def test_a_wrong_name_is_told_with_the_nearest(
    installation: Installation, path: str, hint: str
) -> None:
    with pytest.raises(DiagnosticError) as raised:
        Paths(installation, CATALOG).readable(f"gateway.gw1.{path}", None)
    (found,) = raised.value.diagnostics
    assert found.code == "FB8003"
    assert hint in found.help or found.help.startswith("known")


def test_faults_of_telegrams_are_none_of_an_interface(installation: Installation) -> None:
    fit = {name for name, kind in FAULTS.items() if "gw1" in kind.target.places(installation)}
    assert "gateway_unpowered" in fit
    assert not {"line_broken", "gateway_reports", "gateway_trigger_stuck"} & fit
    assert FAULTS["line_broken"].target is Target.LINE


def test_two_drives_at_an_interface_are_no_neighbours(installation: Installation) -> None:
    kind = FAULTS["drive_number_doubled"]
    with pytest.raises(DiagnosticError) as raised:
        kind.make(installation, "pump", kind.settings())
    assert raised.value.diagnostics[0].code == "FB7520"


def test_the_memory_of_a_gateway_is_for_those_with_telegrams() -> None:
    plan = load_plant(SCENARIOS / "plant.yaml", CATALOG)
    setup = PlantSetup(sources=[SCENARIOS / "words.scl"], memories={"gw1": Memory()})
    with pytest.raises(DiagnosticError) as raised:
        build_plant(plan, CATALOG, setup)
    assert raised.value.diagnostics[0].code == "FB7501"


def test_an_interface_is_served_to_a_master_of_others() -> None:
    served = gateways_to_serve(load_plant(SCENARIOS / "plant.yaml", CATALOG), CATALOG)
    served.kernel.run_for(10 * NS_PER_MS)
    assert served.devices.slave("gw1").powered
    assert "gw1 (address 3)" in served.state
