"""Each fault does to a plant what its name says, at its place only, and ends when it is cleared."""

from collections.abc import Mapping

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import Plant, load_plant
from harness.faults import FAULTS, Fault, Target
from harness.faults.settings import fault_settings
from harness.fieldbus import MasterMode
from harness.gateways.tospbdp001 import Light
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc import CpuMode
from tests.unit.scenario.scenario_files import ROOT

FIVE = ROOT / "examples" / "five_drives" / "plant.yaml"


@pytest.fixture(scope="module")
def plan() -> Plant:
    return load_plant(FIVE, load_catalog())


@pytest.fixture
def plant(plan: Plant) -> Installation:
    """Five drives behind gw1, all polled, one second after the start."""
    installation = build_plant(plan, load_catalog(), PlantSetup(seed=1))
    installation.start()
    installation.run_for(NS_PER_S)
    return installation


def fault(
    plant: Installation, name: str, on: str = "", settings: Mapping[str, float | str] | None = None
) -> Fault:
    """A fault as a scenario makes it."""
    kind = FAULTS[name]
    return kind.make(plant, on, fault_settings(kind, settings or {}, {}))


def snapshot(plant: Installation) -> dict[str, object]:
    """What faults may change, by what it belongs to."""
    gateway = plant.gateways["gw1"]
    return {
        "cpu": plant.cpu.mode,
        "bus": plant.master.mode,
        "connected": plant.master.connected,
        "gateway": gateway.powered,
        "diagnosis": gateway.slave.ext_diag,
        "torn": plant.cpu.link.armed,
        "line": (
            plant.lines["gw1"].master_pair.broken,
            plant.lines["gw1"].slave_pair.broken,
            plant.lines["gw1"].master_pair.interference.bit_errors.probability,
            plant.lines["gw1"].slave_pair.interference.bit_errors.probability,
        ),
        "local": {name for name, drive in plant.drives.items() if drive.operation.local},
        **{name: (drive.powered, drive.trip_display) for name, drive in plant.drives.items()},
    }


CASES: list[tuple[str, str, dict[str, object]]] = [
    ("cpu_stopped", "", {"cpu": CpuMode.STOP, "bus": MasterMode.CLEAR}),
    ("drive_local", "drive3", {"local": {"drive3"}}),
    ("drive_tripped", "drive3", {"drive3": (True, "OC1")}),
    ("drive_unpowered", "drive3", {"drive3": (False, "")}),
    ("gateway_diagnosis", "gw1", {"diagnosis": True}),
    ("gateway_unpowered", "gw1", {"gateway": False}),
    ("line_broken", "gw1", {"line": (True, True, 0.0, 0.0)}),
    ("line_noise", "gw1", {"line": (False, False, 0.01, 0.01)}),
    ("profibus_interrupted", "", {"connected": False}),
    ("transfers_torn", "", {"torn": True}),
]


@pytest.mark.parametrize(("name", "on", "changed"), CASES)
def test_a_fault_changes_its_own_place_and_nothing_else(
    plant: Installation, name: str, on: str, changed: dict[str, object]
) -> None:
    before = snapshot(plant)
    made = fault(plant, name, on)
    assert snapshot(plant) == before, "making it does nothing"
    made.inject()
    assert snapshot(plant) == before | changed
    assert before | changed != before


@pytest.mark.parametrize(("name", "on"), [case[:2] for case in CASES if case[0] != "drive_tripped"])
def test_a_cleared_fault_leaves_a_plant_that_works_again(
    plant: Installation, name: str, on: str
) -> None:
    before = snapshot(plant)
    made = fault(plant, name, on)
    made.inject()
    plant.run_for(3 * NS_PER_S)
    made.clear()
    plant.run_for(4 * NS_PER_S)
    after = snapshot(plant)
    assert {key: after[key] for key in ("cpu", "bus", "connected", "gateway", "line", "torn")} == {
        key: before[key] for key in ("cpu", "bus", "connected", "gateway", "line", "torn")
    }
    for drive in plant.drives:
        path = f"TOS_Plant.gw1.{drive}.polled"
        assert plant.cpu.engine.global_value(f"{path}.valid") is True
        assert plant.cpu.engine.global_value(f"{path}.lost") is False


def test_a_trip_stays_when_its_cause_is_gone_until_it_is_reset(plant: Installation) -> None:
    drive = plant.drives["drive3"]
    made = fault(plant, "drive_tripped", "drive3", {"display": "OL2"})
    made.inject()
    made.clear()
    plant.run_for(100 * NS_PER_MS)
    assert drive.trip_display == "OL2"
    drive.reset()
    assert not drive.tripped


def test_with_the_cpu_in_stop_the_gateway_gets_zeros(plant: Installation) -> None:
    fault(plant, "cpu_stopped").inject()
    plant.run_for(20 * NS_PER_MS)
    assert not any(plant.gateways["gw1"].slave.outputs)


@pytest.mark.parametrize(("data", "found"), [("initial", 0.0), ("kept", 20.0)])
def test_the_cpu_finds_its_initial_data_after_stop_or_those_it_had(
    plant: Installation, data: str, found: float
) -> None:
    path = "TOS_Plant.gw1.drive3.control.frequency"
    plant.cpu.engine.set_global(path, 20.0)
    made = fault(plant, "cpu_stopped", settings={"data": data})
    made.inject()
    plant.run_for(NS_PER_S)
    made.clear()
    plant.run_for(NS_PER_S)
    assert plant.cpu.mode is CpuMode.RUN
    assert plant.cpu.engine.global_value(path) == found


def test_with_profibus_interrupted_the_gateway_goes_offline_and_silent(
    plant: Installation,
) -> None:
    fault(plant, "profibus_interrupted").inject()
    plant.run_for(200 * NS_PER_MS)
    gateway = plant.gateways["gw1"]
    heard: list[int] = []
    plant.lines["gw1"].taps.append(lambda sent: heard.append(sent.start_ns))
    plant.run_for(2 * NS_PER_S)
    assert not gateway.slave.online
    assert gateway.leds.fieldbus_offline is Light.RED
    assert heard == []


@pytest.mark.parametrize("name", ["line_broken", "gateway_unpowered"])
def test_without_line_or_gateway_no_drive_hears_anything(plant: Installation, name: str) -> None:
    made = fault(plant, name, "gw1")
    made.inject()
    plant.run_for(1500 * NS_PER_MS)
    assert {drive.trip_display for drive in plant.drives.values()} == {"Err5"}


def test_noise_makes_the_gateway_count_faulty_telegrams(plant: Installation) -> None:
    made = fault(plant, "line_noise", "gw1", {"bit_error_rate": 0.01})
    made.inject()
    codes: set[int] = set()
    for _ in range(200):
        plant.run_for(10 * NS_PER_MS)
        codes.add(plant.gateways["gw1"].status.code)
    assert codes - {0x1F}, "no error in two seconds, until a valid telegram comes again"


def test_every_fault_is_tried_and_named_as_in_scenarios() -> None:
    assert {case[0] for case in CASES} == set(FAULTS)
    for name, kind in FAULTS.items():
        assert kind.name == name
        assert kind.title


def test_places_are_those_of_the_plant(plant: Installation) -> None:
    assert set(Target.GATEWAY.places(plant)) == {"gw1"}
    assert set(Target.DRIVE.places(plant)) == {f"drive{number}" for number in range(5)}
    assert not Target.WHOLE.places(plant)


@pytest.mark.parametrize(
    ("name", "settings", "message"),
    [
        ("line_noise", {"bit_error_rate": 0.0}, "is never 0.0"),
        ("line_noise", {"bit_error_rate": "much"}, "is never 'much'"),
        ("line_noise", {"probability": 0.5}, "has no setting 'probability'"),
        ("drive_tripped", {"display": ""}, "is never ''"),
        ("cpu_stopped", {"display": "OC1"}, "has no setting 'display'"),
        ("cpu_stopped", {"data": "lost"}, "is never 'lost'"),
    ],
)
def test_wrong_settings_are_refused(
    name: str, settings: dict[str, float | str], message: str
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault_settings(FAULTS[name], settings, {})
    (found,) = failure.value.diagnostics
    assert found.code == "FB8004"
    assert message in found.message
    assert found.help


def test_all_wrong_settings_are_told_together() -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault_settings(FAULTS["line_noise"], {"bit_error_rate": 5, "x": 1}, {})
    assert len(failure.value.diagnostics) == 2


def test_a_trip_that_the_series_does_not_have_is_refused_when_the_fault_is_made(
    plant: Installation,
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault(plant, "drive_tripped", "drive3", {"display": "OC77"})
    assert [item.code for item in failure.value.diagnostics] == ["FB7102"]
