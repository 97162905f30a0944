"""What faults of the CPU do: its scans, its restarts and what it remembers."""

from itertools import pairwise

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import Plant
from fbgen.source import Source
from harness.fieldbus import MasterMode
from harness.installation import Installation, PlantSetup, build_plant, generated_sources
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc import CpuMode
from tests.unit.faults.fault_plant import all_is_well, fault, five_drives, started

RECIPE = """
DATA_BLOCK "Recipe"
{ S7_Optimized_Access := 'TRUE' }
VAR RETAIN
   count : Int := 7;
END_VAR
BEGIN
END_DATA_BLOCK
"""


@pytest.fixture(scope="module")
def plan() -> Plant:
    return five_drives()


@pytest.fixture
def plant(plan: Plant) -> Installation:
    return started(plan)


def scan_times(plant: Installation, duration_ns: int) -> list[int]:
    """Times between the ends of the programs of two scans."""
    instants: list[int] = []
    plant.cpu.after_scan.append(lambda: instants.append(plant.kernel.now_ns))
    plant.run_for(duration_ns)
    plant.cpu.after_scan.pop()
    return [b - a for a, b in pairwise(instants)]


def test_an_overrun_makes_the_scans_longer_than_the_cycle(plant: Installation) -> None:
    made = fault(plant, "cpu_overrun", {"execution_time": "60 ms"})
    made.inject()
    longer = scan_times(plant, NS_PER_S)[1:]
    assert {round(time / NS_PER_MS) for time in longer} == {60}
    made.clear()
    plant.run_for(200 * NS_PER_MS)
    assert {round(time / NS_PER_MS) for time in scan_times(plant, NS_PER_S)} == {10}
    assert plant.cpu.mode is CpuMode.RUN


def test_an_overrun_beyond_the_cycle_monitoring_time_stops_the_cpu(plant: Installation) -> None:
    fault(plant, "cpu_overrun", {"execution_time": "200 ms"}).inject()
    plant.run_for(NS_PER_S)
    assert [item.code for item in plant.cpu.diagnostics] == ["FB7409"]


def test_jitter_makes_scans_that_are_longer_than_the_cycle_differ(plant: Installation) -> None:
    fault(plant, "cpu_jitter", {"up_to": "30 ms"}).inject()
    times = scan_times(plant, 2 * NS_PER_S)
    assert len(set(times)) > 10
    assert max(times) <= 40 * NS_PER_MS


@pytest.mark.parametrize(
    ("name", "settings", "kept"),
    [
        ("cpu_stopped", {"restart": "warm"}, True),
        ("cpu_stopped", {"restart": "cold"}, False),
        ("cpu_unpowered", {}, True),
        ("cpu_retentive_lost", {}, False),
    ],
)
def test_a_restart_keeps_what_is_retentive_or_loses_it(
    plan: Plant, name: str, settings: dict[str, float | str], kept: bool
) -> None:
    catalog = load_catalog()
    sources = [*generated_sources(plan, catalog), Source("Recipe.db", RECIPE)]
    plant = build_plant(plan, catalog, PlantSetup(sources=sources))
    plant.start()
    plant.run_for(NS_PER_S)
    engine = plant.cpu.engine
    engine.set_global("Recipe.count", 12)
    made = fault(plant, name, settings)
    made.inject()
    plant.run_for(500 * NS_PER_MS)
    made.clear()
    plant.run_for(NS_PER_S)
    assert plant.cpu.mode is CpuMode.RUN
    assert engine.global_value("Recipe.count") == (12 if kept else 7)
    plant.run_for(5 * NS_PER_S)
    assert all_is_well(plant)


def test_without_supply_the_master_is_silent_and_a_stop_alone_sends_zeros(
    plant: Installation,
) -> None:
    supply, stop = fault(plant, "cpu_unpowered"), fault(plant, "cpu_stopped")
    supply.inject()
    assert plant.master.mode is MasterMode.STOP
    stop.inject()
    supply.clear()
    assert plant.cpu.mode is CpuMode.STOP
    assert plant.master.mode is MasterMode.CLEAR
    stop.clear()
    plant.run_for(100 * NS_PER_MS)
    assert plant.cpu.mode is CpuMode.RUN


def test_a_stop_in_the_middle_of_a_scan_waits_for_its_end(plant: Installation) -> None:
    modes: list[CpuMode] = []
    made = fault(plant, "cpu_stopped")

    def in_a_scan() -> None:
        made.inject()
        modes.append(plant.cpu.mode)

    begin_ns = (plant.kernel.now_ns // (10 * NS_PER_MS) + 1) * 10 * NS_PER_MS
    for step in range(40):
        plant.kernel.at(begin_ns + step * 1_000, lambda: None)
    plant.kernel.at(begin_ns + 5_000, in_a_scan)
    plant.run_for(20 * NS_PER_MS)
    assert modes == [CpuMode.RUN]
    assert plant.cpu.mode is CpuMode.STOP
