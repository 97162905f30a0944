"""Faults of a DeviceNet plant: what each does to scanner, option and drive; all pairs of them."""

from collections.abc import Mapping
from itertools import combinations_with_replacement
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import Plant, load_plant
from harness.faults import FAULTS, Fault, Target
from harness.faults.settings import fault_settings
from harness.fieldbus.devicenet import SlaveState
from harness.installation import DriveConditions, Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.scenario.fault_plans import possible_places
from tests.unit.faults.fault_plant import drive_state
from tests.unit.faults.pairs import end_independently, one_behind_the_other

EXAMPLE = Path(__file__).parents[3] / "examples" / "devicenet"
CATALOG = load_catalog()
ELSEWHERE = (Target.GATEWAY, Target.TELEGRAMS, Target.LINE, Target.MODULE)
OF_TELEGRAMS = ("drive_answers", "drive_number", "drive_slow")
HERE = sorted(
    name
    for name, kind in FAULTS.items()
    if kind.target not in ELSEWHERE and not name.startswith(OF_TELEGRAMS)
)
"""The faults that a plant with nothing but DeviceNet can have."""
STRONGER: dict[str, Mapping[str, float | str]] = {
    "cpu_jitter": {"up_to": "8 ms"},
    "cpu_overrun": {"execution_time": "80 ms"},
    "devicenet_wrong_assembly": {"assemblies": "102/152"},
    "profibus_jitter": {"up_to": "1900 us"},
    "transfers_torn": {"probability": 0.5},
}
"""Settings for the second one of two equal faults."""


@pytest.fixture(scope="module")
def plan() -> Plant:
    return load_plant(EXAMPLE / "plant.yaml", CATALOG)


def started(plan: Plant) -> Installation:
    """Three seconds after the start: the scanner exchanges data with both drives."""
    plant = build_plant(plan, CATALOG, PlantSetup(sources=[EXAMPLE / "conveyors.scl"]))
    plant.start()
    plant.run_for(3 * NS_PER_S)
    assert all_is_well(plant)
    return plant


def all_is_well(plant: Installation) -> bool:
    return all(slave.exchanging for slave in plant.networks["net1"].scanner.slaves.values())


def fault(
    plant: Installation, name: str, settings: Mapping[str, float | str] | None = None
) -> Fault:
    kind = FAULTS[name]
    on = {Target.WHOLE: "", Target.NETWORK: "net1"}.get(kind.target, "infeed")
    return kind.make(plant, on, fault_settings(kind, settings or {}, {}))


def two(plant: Installation, names: tuple[str, str]) -> tuple[Fault, Fault]:
    settings = STRONGER.get(names[1], {}) if names[0] == names[1] else {}
    return fault(plant, names[0]), fault(plant, names[1], settings)


def held(plant: Installation) -> dict[str, object]:
    """What faults hold; whether an option has come back is not among it."""
    network = plant.networks["net1"]
    return {
        "cpu": plant.cpu.mode,
        "scans": (plant.cpu.settings.execution_ns, plant.cpu.settings.execution_jitter_ns),
        "torn": plant.cpu.link.tear_probability,
        "bus": (plant.master.mode, plant.master.connected, plant.master.jitter_ns),
        "scanner": network.scanner.mode,
        "plugged": (network.trunk.plugged, *(drop.plugged for drop in network.drops.values())),
        "settings": [option.own["assembly_instances"] for option in plant.options.values()],
        **{name: drive_state(drive) for name, drive in plant.drives.items()},
    }


def test_these_are_all_that_the_plant_can_have(plan: Plant) -> None:
    places = possible_places(started(plan))
    assert sorted(name for name, found in places.items() if found) == HERE


@pytest.mark.parametrize("first", HERE)
def test_two_faults_end_independently_of_each_other(plan: Plant, first: str) -> None:
    plant = started(plan)
    for second in [name for name in HERE if name >= first]:
        end_independently(plant, two(plant, (first, second)), held)


@pytest.mark.slow
@pytest.mark.parametrize("names", list(combinations_with_replacement(HERE, 2)))
def test_after_two_faults_the_plant_works_again(plan: Plant, names: tuple[str, str]) -> None:
    plant = started(plan)
    one_behind_the_other(plant, two(plant, names), 8 * NS_PER_S)
    assert all_is_well(plant)
    assert not plant.cpu.diagnostics


def running(plan: Plant) -> Installation:
    plant = started(plan)
    plant.cpu.engine.set_global("Conveyors.hz", 20.0)
    plant.cpu.engine.set_global("Conveyors.run", True)
    plant.run_for(1 * NS_PER_S)
    assert plant.drives["infeed"].running
    return plant


def test_an_idle_scanner_goes_on_taking_inputs_and_commands_nothing(plan: Plant) -> None:
    plant = running(plan)
    idle = fault(plant, "devicenet_scanner_idle")
    idle.inject()
    plant.cpu.engine.set_global("Conveyors.run", False)
    plant.run_for(2 * NS_PER_S)
    assert plant.drives["infeed"].told_to_run
    assert plant.cpu.engine.global_value("Conveyors.infeed_runs") is True
    assert plant.options["infeed"].lights[1].state == "connected"
    idle.clear()
    plant.run_for(50 * NS_PER_MS)
    assert not plant.drives["infeed"].told_to_run


def test_a_scanner_that_is_held_idle_is_so_behind_a_stop_of_the_cpu(plan: Plant) -> None:
    plant = started(plan)
    scanner = plant.networks["net1"].scanner
    idle, stopped = fault(plant, "devicenet_scanner_idle"), fault(plant, "cpu_stopped")
    for made in (idle, stopped):
        made.inject()
    idle.clear()
    assert scanner.mode == "IDLE", "the CPU is in STOP"
    stopped.clear()
    plant.run_for(100 * NS_PER_MS)
    assert scanner.mode == "RUN"


def test_an_option_whose_mac_id_is_taken_stays_off_the_network(plan: Plant) -> None:
    plant = running(plan)
    doubled = fault(plant, "devicenet_mac_doubled")
    doubled.inject()
    plant.run_for(4 * NS_PER_S)
    assert [light.state for light in plant.options["infeed"].lights] == [
        *("operational", "link_failure")
    ]
    assert plant.networks["net1"].scanner.slaves[5].state is not SlaveState.RUNNING
    doubled.clear()
    plant.run_for(5 * NS_PER_S)
    assert all_is_well(plant)
    assert plant.drives["outfeed"].running, "the other drive has noticed nothing"


def test_an_option_stays_off_until_the_last_cause_is_gone(plan: Plant) -> None:
    plant = started(plan)
    doubled, off = fault(plant, "devicenet_mac_doubled"), fault(plant, "devicenet_bus_off")
    doubled.inject()
    plant.run_for(NS_PER_S)
    off.inject()
    doubled.clear()
    plant.run_for(5 * NS_PER_S)
    assert plant.options["infeed"].lights[1].state == "link_failure"
    off.clear()
    plant.run_for(5 * NS_PER_S)
    assert all_is_well(plant)


@pytest.mark.parametrize("assemblies", ["101/151", "102/152", "105/155"])
def test_data_of_another_size_are_not_taken_at_either_end(plan: Plant, assemblies: str) -> None:
    plant = running(plan)
    wrong = fault(plant, "devicenet_wrong_assembly", {"assemblies": assemblies})
    wrong.inject()
    plant.run_for(6 * NS_PER_S)
    option = plant.options["infeed"]
    assert option.assemblies.outputs(option.assemblies.chosen) == bytes(
        option.assemblies.chosen.output.length
    )
    assert plant.cpu.engine.global_value("Conveyors.infeed_there") is False
    wrong.clear()
    plant.run_for(5 * NS_PER_S)
    assert all_is_well(plant)


def test_assemblies_that_there_are_not_are_refused(plan: Plant) -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault(started(plan), "devicenet_wrong_assembly", {"assemblies": "101/150"})
    (found,) = failure.value.diagnostics
    assert (found.code, found.help) == (
        "FB7523",
        "did you mean '101/151' or '100/150' or '105/155'?",
    )


@pytest.mark.parametrize("name", ["drive_answers_for_another", "drive_number_doubled"])
def test_a_fault_of_inverter_numbers_is_none_of_devicenet(plan: Plant, name: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault(started(plan), name)
    (found,) = failure.value.diagnostics
    assert found.code == "FB7522"
    assert found.message == "'infeed' is on DeviceNet, where drives have no inverter numbers"
    assert "devicenet_mac_doubled" in (found.help or "")


@pytest.mark.parametrize(
    ("conditions", "words"),
    [
        (DriveConditions(port="two_wire"), "no port is at a line"),
        (DriveConditions(reply_time_ns=1), "it answers no telegrams"),
    ],
)
def test_conditions_without_effect_are_refused(
    plan: Plant, conditions: DriveConditions, words: str
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        build_plant(plan, CATALOG, PlantSetup(drives={"infeed": conditions}))
    (found,) = failure.value.diagnostics
    assert found.code == "FB7503"
    assert words in found.message


def test_the_port_of_a_drive_on_a_serial_line_follows_from_its_wires() -> None:
    serial = load_plant(EXAMPLE.parent / "serial" / "plant.yaml", CATALOG)
    with pytest.raises(DiagnosticError) as failure:
        build_plant(serial, CATALOG, PlantSetup(drives={"fan": DriveConditions(port="common")}))
    (found,) = failure.value.diagnostics
    assert found.code == "FB7503"
    assert "'line1', whose wires say which port" in found.message
