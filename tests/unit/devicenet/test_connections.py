"""Expected packet rate, watchdogs, sizes, fragments, change of state and cyclic data."""

from itertools import pairwise

import pytest

from fbgen.wire.devicenet import Choice, Frame, Status
from fbgen.wire.devicenet_ids import Group2, SlaveMessage, group_2, slave_message
from harness.fieldbus.devicenet import ConnectionState
from tests.unit.devicenet.bench import C203, MAC, Bench, bench, words

POLL = group_2(Group2.POLL, MAC)
ANSWER = slave_message(SlaveMessage.POLL_RESPONSE, MAC)
COS = slave_message(SlaveMessage.COS, MAC)
ACK = group_2(Group2.COS_ACKNOWLEDGE, MAC)
REQUEST = group_2(Group2.EXPLICIT_REQUEST, MAC)


def state(made: Bench, instance: int) -> ConnectionState:
    return made.option.node.connections[instance].state


def test_io_begins_when_its_rate_is_set() -> None:
    made = bench(C203[21])
    made.allocate(3)
    assert made.get(5, 2, 1) == bytes([ConnectionState.CONFIGURING])
    assert made.poll(words(0, 0)) is None
    made.set(5, 2, 9, words(100))
    assert made.poll(words(0, 0)) is not None
    assert made.get(5, 2, 1) == bytes([ConnectionState.ESTABLISHED])


@pytest.mark.fact("dev.watchdog")
@pytest.mark.parametrize(("rate_ms", "last_ms"), [(10, 40), (100, 400), (2000, 8000)])
def test_the_watchdog_waits_four_times_the_rate(rate_ms: int, last_ms: int) -> None:
    made = bench(C203[21])
    made.connect(rate_ms=rate_ms)
    made.put(POLL, words(0, 0))
    made.run(last_ms - 1)
    assert state(made, 2) is ConnectionState.ESTABLISHED
    made.run(1)
    assert state(made, 2) is ConnectionState.TIMED_OUT
    assert made.poll(words(0, 0)) is None


@pytest.mark.fact("dev.watchdog")
def test_a_message_at_the_very_end_is_in_time() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=10)
    made.put(POLL, words(0, 0))
    made.kernel.after(40_000_000, lambda: made.put(POLL, words(0, 0)))
    made.run(79)
    assert state(made, 2) is ConnectionState.ESTABLISHED


@pytest.mark.fact("dev.watchdog")
def test_before_its_first_message_a_connection_waits_ten_seconds() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=100)
    made.run(9_990)
    assert state(made, 2) is ConnectionState.ESTABLISHED
    made.run(10)
    assert state(made, 2) is ConnectionState.TIMED_OUT


def test_rate_0_waits_for_ever() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    made.run(100_000)
    assert state(made, 2) is ConnectionState.ESTABLISHED


def test_a_timed_out_connection_is_reset_and_goes_on() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=10)
    made.put(POLL, words(0, 0))
    made.run(100)
    made.taken()
    made.put(REQUEST, bytes.fromhex("00 05 05 02 00"))
    made.run(2)
    assert made.taken()[0].data == bytes.fromhex("00 85")
    assert made.poll(words(0, 0)) is not None


def test_a_connection_that_is_being_configured_is_not_reset() -> None:
    made = bench(C203[21])
    made.allocate(3)
    made.put(REQUEST, bytes.fromhex("00 05 05 02 00"))
    made.run(2)
    assert made.taken()[0].data == bytes([0x00, 0x94, Status.OBJECT_STATE_CONFLICT, 0xFF])
    assert state(made, 2) is ConnectionState.CONFIGURING


@pytest.mark.fact("dev.watchdog")
def test_the_explicit_connection_deletes_itself() -> None:
    made = bench()
    made.allocate(1)
    assert made.get(5, 1, 9) == words(0), "it waits for ever as delivered"
    made.set(5, 1, 9, words(100))
    made.run(397)
    assert 1 in made.option.node.connections
    made.run(2)
    assert made.option.node.connections == {}
    assert made.option.node.allocation.master == 255


def test_the_watchdog_of_a_released_connection_does_not_end_the_next_one() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    made.set(5, 1, 9, words(100))
    made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), bytes.fromhex("00 4C 03 01 01"))
    made.run(5)
    made.allocate(1)
    made.run(1000)
    assert state(made, 1) is ConnectionState.ESTABLISHED


def test_deferred_delete_waits_for_the_io_connections() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    assert made.set(5, 1, 12, b"\x03") == 0
    assert made.set(5, 1, 12, b"\x00") == Status.INVALID_ATTRIBUTE_VALUE
    assert made.set(5, 2, 12, b"\x01") == Status.ATTRIBUTE_NOT_SETTABLE
    made.set(5, 1, 9, words(10))
    made.run(50)
    assert state(made, 1) is ConnectionState.DEFERRED_DELETE
    made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), bytes.fromhex("00 4C 03 01 02"))
    assert made.option.node.connections == {}


def test_a_message_in_deferred_delete_brings_the_connection_back() -> None:
    made = bench(C203[21])
    made.connect(rate_ms=0)
    made.set(5, 1, 12, b"\x03")
    made.set(5, 1, 9, words(10))
    made.run(50)
    assert state(made, 1) is ConnectionState.DEFERRED_DELETE
    assert made.get(5, 1, 1) == bytes([ConnectionState.ESTABLISHED])
    made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), bytes.fromhex("00 4C 03 01 02"))
    assert list(made.option.node.connections) == [1]
    made.run(50)
    assert made.option.node.connections == {}, "no I/O is left to wait for"


@pytest.mark.fact("dev.consumed")
def test_shorter_data_are_ignored_but_answered_longer_ones_are_not_answered() -> None:
    made = bench(C203[21])
    made.connect()
    made.poll(words(0x0060, 600))
    assert made.drive.registers.ram[0xFA07] == 2000
    for short in (b"", b"\x60", words(0x0060, 300)[:3]):
        assert made.poll(short) is not None
    assert made.poll(words(0x0060, 300) + b"\x00") is None
    assert made.drive.registers.ram[0xFA07] == 2000


@pytest.mark.fact("dev.consumed")
def test_longer_data_in_fragments_are_not_answered() -> None:
    made = bench(C203[102], parameters={"command_1": 3})
    made.connect()
    assert made.poll(words(1000, 0, 0, 0, 0, 0)) is not None
    assert made.poll(words(2000, 0, 0, 0, 0, 0, 0)) is None
    assert made.poll(words(2000, 0, 0)) is not None, "shorter, in one fragment that is the first"
    assert made.drive.registers.ram[0xFA07] == 1000


@pytest.mark.fact("dn.fragments")
@pytest.mark.parametrize(("instance", "length"), [(102, 12), (105, 18)])
def test_long_io_data_go_in_fragments_both_ways(instance: int, length: int) -> None:
    made = bench(C203[instance], parameters={"monitor_6": 1})
    made.connect()
    answer = made.poll(bytes(length))
    assert answer is not None
    assert len(answer) == length
    assert answer[-2:] == words(made.drive.read_word("FD01"))


def test_fragments_out_of_their_row_are_dropped_until_the_next_first_one() -> None:
    made = bench(C203[102], parameters={"command_1": 3})
    made.connect()
    made.put(POLL, b"\x00" + words(1000) + bytes(5))
    made.put(POLL, b"\x83" + bytes(5))
    made.run(2)
    assert made.taken() == []
    assert made.poll(words(3000, 0, 0, 0, 0, 0)) is not None
    assert made.drive.registers.ram[0xFA07] == 3000


# Change of state and cyclic


def test_change_of_state_sends_at_once_and_again_after_the_rate() -> None:
    made = bench(C203[21])
    made.connect(Choice.CHANGE_OF_STATE, rate_ms=200)
    sent: list[int] = []
    for at in range(1000):
        for frame in made.taken():
            if frame.identifier == COS:
                sent.append(at)
                made.put(ACK, b"")
        if at == 500:
            made.drive.trip("OC1")
        made.run(1)
    gaps = [later - earlier for earlier, later in pairwise(sent)]
    assert sent[0] <= 10
    assert any(490 < at < 515 for at in sent), "the trip is told at once"
    assert all(gap <= 211 for gap in gaps)
    assert len(sent) <= 7


@pytest.mark.fact("dev.ack")
def test_what_is_not_acknowledged_is_sent_once_more_after_16_ms() -> None:
    made = bench(C203[21])
    made.connect(Choice.CHANGE_OF_STATE, rate_ms=2000)
    made.frames.clear()
    made.drive.trip("OC1")
    times: list[int] = []
    for at in range(200):
        times += [at for frame in made.taken() if frame.identifier == COS]
        made.run(1)
    assert len(times) == 2
    assert times[1] - times[0] == 16
    made.run(8000 + 10_000)
    assert state(made, 4) is ConnectionState.TIMED_OUT, "no acknowledgement ever came"


def test_suppressed_acknowledgements_are_not_waited_for() -> None:
    made = bench(C203[21])
    made.connect(Choice.CYCLIC | Choice.ACK_SUPPRESSION, rate_ms=50)
    made.frames.clear()
    made.run(1000)
    assert 19 <= sum(frame.identifier == COS for frame in made.taken()) <= 21
    assert state(made, 4) is ConnectionState.ESTABLISHED
    assert made.get(5, 4, 5) == words(0xFFFF)


def test_cyclic_data_come_once_in_a_rate_whatever_changes() -> None:
    made = bench(C203[21])
    made.connect(Choice.CYCLIC, rate_ms=100)
    made.frames.clear()
    count = 0
    for at in range(1000):
        for frame in made.taken():
            if frame.identifier == COS:
                count += 1
                made.put(ACK, b"")
        if at % 30 == 0:
            made.drive.trip("OC1") if at % 60 else made.drive.reset()
        made.run(1)
    assert 9 <= count <= 11


@pytest.mark.parametrize("choice", [Choice.CYCLIC, Choice.CYCLIC | Choice.ACK_SUPPRESSION])
@pytest.mark.parametrize("rate_ms", [2, 7, 25])
def test_cyclic_data_come_just_as_often_as_the_rate_says(choice: Choice, rate_ms: int) -> None:
    made = bench(C203[21])
    made.connect(choice, rate_ms=rate_ms)
    made.run(50)
    made.frames.clear()
    times: list[int] = []
    for at in range(200):
        for frame in made.taken():
            if frame.identifier == COS:
                times.append(at)
                made.put(ACK, b"")
        made.run(1)
    assert {later - earlier for earlier, later in pairwise(times)} == {rate_ms}


def test_acknowledgements_that_nobody_waits_for_hold_nothing_up() -> None:
    made = bench(C203[21])
    made.connect(Choice.CHANGE_OF_STATE, rate_ms=60_000)
    for _ in range(30):
        made.put(ACK, b"")
        made.run(5)
    made.frames.clear()
    made.drive.trip("OC1")
    for _ in range(6):
        made.put(ACK, b"")
        made.run(5)
    assert any(frame.identifier == COS for frame in made.taken())


@pytest.mark.parametrize(
    ("choice", "trigger"),
    [
        (Choice.CHANGE_OF_STATE, 0x12),
        (Choice.CYCLIC, 0x02),
        (Choice.CHANGE_OF_STATE | Choice.ACK_SUPPRESSION, 0x10),
        (Choice.CYCLIC | Choice.ACK_SUPPRESSION, 0x00),
    ],
)
def test_transport_class_and_trigger_are_those_of_the_choice(choice: Choice, trigger: int) -> None:
    made = bench(C203[21])
    made.connect(choice)
    assert made.get(5, 4, 3) == bytes([trigger])
    assert made.get(5, 4, 6) == (b"\x0f" if choice & Choice.ACK_SUPPRESSION else b"\x01")


@pytest.mark.parametrize("released", [Choice.POLLED, Choice.CYCLIC])
def test_what_is_released_ends_and_what_is_not_goes_on(released: Choice) -> None:
    made = bench(C203[21])
    made.connect(Choice.POLLED | Choice.CYCLIC | Choice.ACK_SUPPRESSION, rate_ms=50)
    release = bytes.fromhex("00 4C 03 01") + bytes([released])
    made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), release)
    made.run(2)
    made.taken()
    made.run(200)
    sent = {frame.identifier for frame in made.taken()}
    gone = released is Choice.CYCLIC
    assert sent == (set() if gone else {COS})
    assert (made.poll(words(0, 0)) is not None) is gone
    left = Choice.EXPLICIT | (Choice.POLLED if gone else Choice.CYCLIC | Choice.ACK_SUPPRESSION)
    assert made.get(3, 1, 5) == bytes([left, 0])


def test_the_inhibit_time_keeps_changes_apart() -> None:
    made = bench(C203[21])
    made.connect(Choice.CHANGE_OF_STATE, rate_ms=1000)
    assert made.set(5, 4, 17, words(1001)) == Status.INVALID_ATTRIBUTE_VALUE
    assert made.set(5, 4, 17, words(200)) == 0
    assert made.set(5, 4, 9, words(199)) == Status.INVALID_ATTRIBUTE_VALUE
    assert made.get(5, 4, 9) == words(1000)
    assert made.get(5, 2, 17) == Status.OBJECT_DOES_NOT_EXIST
    made.frames.clear()
    times: list[int] = []
    for at in range(1000):
        for frame in made.taken():
            if frame.identifier == COS:
                times.append(at)
                made.put(ACK, b"")
        if at % 20 == 0:
            made.drive.trip("OC1") if at % 40 else made.drive.reset()
        made.run(1)
    assert all(later - earlier >= 200 for earlier, later in pairwise(times))
    assert len(times) >= 4


def test_an_acknowledgement_with_data_is_none() -> None:
    made = bench(C203[21])
    made.connect(Choice.CHANGE_OF_STATE, rate_ms=10)
    for _ in range(1100):
        made.put(ACK, b"\x00")
        made.run(10)
    assert state(made, 4) is ConnectionState.TIMED_OUT


# Explicit messages in fragments


@pytest.mark.fact("dn.fragments")
def test_a_long_request_and_a_long_answer_go_piece_by_piece() -> None:
    made = bench(C203[105])
    made.allocate(1)
    body = bytes.fromhex("10 04 69 00 03") + words(1, 0x0018, 2500) + bytes(12)
    pieces = [body[at : at + 6] for at in range(0, len(body), 6)]
    made.taken()
    for number, piece in enumerate(pieces):
        kind = 0 if number == 0 else 2 if number == len(pieces) - 1 else 1
        made.put(REQUEST, bytes([0x80, kind << 6 | number]) + piece)
        assert made.taken()[0].data == bytes([0x80, 0xC0 | number, 0])
    made.run(2)
    assert made.taken()[0].data == bytes.fromhex("00 90")
    assert made.drive.read_parameter("0018") == 25.0
    # Get of the 18 bytes comes in four pieces, each waiting for its acknowledgement.
    made.put(REQUEST, bytes.fromhex("40 0E 04 69 00 03"))
    made.run(2)
    got = b""
    for number in range(4):
        (frame,) = made.taken()
        assert frame.data[0] == 0xC0, "fragment, with the request's transaction"
        assert frame.data[1] & 0x3F == number
        got += frame.data[2:]
        made.put(REQUEST, bytes([0xC0, 0xC0 | number, 0]))
    made.run(3000)
    assert made.taken() == [], "what was acknowledged is not sent again"
    assert got == b"\x8e" + body[5:]


def test_a_fragment_without_acknowledgement_is_sent_once_more() -> None:
    made = bench(C203[105])
    made.allocate(1)
    made.taken()
    made.put(REQUEST, bytes.fromhex("00 0E 04 69 00 03"))
    made.run(2)
    (first,) = made.taken()
    made.run(1000)
    assert made.taken() == [first]
    made.run(5000)
    assert made.taken() == []


def test_a_master_that_takes_no_more_ends_a_long_answer() -> None:
    made = bench(C203[105])
    made.allocate(1)
    made.taken()
    made.put(REQUEST, bytes.fromhex("00 0E 04 69 00 03"))
    made.run(2)
    made.taken()
    made.put(REQUEST, bytes([0x80, 0xC5, 0]))
    assert made.taken() == [], "that acknowledges another fragment"
    made.put(REQUEST, bytes([0x80, 0xC0, 1]))
    made.run(5000)
    assert made.taken() == []


def test_a_repeated_fragment_is_acknowledged_and_not_taken_twice() -> None:
    made = bench()
    made.allocate(1)
    made.taken()
    piece = bytes.fromhex("80 00 10 29 01 00 05 01")
    for _ in range(2):
        made.put(REQUEST, piece)
        assert made.taken() == [
            Frame(group_2(Group2.EXPLICIT_RESPONSE, MAC), bytes.fromhex("80 C0 00"))
        ]


def test_every_fragment_may_come_twice_and_the_message_is_taken_once() -> None:
    made = bench(C203[105])
    made.allocate(1)
    made.put(REQUEST, bytes.fromhex("00 10 29 01 00 05 01"))
    made.run(2)
    made.taken()
    body = bytes.fromhex("10 04 69 00 03") + words(1, 0x0018, 2500) + bytes(12)
    pieces = [body[at : at + 6] for at in range(0, len(body), 6)]
    for number, piece in enumerate(pieces):
        kind = 0 if number == 0 else 2 if number == len(pieces) - 1 else 1
        for _ in range(2):
            made.put(REQUEST, bytes([0x80, kind << 6 | number]) + piece)
            assert made.taken()[0].data == bytes([0x80, 0xC0 | number, 0])
    made.run(5)
    assert [frame.data for frame in made.taken()] == [b"\x00\x90"]
    assert made.drive.read_parameter("0018") == 25.0


def test_a_message_that_went_wrong_is_begun_again() -> None:
    made = bench()
    made.allocate(1)
    made.taken()
    first, last = bytes.fromhex("80 00 10 2A 01 00 08 84"), bytes.fromhex("80 81 03")
    for piece in (first, b"\x80\x83\x03", first, last):
        made.put(REQUEST, piece)
    made.run(2)
    answers = [frame.data for frame in made.taken()]
    assert answers == [b"\x80\xc0\x00", b"\x80\xc0\x00", b"\x80\xc1\x00", b"\x00\x90"]
    assert made.get(0x2A, 1, 8) == words(900)


def test_a_message_that_is_too_long_is_refused_by_its_fragment() -> None:
    made = bench()
    made.allocate(1)
    made.taken()
    answers = []
    for number in range(12):
        kind = 0 if number == 0 else 1
        made.put(REQUEST, bytes([0x80, kind << 6 | number]) + bytes(6))
        answers += [frame.data[2] for frame in made.taken()]
    assert answers[:10] == [0] * 10
    assert answers[10] == 1


def test_explicit_messages_of_others_than_the_master_are_ignored() -> None:
    made = bench()
    made.allocate(1)
    made.taken()
    made.put(REQUEST, bytes.fromhex("01 0E 01 01 00 01"))
    made.run(5)
    assert made.taken() == []
