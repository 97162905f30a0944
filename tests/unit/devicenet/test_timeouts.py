"""What follows when communication is lost: actions of c101, conditions of c103, time of c100."""

import pytest

from fbgen.wire.devicenet import Choice
from fbgen.wire.devicenet_ids import Group2, group_2
from harness.fieldbus.devicenet import ConnectionState
from harness.gateways.dev003z import State
from tests.unit.devicenet.bench import C203, MAC, Bench, bench, words

RUN = words(0x0061, 1800)
OPTION_COMMANDS = {"0003": 4.0, "0004": 7.0}
SLOW = {"0010": 10.0}


def lost(action: int, **more: int) -> Bench:
    """Running forward at 60 Hz until the master falls silent and the watchdog has waited."""
    parameters = {"timeout_action": action, **more}
    made = bench(C203[21], parameters=parameters, drive={**SLOW, "0018": 15.0})
    made.connect(rate_ms=50)
    made.keep_polling(RUN, 300)
    assert made.drive.frequency_hz == 60.0
    made.run(250)
    return made


@pytest.mark.fact("dev.timeout")
def test_0_stops_and_gives_the_command_back() -> None:
    made = lost(0)
    assert not made.drive.network_command
    assert not made.drive.told_to_run
    assert made.option.state is State.STOPPING
    assert made.option.lights[1].state == "timed_out"


@pytest.mark.fact("dev.timeout")
def test_1_goes_on_as_it_was_told() -> None:
    made = lost(1)
    made.run(20_000)
    assert made.drive.frequency_hz == 60.0
    assert made.option.state is State.ENABLED


@pytest.mark.fact("dev.timeout")
def test_2_ramps_down() -> None:
    made = lost(2)
    assert made.drive.network_command
    assert made.option.state is State.STOPPING
    before = made.drive.frequency_hz
    made.run(1000)
    assert 0 < made.drive.frequency_hz < before < 60.0
    made.run(10_000)
    assert made.option.state is State.READY


@pytest.mark.fact("dev.timeout")
def test_3_coasts() -> None:
    made = lost(3)
    assert made.drive.frequency_hz == 0.0
    assert made.drive.shaft_hz > 0
    assert made.drive.read_word("FD01") & 0x0800


@pytest.mark.fact("dev.timeout")
def test_4_trips_with_err8() -> None:
    made = lost(4)
    assert made.drive.trip_display == "Err8"
    assert made.option.state is State.FAULTED


@pytest.mark.fact("dev.timeout")
@pytest.mark.parametrize(("preset", "hz"), [(1, 15.0), (0, 60.0)])
def test_5_runs_at_the_preset_speed_of_c102_if_there_is_one(preset: int, hz: float) -> None:
    made = lost(5, timeout_preset=preset)
    made.run(10_000)
    assert made.drive.frequency_hz == hz


@pytest.mark.fact("dev.timeout")
@pytest.mark.parametrize("preset", range(1, 16))
def test_every_preset_speed_can_be_chosen(preset: int) -> None:
    names = [f"preset_speed_{number}" for number in range(1, 16)]
    speeds = {name: 10.0 + number for number, name in enumerate(names, start=1)}
    parameters = {"timeout_action": 5, "timeout_preset": preset}
    made = bench(C203[21], parameters=parameters, drive=speeds)
    made.connect(rate_ms=10)
    made.keep_polling(RUN, 100)
    made.run(500)
    assert made.drive.frequency_hz == 10.0 + preset


@pytest.mark.fact("dev.timeout")
@pytest.mark.parametrize(
    ("condition", "modes", "running", "trips"),
    [
        (0, {}, True, True),
        (0, {}, False, True),
        (1, {}, True, False),
        (1, {"0003": 4.0}, True, False),
        (1, {"0004": 7.0}, True, False),
        (1, OPTION_COMMANDS, True, True),
        (1, OPTION_COMMANDS, False, True),
        (2, OPTION_COMMANDS, True, True),
        (2, OPTION_COMMANDS, False, False),
        (2, {}, True, False),
    ],
)
def test_c103_says_when_a_loss_counts(
    condition: int, modes: dict[str, float], running: bool, trips: bool
) -> None:
    parameters = {"timeout_action": 4, "timeout_condition": condition}
    made = bench(C203[21], parameters=parameters, drive=modes)
    made.connect(rate_ms=50)
    made.keep_polling(words(0x0060 | running, 1800), 300)
    made.run(250)
    assert made.drive.tripped is trips


def test_c100_waits_and_communication_that_comes_back_is_in_time() -> None:
    parameters = {"timeout_action": 4, "timeout_time": 20}
    made = bench(C203[21], parameters=parameters)
    made.connect(rate_ms=50)
    made.keep_polling(RUN, 50)
    made.run(250 + 1500)
    assert not made.drive.tripped
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes.fromhex("00 05 05 02 00"))
    made.keep_polling(RUN, 1000)
    assert not made.drive.tripped
    made.run(250 + 1950)
    assert made.drive.tripped


def test_after_a_stop_the_drive_waits_for_a_new_edge() -> None:
    made = lost(2)
    made.run(11_000)
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes.fromhex("00 05 05 02 00"))
    made.keep_polling(RUN, 200)
    assert not made.drive.running
    made.poll(words(0x0060, 1800))
    made.keep_polling(RUN, 200)
    assert made.drive.running


@pytest.mark.parametrize("way", ["release", "bus off", "duplicate"])
def test_a_connection_that_goes_otherwise_is_a_loss_too(way: str) -> None:
    made = bench(C203[21], parameters={"timeout_action": 4})
    made.connect(rate_ms=0)
    made.keep_polling(RUN, 50)
    if way == "release":
        made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), bytes.fromhex("00 4C 03 01 03"))
    elif way == "bus off":
        made.option.node.bus_off()
    else:
        made.put(group_2(Group2.DUPLICATE_MAC_CHECK, MAC), bytes.fromhex("80 01 00 02 00 00 00"))
    made.run(5)
    assert made.drive.trip_display == "Err8"


def test_without_supply_nothing_follows_later() -> None:
    made = bench(C203[21], parameters={"timeout_action": 4, "timeout_time": 20})
    made.connect(rate_ms=10)
    made.keep_polling(RUN, 50)
    made.run(100)
    made.drive.power_off()
    made.drive.power_on()
    made.run(5000)
    assert not made.drive.tripped


def test_a_tool_that_goes_away_stops_nothing_while_io_goes_on() -> None:
    made = bench(C203[21], parameters={"timeout_action": 4})
    made.connect(Choice.POLLED | Choice.CHANGE_OF_STATE, rate_ms=0)
    made.keep_polling(RUN, 50)
    assert made.set(5, 1, 9, words(10)) == 0
    assert made.set(5, 4, 9, words(10)) == 0
    made.keep_polling(RUN, 12_000)
    assert made.option.node.connections[4].state is ConnectionState.TIMED_OUT
    assert 1 not in made.option.node.connections
    assert made.drive.running


@pytest.mark.parametrize("left", [0, Choice.CHANGE_OF_STATE])
def test_polls_that_stay_away_count_whatever_else_goes_on(left: int) -> None:
    made = bench(C203[21], parameters={"timeout_action": 4})
    made.connect(Choice.POLLED | left, rate_ms=0)
    made.set(5, 2, 9, words(50))
    made.keep_polling(RUN, 50)
    made.run(250)
    assert made.drive.trip_display == "Err8"


def test_a_drive_that_explicit_messages_command_is_stopped_when_they_stay_away() -> None:
    made = bench(parameters={"timeout_action": 4})
    made.allocate(1)
    made.set(5, 1, 9, words(100))
    made.set(0x29, 1, 5, b"\x01")
    made.set(0x29, 1, 3, b"\x01")
    assert made.drive.running
    made.run(405)
    assert made.drive.trip_display == "Err8"
