"""The run/stop event matrix against the manual's, all edges; the state diagram, all of it."""

from itertools import product

import pytest

from fbgen.wire.devicenet import Choice, Service
from fbgen.wire.devicenet_messages import Request, Response
from harness.drives import Panel
from harness.gateways.dev003z import Event, RunType, State, Trigger, next_state, run_stop
from tests.unit.devicenet.bench import C203, bench, words
from tests.vectors.reading import entries

ENTRIES = entries("dev003z_words")
ROWS = ENTRIES["dev.run_stop_matrix"]["rows"]
TRIGGERS = {"Stop": Trigger.STOP, "Run": Trigger.RUN, "No Action": Trigger.NONE}
TYPES = {"Run1": RunType.RUN_1, "Run2": RunType.RUN_2, "No Action": RunType.NONE}
PAIRS = list(product((False, True), repeat=2))


def fits(printed: str, before: bool, now: bool) -> bool:
    """Whether a cell stands for this: "0 1" is an edge, the arrow between its digits is lost."""
    digits = [digit == "1" for digit in printed.split()]
    return digits == [before, now] if len(digits) == 2 else digits == [now]


@pytest.mark.fact("dev.cs")
@pytest.mark.parametrize("before", PAIRS)
@pytest.mark.parametrize("now", PAIRS)
def test_every_edge_does_what_the_matrix_says(
    before: tuple[bool, bool], now: tuple[bool, bool]
) -> None:
    """Rows with more arrows count first; where none fits, nothing has happened: no action."""
    by_arrows = sorted(ROWS, key=lambda row: -len(row["run1"] + row["run2"]))
    row = next(
        (
            row
            for row in by_arrows
            if fits(row["run1"], before[0], now[0]) and fits(row["run2"], before[1], now[1])
        ),
        {"trigger": "No Action", "run_type": "No Action"},
    )
    assert run_stop(before, now) == (TRIGGERS[row["trigger"]], TYPES[row["run_type"]])


def test_every_row_of_the_matrix_is_reached() -> None:
    reached = [
        row for row in ROWS
        if any(
            fits(row["run1"], before[0], now[0]) and fits(row["run2"], before[1], now[1])
            for before, now in product(PAIRS, PAIRS)
        )
    ]  # fmt: skip
    assert reached == ROWS


EXPECTED = {
    Event.SWITCH_ON: "10000000",
    Event.SWITCH_OFF: "00000000",
    Event.INITIALISED: "02000000",
    Event.MAIN_POWER_ON: "00300000",
    Event.MAIN_POWER_OFF: "00027770",
    Event.RUN: "00040400",
    Event.STOP: "00005000",
    Event.STOP_COMPLETE: "00000300",
    Event.RESET: "01111111",
    Event.FAULT: "07776600",
    Event.FAULT_STOP_COMPLETE: "00000070",
    Event.FAULT_RESET: "00000002",
}
"""CIP's state event matrix of the Control Supervisor: the next state from each of 0 to 7, which are
non-existent, startup, not ready, ready, enabled, stopping, fault stop and faulted. A 0 stays, but
for switch off."""


@pytest.mark.fact("dev.cs")
@pytest.mark.parametrize("event", Event)
def test_every_event_in_every_state(event: Event) -> None:
    for state in State:
        wanted = int(EXPECTED[event][state])
        if wanted == 0 and event is not Event.SWITCH_OFF:
            wanted = state
        assert next_state(state, event) is State(wanted), state


def test_states_and_events_are_those_of_the_diagram() -> None:
    """Our names of events say the same a little longer."""
    diagram = ENTRIES["dev.state_diagram"]
    ours = {"initialization": "initialisation", "fault_stop": "fault stop", "existant": "existent"}

    def plain(names: list[str]) -> set[str]:
        found = set()
        for name in names:
            name = name.lower()
            for theirs, own in ours.items():
                name = name.replace(theirs, own)
            found.add(name)
        return found

    assert plain(diagram["events"]) == {event.value for event in Event}
    states = {name.replace("-", "_").replace(" ", "_") for name in plain(diagram["states"])}
    assert states == {state.name.lower() for state in State}


def test_its_reset_stops_what_runs_until_the_next_edge_and_leaves_a_trip() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    made.keep_polling(words(0x0061, 1800), 300)
    reset = Request(Service.RESET, 0x29, 1)
    assert made.ask(reset) == Response(Service.RESET)
    answer = made.keep_polling(words(0x0061, 1800), 300)
    assert answer == words(0x0370, 0), "ready, and Run that is still there is no edge"
    made.poll(words(0x0060, 1800))
    assert made.keep_polling(words(0x0061, 1800), 300) == words(0x04F4, 1800)
    made.drive.trip("OC1")
    assert made.ask(reset) == Response(Service.RESET)
    assert made.drive.tripped
    assert made.option.state is State.FAULTED


def test_an_alarm_is_a_warning_and_no_fault() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    assert made.get(0x29, 1, 11) == b"\x00"
    made.drive.monitors.alarm = 0x0001
    assert made.get(0x29, 1, 11) == b"\x01"
    assert made.get(0x29, 1, 10) == b"\x00"
    answer = made.keep_polling(words(0x0061, 1800), 300)
    assert answer == words(0x04F6, 1800), "it runs, with the bit Warning"
    made.drive.monitors.alarm = 0
    assert made.keep_polling(words(0x0061, 1800), 20) == words(0x04F4, 1800)


def test_a_speed_below_0_becomes_0() -> None:
    made = bench(C203[21])
    made.connect()
    made.keep_polling(words(0x0061, 1800), 300)
    answer = made.keep_polling(words(0x0061, 0xFFFF), 300)
    assert answer[2:] == words(0)
    assert made.get(0x2A, 1, 8) == words(0)
    assert made.keep_polling(words(0x0061, 0x7FFF), 300)[2:] == words(
        made.drive.read_word("0011") * 3 // 10
    ), "over the maximum frequency it is that"


def test_the_states_follow_the_inverter() -> None:
    made = bench(C203[21], online=False)
    assert made.option.state is State.STARTUP
    made.run(2200)
    assert made.option.state is State.READY
    made.connect()
    made.keep_polling(words(0x0061, 1800), 50)
    assert made.option.state is State.ENABLED
    made.poll(words(0x0060, 1800))
    assert made.option.state is State.STOPPING
    made.keep_polling(words(0x0060, 1800), 300)
    assert made.option.state is State.READY
    made.keep_polling(words(0x0061, 1800), 50)
    made.drive.trip("OC1")
    assert made.option.state is State.FAULTED, "the output is off at once"
    made.drive.power_off()
    assert made.option.state is State.NON_EXISTENT
    made.drive.power_on()
    assert made.option.state is State.STARTUP


def test_a_trip_needs_a_reset_and_a_new_edge() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    made.keep_polling(words(0x0061, 1800), 300)
    made.drive.trip("OC1")
    answer = made.keep_polling(words(0x0061, 1800), 50)
    assert answer[0] & 0x15 == 0x01, "faulted, not ready, not running"
    assert answer[1] == State.FAULTED
    made.poll(words(0x0065, 1800))
    assert not made.drive.tripped
    answer = made.keep_polling(words(0x0061, 1800), 50)
    assert answer[:2] == bytes([0x70, State.READY])
    made.poll(words(0x0060, 1800))
    answer = made.keep_polling(words(0x0061, 1800), 300)
    assert answer == words(0x04F4, 1800)


def test_the_reset_bit_acts_once() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    made.drive.trip("OC1")
    made.poll(words(0x0064, 0))
    assert not made.drive.tripped
    made.drive.trip("OC1")
    made.keep_polling(words(0x0064, 0), 50)
    assert made.drive.tripped


def test_a_reset_bit_in_the_first_command_word_acts_too() -> None:
    made = bench(C203[100])
    made.connect(rate_ms=0)
    made.drive.trip("OC1")
    made.poll(words(0xA000, 0))
    assert not made.drive.tripped
    made.drive.trip("OC1")
    made.keep_polling(words(0xA000, 0), 50)
    assert made.drive.tripped, "its bit acts when it comes"
    made.poll(words(0x8000, 0))
    made.poll(words(0xA000, 0))
    assert not made.drive.tripped


@pytest.mark.parametrize(
    ("runs", "direction"),
    [
        ((1,), "forward"), ((2,), "reverse"), ((3,), None),
        ((1, 3, 2), "reverse"), ((2, 3, 1), "forward"),
    ],
)  # fmt: skip
def test_run_bits_of_instance_21_go_through_the_matrix(
    runs: tuple[int, ...], direction: str | None
) -> None:
    made = bench(C203[21])
    made.connect()
    for bits in runs:
        made.keep_polling(words(0x0060 | bits, 600), 300)
    assert made.drive.running is (direction is not None)
    assert direction is None or made.drive.direction == direction


def test_a_run_bit_counts_only_while_the_network_has_the_command() -> None:
    made = bench(C203[21])
    made.connect()
    made.keep_polling(words(0x0041, 600), 50)
    made.keep_polling(words(0x0061, 600), 50)
    assert not made.drive.running, "Run was there before Net Ctrl: that is no edge"
    made.poll(words(0x0060, 600))
    made.keep_polling(words(0x0061, 600), 50)
    assert made.drive.running


@pytest.mark.fact("dev.local")
def test_the_local_switch_takes_command_and_frequency_from_the_network() -> None:
    made = bench(C203[21])
    made.connect()
    made.keep_polling(words(0x0061, 1800), 300)
    made.drive.switch_to_local(True)
    made.drive.set_panel(Panel(run=True, frequency_hz=20.0))
    answer = made.keep_polling(words(0x0061, 1800), 300)
    assert answer == words(0x0494, 600), "at 20 Hz, neither Ctrl from Net nor Ref from Net"
    made.drive.set_panel(Panel(run=False))
    made.keep_polling(words(0x0061, 1800), 300)
    assert not made.drive.running
    made.drive.switch_to_local(False)
    assert made.keep_polling(words(0x0061, 1800), 300) == words(0x04F4, 1800)


@pytest.mark.parametrize(("cmod", "answer"), [(1, 0x0310), (4, 0x0434)])
def test_without_net_ctrl_cmod_decides(cmod: int, answer: int) -> None:
    """4 gives the option the command; as delivered the panel has it."""
    made = bench(C203[21], drive={"0003": cmod})
    made.connect(Choice.POLLED)
    found = made.keep_polling(words(0x0001, 1800), 50)
    assert int.from_bytes(found[:2], "little") & 0xFF3C == answer & 0xFF3C


def test_fmod_gives_the_option_the_frequency() -> None:
    made = bench(C203[21], drive={"0003": 4, "0004": 7})
    made.connect()
    assert made.keep_polling(words(0x0001, 1800), 300) == words(0x04F4, 1800)
