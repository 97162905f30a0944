"""The scanner and the option on one bus: they find each other, exchange data, and come back."""

from collections.abc import Mapping

import pytest

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import BodyFormat, Choice, Frame, Service
from fbgen.wire.devicenet_ids import parse_identifier
from fbgen.wire.devicenet_messages import DuplicateCheck, ErrorResponse, Request, Response
from harness.drives import Inverter, InverterSettings
from harness.fieldbus.devicenet import (
    CanBus,
    CanPort,
    ScanEntry,
    Scanner,
    SlaveState,
)
from harness.gateways.dev003z import Dev003z, Dev003zSettings
from harness.kernel import NS_PER_MS, Kernel
from harness.line import Line
from tests.unit.devicenet.bench import C203, CATALOG, FAST, GATEWAY, words


@dataclass(slots=True)
class Network:
    kernel: Kernel
    bus: CanBus
    scanner: Scanner
    options: dict[int, Dev003z]
    drives: dict[int, Inverter]
    ports: dict[int, CanPort]
    log: list[tuple[int, Frame]]

    def run(self, ms: float) -> None:
        self.kernel.run_for(round(ms * NS_PER_MS))


def network(
    slaves: Mapping[int, int], choice: Choice = Choice.POLLED, rate_ms: int = 100
) -> Network:
    """Options with MAC IDs and output instances, scanned from the beginning."""
    kernel = Kernel()
    bus = CanBus(kernel)
    log: list[tuple[int, Frame]] = []
    bus.taps.append(lambda at, frame, _: log.append((at, frame)))
    pairs = {pair.output.instance: pair for pair in GATEWAY.assemblies}
    entries = [
        ScanEntry(mac, pairs[instance].output.length, pairs[instance].input.length, choice, rate_ms)
        for mac, instance in slaves.items()
    ]

    def send(frame: Frame) -> None:
        master.send(frame)

    scanner = Scanner(kernel, send, entries)
    master = bus.attach(scanner.receive)
    made = Network(kernel, bus, scanner, {}, {}, {}, log)
    for mac, instance in slaves.items():
        drive = Inverter(
            kernel, Line(kernel), CATALOG.drive("vf-s15"), InverterSettings(parameters=FAST)
        )
        _add(made, mac, instance, drive)
    scanner.start()
    return made


def _add(made: Network, mac: int, instance: int, drive: Inverter) -> None:
    own = {"assembly_instances": C203[instance], "timeout_action": 2}
    settings = Dev003zSettings(mac=mac, parameters=own)
    ports = made.ports

    def send(frame: Frame) -> None:
        ports[mac].send(frame)

    option = Dev003z(made.kernel, GATEWAY, drive, send, settings)
    ports[mac] = made.bus.attach(option.receive)
    made.options[mac], made.drives[mac] = option, drive


ALL_WAYS = [
    Choice.POLLED,
    Choice.POLLED | Choice.CHANGE_OF_STATE,
    Choice.POLLED | Choice.CYCLIC,
    Choice.POLLED | Choice.CYCLIC | Choice.ACK_SUPPRESSION,
]


@pytest.mark.fact("dev.scanner")
@pytest.mark.parametrize("choice", ALL_WAYS)
def test_every_assembly_runs_over_every_kind_of_connection(choice: Choice) -> None:
    instances = (21, 100, 101)
    made = network(dict(enumerate(instances, start=1)), choice)
    made.run(4000)
    assert [item.state for item in made.scanner.slaves.values()] == [SlaveState.RUNNING] * 3
    slaves = made.scanner.slaves
    slaves[1].outputs = words(0x0061, 1800)
    slaves[2].outputs = words(0xC600, 3000)
    slaves[3].outputs = words(0x0062, 900, 0x0011, 0)
    made.run(1000)
    assert slaves[1].inputs == words(0x04F4, 1800)
    assert slaves[2].inputs == words(0x6600, 3000)
    assert slaves[3].inputs == words(0x04F8, 900, 0x0011, made.drives[3].read_word("0011"))


@pytest.mark.fact("dev.scanner")
@pytest.mark.parametrize("choice", [Choice.CHANGE_OF_STATE, Choice.CYCLIC])
def test_change_of_state_alone_brings_inputs(choice: Choice) -> None:
    made = network({7: 105}, choice)
    made.options[7].own.write(0xC021, 1)
    made.run(4000)
    assert made.scanner.slaves[7].inputs[6:8] == words(made.drives[7].read_word("FD01"))
    made.drives[7].trip("OC1")
    made.run(150)
    assert made.scanner.slaves[7].inputs[6:8] == words(made.drives[7].read_word("FD01"))


@pytest.mark.fact("dev.scanner")
def test_a_cable_that_is_pulled_stops_the_drive_and_plugged_again_it_is_found() -> None:
    made = network({3: 21})
    made.scanner.slaves[3].outputs = words(0x0061, 1800)
    made.run(4500)
    assert made.drives[3].running
    made.ports[3].plugged = False
    made.run(1000)
    assert not made.drives[3].running, "c101 is 2: it ramps down"
    assert made.scanner.slaves[3].state is not SlaveState.RUNNING
    made.ports[3].plugged = True
    made.scanner.slaves[3].outputs = words(0x0060, 1800)
    made.run(8000)
    assert made.scanner.slaves[3].state is SlaveState.RUNNING
    assert made.scanner.slaves[3].inputs == words(0x0370, 0)


@pytest.mark.fact("dev.scanner")
@pytest.mark.parametrize("choice", ALL_WAYS)
def test_a_drive_that_was_off_is_allocated_anew(choice: Choice) -> None:
    made = network({3: 101}, choice)
    made.run(4000)
    made.drives[3].power_off()
    made.run(3000)
    made.drives[3].power_on()
    made.run(8000)
    assert made.scanner.slaves[3].state is SlaveState.RUNNING


def test_an_idle_master_sends_no_data_and_the_drive_goes_on() -> None:
    made = network({3: 21})
    made.scanner.slaves[3].outputs = words(0x0061, 1800)
    made.run(4500)
    made.scanner.idle = True
    made.scanner.slaves[3].outputs = words(0x0060, 0)
    made.run(1000)
    assert made.drives[3].frequency_hz == 60.0
    assert made.scanner.slaves[3].inputs == words(0x04F4, 1800)


def test_explicit_requests_go_beside_the_scan_long_ones_in_fragments() -> None:
    made = network({3: 105})
    made.run(4000)
    answers: list[object] = []
    made.scanner.request(3, Request(Service.GET_ATTRIBUTE_SINGLE, 1, 1, b"\x07"), answers.append)
    made.scanner.request(3, Request(Service.GET_ATTRIBUTE_SINGLE, 2, 1, b"\x01"), answers.append)
    made.scanner.request(3, Request(Service.GET_ATTRIBUTE_SINGLE, 9, 1, b"\x01"), answers.append)
    made.run(200)
    assert answers[0] == Response(Service.GET_ATTRIBUTE_SINGLE, b"\x07DEV003Z")
    assert isinstance(answers[1], Response)
    assert len(answers[1].data) == 2 + 2 * len(GATEWAY.objects)
    assert answers[2] == ErrorResponse(0x16, 0xFF)
    with pytest.raises(ValueError, match="does not fit"):
        made.scanner.request(3, Request(Service.GET_ATTRIBUTE_SINGLE, 0x164, 1), answers.append)
    made.drives[3].power_off()
    made.scanner.request(3, Request(Service.GET_ATTRIBUTE_SINGLE, 1, 1, b"\x01"), answers.append)
    assert made.scanner.slaves[3].requester.form is BodyFormat.C8_I16


def test_two_options_with_one_mac_id_keep_each_other_off() -> None:
    made = network({3: 21})
    drive = Inverter(made.kernel, Line(made.kernel), CATALOG.drive("vf-mb1"), InverterSettings())
    first = made.options[3], made.ports[3]
    made.run(2500)
    second = CanPort(made.bus, lambda _: None)
    option = Dev003z(made.kernel, GATEWAY, drive, second.send, Dev003zSettings("vf-mb1", mac=3))
    second = made.bus.attach(option.receive)
    made.run(3000)
    assert option.lights[1].state == "link_failure"
    assert first[0].lights[1].state == "connected"


@pytest.mark.parametrize(("at_ms", "response"), [(1500, False), (1500, True), (4000, True)])
def test_a_scanner_whose_mac_id_another_has_is_silent(at_ms: int, response: bool) -> None:
    made = network({3: 21})
    other = made.bus.attach(lambda _: None)
    check = DuplicateCheck(response, 1, 2).encode()
    made.kernel.after(at_ms * NS_PER_MS, lambda: other.send(Frame(0x407, check)))
    made.run(at_ms + 5)
    assert not made.scanner.on
    heard = len(made.log)
    made.run(3000)
    assert all(frame.identifier == 0x41F for _, frame in made.log[heard:]), "the option alone"
    made.scanner.start()
    made.run(4000)
    assert made.scanner.slaves[3].state is SlaveState.RUNNING


def test_a_scanner_on_line_answers_the_check_of_another_once() -> None:
    made = network({3: 21})
    other = made.bus.attach(lambda _: None)
    made.run(4000)
    heard = len(made.log)
    other.send(Frame(0x407, DuplicateCheck(False, 1, 2).encode()))
    other.send(Frame(0x407, b"\x00"))
    made.run(100)
    answers = [frame.data[0] for _, frame in made.log[heard:] if frame.identifier == 0x407]
    assert answers == [0x00, 0x00, 0x80], "what is too short is no check"
    assert made.scanner.on


@pytest.mark.parametrize("choice", ALL_WAYS)
def test_frames_of_a_stranger_do_not_keep_a_slave_away_for_long(choice: Choice) -> None:
    """Data of another length, again while the slave is being looked for, which has no supply."""
    made = network({3: 21}, choice)
    stranger = made.bus.attach(lambda _: None)
    made.run(4000)
    assert made.scanner.slaves[3].state is SlaveState.RUNNING
    made.drives[3].power_off()
    for at in (0, 1, 6):
        made.kernel.after(at * NS_PER_MS, lambda: stranger.send(Frame(0x343, b"\x00")))
    made.run(1500)
    made.drives[3].power_on()
    made.run(5000)
    assert made.scanner.slaves[3].state is SlaveState.RUNNING
    heard = len(made.log)
    made.run(500)
    assert not any(frame.identifier == 0x41E for _, frame in made.log[heard:]), "it stays there"


def test_a_slave_that_refuses_its_rate_is_tried_again() -> None:
    made = network({3: 21})
    stranger = made.bus.attach(lambda _: None)
    refused: list[int] = []

    def refuse(_: int, frame: Frame, _sender: CanPort) -> None:
        if frame.identifier == 0x41C and frame.data[1] == 0x10 and not refused:
            refused.append(1)
            stranger.send(Frame(0x41B, bytes([frame.data[0], 0x94, 0x09, 0xFF])))

    made.bus.taps.append(refuse)
    made.run(2760)
    assert refused
    assert made.scanner.slaves[3].state is SlaveState.LOST
    made.run(2000)
    assert made.scanner.slaves[3].state is SlaveState.RUNNING


def test_a_slave_that_answers_no_poll_is_given_up_after_three() -> None:
    made = network({3: 21})
    made.run(4000)
    made.ports[3].plugged = False
    made.run(25)
    assert made.scanner.slaves[3].state is SlaveState.RUNNING
    made.run(15)
    assert made.scanner.slaves[3].state is SlaveState.LOST


def test_a_request_that_the_slave_does_not_take_any_more_has_no_answer() -> None:
    made = network({3: 21})
    made.run(4000)
    answers: list[object] = []
    for instance in (1, 0x4018):
        request = Request(Service.GET_ATTRIBUTE_SINGLE, 0x64, instance, b"\x03")
        made.scanner.request(3, request, answers.append)
    made.scanner.slaves[3].requester.form = BodyFormat.C8_I8
    made.run(100)
    assert len(answers) == 2
    assert answers[1] is None


def test_the_same_seed_gives_the_same_frames_and_all_are_devicenet() -> None:
    logs = []
    for _ in range(2):
        made = network({1: 21, 2: 105}, Choice.POLLED | Choice.CHANGE_OF_STATE)
        made.run(3000)
        logs.append([(at, str(frame)) for at, frame in made.log])
    assert logs[0] == logs[1]
    assert all(parse_identifier(frame.identifier) is not None for _, frame in made.log)


def test_frames_take_their_time_and_the_lowest_identifier_goes_first() -> None:
    kernel = Kernel()
    bus = CanBus(kernel, bit_rate=125_000)
    heard: list[tuple[int, int]] = []
    bus.attach(lambda frame: heard.append((kernel.now_ns, frame.identifier)))
    one, other = bus.attach(lambda _: None), bus.attach(lambda _: None)
    one.send(Frame(0x42F, bytes(8)))
    other.send(Frame(0x3C5, bytes(8)))
    kernel.run_for(10 * NS_PER_MS)
    assert heard == [(888_000, 0x3C5), (1_776_000, 0x42F)]
