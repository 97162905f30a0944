"""Who gets which connections: every choice in every state; release; duplicate MAC check; lamps."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.wire.devicenet import Choice, Frame, Service, Status
from fbgen.wire.devicenet_ids import Group2, group_2
from fbgen.wire.devicenet_messages import DuplicateCheck, ErrorResponse, Request, Response
from harness.fieldbus.devicenet import Network
from harness.gateways.dev003z import Dev003z, Dev003zSettings
from tests.unit.devicenet.bench import GATEWAY, MAC, Bench, bench

CHECK = group_2(Group2.DUPLICATE_MAC_CHECK, MAC)
COS = (Choice.CHANGE_OF_STATE, Choice.CYCLIC)
GOOD = {0x01, 0x03, 0x11, 0x13, 0x21, 0x23, 0x51, 0x53, 0x61, 0x63}
"""Every choice that the option takes as its first."""


def release(made: Bench, choice: int, master: int = 0) -> Response | ErrorResponse | None:
    request = Request(Service.RELEASE, 3, 1, bytes([choice]))
    made.taken()
    body = bytes([master, request.service, 3, 1]) + request.data
    made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), body)
    made.run(2)
    (frame,) = made.taken()
    assert frame.data[0] & 0x3F == master
    if frame.data[1] == 0x94:
        return ErrorResponse(frame.data[2], frame.data[3])
    return Response(frame.data[1] & 0x7F, frame.data[2:])


@pytest.fixture(scope="module")
def fresh() -> Bench:
    return bench()


@pytest.mark.fact("dn.allocate")
def test_every_first_choice_is_taken_or_refused(fresh: Bench) -> None:
    for choice in range(256):
        answer = fresh.allocate(choice)
        if choice in GOOD:
            assert answer == Response(Service.ALLOCATE, b"\x01"), hex(choice)
            assert fresh.option.node.allocation.choice == choice
            assert release(fresh, choice & 0x33) == Response(Service.RELEASE)
            continue
        assert isinstance(answer, ErrorResponse), hex(choice)
        unsupported = bool(choice & 0x0C) and answer.status == Status.RESOURCE_UNAVAILABLE
        assert unsupported or answer.status == Status.INVALID_ATTRIBUTE_VALUE, hex(choice)
        assert answer.additional == 2
        assert not fresh.option.node.connections
    assert fresh.option.node.allocation.master == 255


@pytest.mark.parametrize(
    ("choice", "status", "additional"),
    [
        (0x00, Status.INVALID_ATTRIBUTE_VALUE, 2),
        (0x31, Status.INVALID_ATTRIBUTE_VALUE, 2),
        (0x41, Status.INVALID_ATTRIBUTE_VALUE, 2),
        (0x05, Status.RESOURCE_UNAVAILABLE, 2),
        (0x09, Status.RESOURCE_UNAVAILABLE, 2),
        (0x02, Status.INVALID_ATTRIBUTE_VALUE, 2),
    ],
)
def test_a_refusal_says_why(fresh: Bench, choice: int, status: int, additional: int) -> None:
    assert fresh.allocate(choice) == ErrorResponse(status, additional)


def test_what_is_allocated_is_not_allocated_again_nor_to_another() -> None:
    made = bench()
    assert isinstance(made.allocate(3), Response)
    already = ErrorResponse(Status.ALREADY_IN_REQUESTED_STATE, 2)
    assert made.allocate(3) == made.allocate(2) == made.allocate(1) == already
    assert made.allocate(0x10, master=1) == ErrorResponse(Status.OBJECT_STATE_CONFLICT, 1)
    assert isinstance(made.allocate(0x10), Response), "the rest, for the same master"
    assert made.allocate(0x20) == already, "cyclic beside change of state"
    assert made.get(3, 1, 5) == bytes([0x13, 0])
    assert made.allocate(0x20, master=64) == ErrorResponse(Status.INVALID_ATTRIBUTE_VALUE, 2)


def test_release_is_for_the_master_and_for_what_is_there() -> None:
    made = bench()
    assert release(made, 1) == ErrorResponse(Status.ALREADY_IN_REQUESTED_STATE, 2)
    made.allocate(3)
    assert release(made, 2, master=1) == ErrorResponse(Status.PRIVILEGE_VIOLATION, 1)
    assert release(made, 0) == ErrorResponse(Status.INVALID_ATTRIBUTE_VALUE, 2)
    assert release(made, 4) == ErrorResponse(Status.INVALID_ATTRIBUTE_VALUE, 2)
    assert release(made, 6) == ErrorResponse(Status.RESOURCE_UNAVAILABLE, 2)
    assert release(made, 2) == Response(Service.RELEASE)
    assert made.get(3, 1, 5) == bytes([1, 0])
    assert release(made, 1) == Response(Service.RELEASE)
    assert made.option.node.allocation.master == 255


@pytest.mark.parametrize(
    "data", ["4B 03 01", "4B 03 01 03", "4B 03 01 03 00 00", "4C 03 01", "4C 03 01 01 00"]
)
def test_wrong_lengths_are_told(fresh: Bench, data: str) -> None:
    fresh.taken()
    fresh.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), b"\x00" + bytes.fromhex(data))
    fresh.run(2)
    (frame,) = fresh.taken()
    long = len(data.split()) > 4
    wanted = Status.TOO_MUCH_DATA if long else Status.NOT_ENOUGH_DATA
    assert frame.data[1:] == bytes([0x94, wanted, 0xFF])


@pytest.mark.parametrize("data", ["", "00", "80 00 4B 03 01", "00 CB 03 01 01"])
def test_what_is_no_request_is_not_answered_unconnected(fresh: Bench, data: str) -> None:
    fresh.taken()
    fresh.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), bytes.fromhex(data))
    fresh.run(5)
    assert fresh.taken() == []


@pytest.mark.parametrize(
    "data", ["41 4B", "41 4B 03", "41 0E 01 01 01", "41 0E", "41 4B 03 02 03 00", "41 4C 05 01 01"]
)
def test_requests_but_allocate_and_release_are_refused_unconnected(fresh: Bench, data: str) -> None:
    fresh.taken()
    fresh.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), bytes.fromhex(data))
    fresh.run(5)
    (frame,) = fresh.taken()
    assert frame == Frame(group_2(Group2.EXPLICIT_RESPONSE, MAC), bytes.fromhex("41 94 0C 03"))


@pytest.mark.parametrize("group_3", [0x600 | MAC, 0x740 | MAC, 0x780 | MAC, 0x780])
def test_the_unconnected_port_of_group_3_is_not_its(fresh: Bench, group_3: int) -> None:
    fresh.taken()
    fresh.put(group_3, bytes([MAC]) + bytes.fromhex("4B 01 3F"))
    fresh.run(5)
    assert fresh.taken() == []


def test_somebody_who_asks_in_vain_does_not_disturb_a_long_answer() -> None:
    made = bench()
    made.allocate(1)
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes.fromhex("00 0E 01 01 00 07"))
    made.run(2)
    (first,) = made.taken()
    assert made.allocate(1, master=9) == ErrorResponse(Status.OBJECT_STATE_CONFLICT, 1)
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes([0x80, 0xC0 | first.data[1], 0]))
    (second,) = made.taken()
    assert first.data[2:] + second.data[2:] == b"\x8e\x07DEV003Z"


def test_the_connected_port_allocates_and_releases_too() -> None:
    made = bench()
    made.allocate(1)
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes.fromhex("00 4B 03 01 00 02 00"))
    made.run(2)
    (frame,) = made.taken()
    assert frame.data == bytes.fromhex("00 CB 01")
    assert sorted(made.option.node.connections) == [1, 2]
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes.fromhex("00 4C 03 01 00 02"))
    made.run(2)
    assert made.taken()[0].data == bytes.fromhex("00 CC")
    assert sorted(made.option.node.connections) == [1]
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes.fromhex("00 4B 03 01 00 01 00"))
    made.run(2)
    assert made.taken()[0].data == bytes.fromhex("00 94 0B 02"), "it is there already"


@pytest.mark.parametrize(
    ("data", "answer"),
    [
        ("00 0E 01 01", "00 94 13 FF"),
        ("40 0E", "40 94 13 FF"),
        ("00 8E 01 01 00 01", None),
        ("00", None),
    ],
)
def test_connected_requests_that_are_none(data: str, answer: str | None) -> None:
    made = bench()
    made.allocate(1)
    made.put(group_2(Group2.EXPLICIT_REQUEST, MAC), bytes.fromhex(data))
    made.run(5)
    wanted = [] if answer is None else [bytes.fromhex(answer)]
    assert [frame.data for frame in made.taken()] == wanted


# Duplicate MAC check


@pytest.mark.fact("dn.duplicate")
def test_two_checks_a_second_apart_come_before_anything_else() -> None:
    made = bench(online=False)
    assert made.option.node.network is Network.SELF_TEST
    made.run(150)
    own = DuplicateCheck(response=False, vendor=GATEWAY.devicenet.vendor_id, serial=1).encode()
    assert made.taken() == [Frame(CHECK, own)]
    assert made.allocate(3) is None, "not on line yet"
    made.run(900)
    assert made.taken() == []
    made.run(100)
    assert made.taken() == [Frame(CHECK, own)]
    made.run(1000)
    assert made.taken() == []
    assert made.option.node.network is Network.ONLINE
    assert isinstance(made.allocate(3), Response)


@pytest.mark.fact("dn.duplicate")
@pytest.mark.parametrize("response", [False, True])
def test_another_node_with_this_mac_id_keeps_it_from_the_network(response: bool) -> None:
    made = bench(online=False)
    made.run(500)
    made.put(CHECK, DuplicateCheck(response, 1, 2).encode())
    made.run(5000)
    assert made.option.node.network is Network.FAULT
    assert made.option.lights[1].state == "link_failure"
    made.taken()
    made.put(CHECK, DuplicateCheck(False, 1, 2).encode())
    assert made.taken() == []


@pytest.mark.fact("dn.duplicate")
def test_on_line_it_answers_the_check_of_another() -> None:
    made = bench()
    made.put(CHECK, DuplicateCheck(False, 1, 2).encode())
    (frame,) = made.taken()
    assert frame.data[0] == 0x80
    made.put(CHECK, bytes(6))
    assert made.taken() == []
    assert made.option.node.network is Network.ONLINE
    made.put(CHECK, DuplicateCheck(True, 1, 2).encode())
    assert made.option.node.network is Network.FAULT


@pytest.mark.parametrize("comes_back", [False, True])
def test_bus_off_is_counted_and_the_interrupt_decides(comes_back: bool) -> None:
    made = bench()
    made.allocate(3)
    assert made.set(3, 1, 3, bytes([comes_back])) == 0
    made.option.node.bus_off()
    made.run(2500)
    assert made.option.node.network is (Network.ONLINE if comes_back else Network.FAULT)
    assert not made.option.node.connections
    if comes_back:
        made.allocate(1)
        assert made.get(3, 1, 4) == b"\x01"
        assert made.set(3, 1, 4, b"\x05") == 0, "whatever it is set to"
        assert made.get(3, 1, 4) == b"\x00"


# Lamps


@pytest.mark.fact("dev.led")
def test_the_lamps_say_what_the_network_does() -> None:
    made = bench(online=False)

    def lights() -> tuple[str, str]:
        return made.option.lights[0].state, made.option.lights[1].state

    assert lights() == ("self_test", "not_online")
    made.run(500)
    assert lights() == ("operational", "not_online")
    made.run(1700)
    assert lights() == ("operational", "not_connected")
    made.connect(rate_ms=50)
    assert lights() == ("operational", "connected")
    made.run(10_100)
    assert lights() == ("operational", "timed_out")
    assert isinstance(release(made, 3), Response)
    assert lights() == ("operational", "not_connected")
    made.drive.trip("OC1")
    assert lights() == ("minor_fault", "not_connected")
    made.drive.power_off()
    assert lights() == ("no_power", "not_online")
    known = {led.name: {state.name for state in led.states} for led in GATEWAY.leds}
    assert all(light.state in known[light.lamp] for light in made.option.lights)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (Dev003zSettings(mac=64), "64 is no MAC ID of a dev003z"),
        (Dev003zSettings(baud=3), "there is no rate 3"),
        (Dev003zSettings(series="vf-s11"), "does not fit into an inverter of the series 'vf-s11'"),
    ],
)
def test_what_its_switches_cannot_be_set_to_is_refused(
    settings: Dev003zSettings, message: str
) -> None:
    made = bench()
    with pytest.raises(DiagnosticError, match=message) as raised:
        Dev003z(made.kernel, GATEWAY, made.drive, made.frames.append, settings)
    assert [found.code for found in raised.value.diagnostics] == ["FB7106"]


@pytest.mark.parametrize(
    ("parameters", "message"),
    [({"timeout_action": 6}, "does not take 6 for c101"), ({"c101": 1}, "no parameter 'c101'")],
)
def test_parameters_that_it_does_not_take_are_refused(
    parameters: dict[str, int], message: str
) -> None:
    with pytest.raises(DiagnosticError, match=message) as raised:
        bench(parameters=parameters)
    assert [found.code for found in raised.value.diagnostics] == ["FB7101"]
