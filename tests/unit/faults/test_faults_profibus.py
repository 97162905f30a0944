"""What faults of PROFIBUS and of a gateway do, as gateway and line show it."""

import pytest

from fbgen.plant import Plant
from harness.fieldbus import MasterMode
from harness.fieldbus.station import StationState
from harness.gateways.tospbdp001 import Light
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import Transmission
from harness.plc import CpuMode
from tests.unit.faults.fault_plant import all_is_well, fault, five_drives, polled, started


@pytest.fixture(scope="module")
def plan() -> Plant:
    return five_drives()


@pytest.fixture
def plant(plan: Plant) -> Installation:
    return started(plan)


@pytest.fixture
def heard(plant: Installation) -> list[Transmission]:
    """What the gateway sends to the drives."""
    sent: list[Transmission] = []
    port = plant.gateways["gw1"].port
    plant.lines["gw1"].taps.append(lambda item: sent.append(item) if item.sender is port else None)
    return sent


@pytest.mark.parametrize("name", ["profibus_interrupted", "master_stopped", "profibus_plug_pulled"])
def test_without_polls_the_gateway_goes_offline_and_silent(
    plant: Installation, heard: list[Transmission], name: str
) -> None:
    fault(plant, name).inject()
    plant.run_for(200 * NS_PER_MS)
    gateway = plant.gateways["gw1"]
    heard.clear()
    plant.run_for(2 * NS_PER_S)
    assert not gateway.slave.online
    assert gateway.leds.fieldbus_offline is Light.RED
    assert plant.stations["gw1"].failed
    assert heard == []


def test_a_stopped_master_says_so_while_the_cpu_goes_on(plant: Installation) -> None:
    made = fault(plant, "master_stopped")
    made.inject()
    plant.run_for(NS_PER_S)
    assert plant.master.mode is MasterMode.STOP
    assert plant.cpu.mode is CpuMode.RUN
    made.clear()
    plant.run_for(20 * NS_PER_MS)
    assert plant.master.mode is MasterMode.OPERATE
    assert plant.stations["gw1"].exchanging


def test_a_cpu_that_starts_beside_a_stopped_master_goes_to_run_without_stations(
    plant: Installation,
) -> None:
    fault(plant, "master_stopped").inject()
    stop = fault(plant, "cpu_unpowered")
    stop.inject()
    plant.run_for(100 * NS_PER_MS)
    stop.clear()
    plant.run_for(100 * NS_PER_MS)
    assert plant.cpu.mode is CpuMode.RUN
    assert plant.stations["gw1"].failed


def test_a_watchdog_that_expires_is_followed_by_a_new_start_of_the_exchange(
    plant: Installation,
) -> None:
    station, slave = plant.stations["gw1"], plant.gateways["gw1"].slave
    fault(plant, "profibus_watchdog_expired").inject()
    assert not slave.online
    assert not any(slave.outputs)
    plant.run_for(20 * NS_PER_MS)
    assert slave.online
    assert station.exchanging


@pytest.mark.parametrize(
    ("refuses", "light"), [("configuration", "cfg_fault"), ("ident_number", "prm_fault")]
)
def test_a_gateway_that_refuses_exchanges_no_data_until_the_right_one_is_there(
    plant: Installation, refuses: str, light: str
) -> None:
    made = fault(plant, "profibus_wrong_configuration", {"refuses": refuses})
    made.inject()
    plant.run_for(100 * NS_PER_MS)
    slave = plant.gateways["gw1"].slave
    assert plant.stations["gw1"].state is StationState.REFUSED
    assert getattr(slave, light)
    assert not slave.online
    made.clear()
    plant.run_for(100 * NS_PER_MS)
    assert slave.online


def test_in_clear_the_gateway_gets_zeros_while_the_cpu_runs(plant: Installation) -> None:
    fault(plant, "profibus_clear").inject()
    plant.run_for(20 * NS_PER_MS)
    assert not any(plant.gateways["gw1"].slave.outputs)
    assert plant.cpu.mode is CpuMode.RUN


def test_with_the_cpu_in_stop_the_gateway_gets_zeros(plant: Installation) -> None:
    fault(plant, "cpu_stopped").inject()
    plant.run_for(20 * NS_PER_MS)
    assert not any(plant.gateways["gw1"].slave.outputs)


def test_with_sync_held_the_outputs_stay_and_with_freeze_held_the_inputs(
    plant: Installation, heard: list[Transmission]
) -> None:
    slave = plant.gateways["gw1"].slave
    sync = fault(plant, "profibus_sync_held")
    sync.inject()
    outputs = slave.outputs
    plant.run_for(50 * NS_PER_MS)
    heard.clear()
    plant.run_for(NS_PER_S)
    assert slave.outputs == outputs
    assert not [item for item in heard if item.data[0] == 0x2F], "no trigger gets through"
    sync.clear()
    fault(plant, "profibus_freeze_held").inject()
    inputs = slave.inputs
    plant.run_for(NS_PER_S)
    assert slave.outputs != outputs
    assert slave.inputs == inputs


def test_the_bus_jitters_by_up_to_so_much(plan: Plant) -> None:
    plant = started(plan)
    fault(plant, "profibus_jitter", {"up_to": "1 ms"}).inject()
    late: list[int] = []
    plant.master.taps.append(lambda transfer: late.append(transfer.time_ns % (2 * NS_PER_MS)))
    plant.run_for(2 * NS_PER_S)
    assert len(set(late)) > 20
    assert max(late) <= NS_PER_MS
    assert max(late) > NS_PER_MS // 2


# --- the gateway ------------------------------------------------------------------------------


def test_a_gateway_that_does_not_see_the_trigger_sends_only_its_heartbeat(
    plant: Installation, heard: list[Transmission]
) -> None:
    made = fault(plant, "gateway_trigger_stuck")
    made.inject()
    plant.run_for(50 * NS_PER_MS)
    heard.clear()
    plant.run_for(2 * NS_PER_S)
    assert {item.data[0] for item in heard} == {0x28}
    assert polled(plant, "drive3", "lost") is True
    made.clear()
    plant.run_for(3 * NS_PER_S)
    assert all_is_well(plant)


def test_a_slow_gateway_takes_its_time_in_both_directions(plant: Installation) -> None:
    recorder = plant.record_telegrams()["gw1"]
    fault(plant, "gateway_slow", {"processing_time": "15 ms"}).inject()
    plant.run_for(NS_PER_S)
    taken = [item.frames[0].start_ns - item.sent_ns for item in recorder.records[2:-1]]
    assert min(taken) >= 15 * NS_PER_MS


def test_zeros_go_out_for_a_telegram_that_was_overwritten(
    plant: Installation, heard: list[Transmission]
) -> None:
    gateway = plant.gateways["gw1"]
    made = fault(plant, "gateway_buffer_overwritten", {"probability": 1.0})
    plant.run_for(50 * NS_PER_MS)
    made.inject()
    heard.clear()
    plant.run_for(NS_PER_S)
    telegrams = [item.data for item in heard if item.data[0] == 0x2F]
    assert set(telegrams[1:]) == {bytes.fromhex("2F 00 00 00 00 00 00 2F")}
    assert gateway.overwritten >= len(telegrams) - 1 > 5
