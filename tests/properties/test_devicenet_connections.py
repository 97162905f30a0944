"""A DEV003Z under any row of requests, polls and times: its connections are those of a small model.

The model knows which connections there are, whose they are, and when they time out; nothing else.
Whatever comes, every frame that goes out is one that the option may send.
"""

from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
)

from fbgen.wire.devicenet import Choice, Frame, Status
from fbgen.wire.devicenet_ids import Group2, SlaveMessage, group_2, slave_message
from fbgen.wire.devicenet_messages import ErrorResponse, Response, parse_response
from harness.fieldbus.devicenet import ConnectionState, Network
from harness.gateways.dev003z import State
from tests.unit.devicenet.bench import MAC, Bench, bench, words

OWN = {
    group_2(Group2.DUPLICATE_MAC_CHECK, MAC),
    group_2(Group2.EXPLICIT_RESPONSE, MAC),
    slave_message(SlaveMessage.POLL_RESPONSE, MAC),
    slave_message(SlaveMessage.COS, MAC),
}
"""The identifiers with which it sends."""
MASTERS = st.sampled_from([0, 0, 0, 1, 2])
CHOICES = st.one_of(st.sampled_from([1, 2, 3, 0x10, 0x13, 0x20, 0x50]), st.integers(0, 127))
CONNECTIONS = 0x33
COS = 0x30
FIRST_MS = 10_000
C203_21 = 1


class Connections(RuleBasedStateMachine):
    """Two rates and a clock in whole milliseconds keep the model small."""

    def __init__(self) -> None:
        super().__init__()
        self.made = bench(C203_21, parameters={"timeout_action": 1})
        self.choice = 0
        self.master: int | None = None
        self.rate_ms = 0
        self.established = False
        self.deadline_ns: int | None = None

    @property
    def now_ns(self) -> int:
        return self.made.kernel.now_ns

    @property
    def timed_out(self) -> bool:
        return self.deadline_ns is not None and self.now_ns >= self.deadline_ns

    @initialize(rate_ms=st.sampled_from([0, 20, 500]))
    def begin_as_masters_do(self, rate_ms: int) -> None:
        self.allocate(3, 0)
        self.set_rate(rate_ms)

    @rule(choice=CHOICES, master=MASTERS)
    def allocate(self, choice: int, master: int) -> None:
        answer = self.made.allocate(choice, master)
        good = (
            not choice & 0x0C
            and choice & CONNECTIONS != 0
            and choice & COS != COS
            and not (choice & 0x40 and not choice & COS)
            and self.master in (None, master)
            and not choice & self.choice & CONNECTIONS
            and not (choice & COS and self.choice & COS)
            and (choice | self.choice) & 1
        )
        assert isinstance(answer, Response if good else ErrorResponse)
        if good:
            self.choice |= choice
            self.master = master
            if choice & 2:
                self.established, self.rate_ms, self.deadline_ns = False, 0, None

    @rule(choice=CHOICES, master=MASTERS)
    def release(self, choice: int, master: int) -> None:
        self.made.taken()
        body = bytes([master, 0x4C, 3, 1, choice])
        self.made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), body)
        self.made.run(2)
        found = [item for item in self.made.taken() if item.identifier == 0x403 + 8 * MAC]
        answer = parse_response(found[0].data[1:])
        asked = choice & CONNECTIONS
        good = (
            not choice & 0x0C
            and asked != 0
            and self.master in (None, master)
            and not asked & ~self.choice
        )
        assert isinstance(answer, Response if good else ErrorResponse)
        if good:
            self.choice &= ~asked
            if choice & COS:
                self.choice &= ~0x40
            if choice & 2:
                self.established, self.deadline_ns = False, None
            if not self.choice:
                self.master = None

    @precondition(lambda self: self.choice & 3 == 3 and self.master == 0)
    @rule(rate_ms=st.sampled_from([0, 20, 500]))
    def set_rate(self, rate_ms: int) -> None:
        timed_out = self.timed_out
        asked_ns = self.now_ns
        assert self.made.set(5, 2, 9, words(rate_ms)) == 0
        self.rate_ms = rate_ms
        if timed_out:
            return
        patience = 4 * rate_ms if self.established else max(FIRST_MS, 4 * rate_ms)
        self.deadline_ns = asked_ns + patience * 1_000_000 if rate_ms else None
        self.established = True

    @rule(length=st.sampled_from([4, 4, 4, 0, 3, 5, 8]))
    def poll(self, length: int) -> None:
        goes = bool(self.choice & 2) and self.established and not self.timed_out
        came_ns = self.now_ns
        answer = self.made.poll(bytes(length))
        assert (answer is not None) is (goes and length <= 4)
        if answer is not None:
            assert len(answer) == 4
            patience = 4 * self.rate_ms * 1_000_000
            self.deadline_ns = came_ns + patience if self.rate_ms else None

    @rule(ms=st.sampled_from([7, 77, 79, 1, 500, 1998, 2100, 11_000]))
    def wait(self, ms: int) -> None:
        self.made.run(ms)

    @precondition(lambda self: self.deadline_ns is not None and not self.timed_out)
    @rule(behind=st.booleans())
    def wait_for_the_watchdog(self, behind: bool) -> None:
        assert self.deadline_ns is not None
        self.made.kernel.run_until(self.deadline_ns - 1)
        self.the_connections_are_those_of_the_model()
        if behind:
            self.made.kernel.run_until(self.deadline_ns)

    @precondition(lambda self: self.choice & 1 and self.master == 0)
    @rule()
    def ask_for_the_allocation(self) -> None:
        assert self.made.get(3, 1, 5) == bytes([self.choice, 0])

    @rule()
    def power_cycle(self) -> None:
        self.made.drive.power_off()
        self.made.run(1)
        self.made.drive.power_on()
        self.made.run(2200)
        self.made.taken()
        self.choice, self.master = 0, None
        self.established, self.deadline_ns = False, None

    @invariant()
    def the_connections_are_those_of_the_model(self) -> None:
        node = self.made.option.node
        assert node.network is Network.ONLINE
        assert node.allocation.choice == self.choice
        wanted = {1} if self.choice & 1 else set()
        wanted |= {2} if self.choice & 2 else set()
        wanted |= {4} if self.choice & COS else set()
        assert set(node.connections) == wanted
        if 2 in wanted:
            state = ConnectionState.CONFIGURING
            if self.established:
                state = ConnectionState.ESTABLISHED
                state = ConnectionState.TIMED_OUT if self.timed_out else state
            assert node.connections[2].state is state

    @invariant()
    def only_its_own_frames_go_out(self) -> None:
        assert {item.identifier for item in self.made.frames} <= OWN


Connections.TestCase.settings = settings(max_examples=100, stateful_step_count=20)
TestConnections = Connections.TestCase


NAMED = [
    group_2(message, MAC)
    for message in (
        Group2.UNCONNECTED_REQUEST,
        Group2.EXPLICIT_REQUEST,
        Group2.POLL,
        Group2.COS_ACKNOWLEDGE,
        Group2.DUPLICATE_MAC_CHECK,
        Group2.BIT_STROBE,
    )
]
FRAMES = st.builds(
    Frame,
    st.one_of(st.sampled_from(NAMED), st.sampled_from(NAMED[:3]), st.integers(0, 0x7FF)),
    st.binary(max_size=8),
)
REQUESTS = st.builds(
    lambda service, known, instance, data: Frame(
        NAMED[1], (bytes([0, service, known]) + instance.to_bytes(2, "little") + data)[:8]
    ),
    st.sampled_from([0x05, 0x0E, 0x10, 0x4B, 0x4C]),
    st.sampled_from([1, 2, 3, 4, 5, 0x28, 0x29, 0x2A, 0x2B, 0x64]),
    st.one_of(st.integers(0, 5), st.integers(0x4000, 0x4020), st.just(0x7A06)),
    st.binary(min_size=1, max_size=3),
)


@given(
    c203=st.integers(0, 5),
    frames=st.lists(st.one_of(FRAMES, REQUESTS, REQUESTS), max_size=40),
    connected=st.booleans(),
)
@settings(max_examples=60)
def test_any_frames_are_answered_as_devicenet_has_it_or_ignored(
    c203: int, frames: list[Frame], connected: bool
) -> None:
    """Never an exception, never a frame of another node; a malformed poll runs no drive."""
    made: Bench = bench(c203)
    if connected:
        made.connect(Choice.POLLED | Choice.CHANGE_OF_STATE)
    for frame in frames:
        made.option.receive(frame)
        made.run(3)
    assert {item.identifier for item in made.taken()} <= OWN
    assert made.option.state in State
    _ = made.option.lights, made.option.produce()


@given(
    service=st.one_of(st.sampled_from([0x0E, 0x10]), st.integers(0, 0x7F)),
    known=st.one_of(
        st.sampled_from([1, 2, 3, 4, 5, 0x28, 0x29, 0x2A, 0x2B, 0x64]), st.integers(0, 255)
    ),
    instance=st.one_of(st.integers(0, 5), st.integers(0, 0xFFFF)),
    data=st.binary(max_size=3),
    xid=st.sampled_from([0x00, 0x40]),
)
@settings(max_examples=150)
def test_every_request_of_the_master_gets_just_one_answer(
    service: int, known: int, instance: int, data: bytes, xid: int
) -> None:
    """With its transaction, and with a status that there is; but those that reset or allocate."""
    assume(service not in (0x05, 0x4B, 0x4C))
    connected = bench(C203_21, parameters={"timeout_action": 1})
    connected.connect(rate_ms=0)
    body = bytes([service, known]) + instance.to_bytes(2, "little") + data
    connected.taken()
    connected.put(NAMED[1], bytes([xid]) + body)
    connected.run(2)
    (frame,) = connected.taken()
    assert frame.identifier == 0x403 + 8 * MAC
    assert frame.data[0] & 0x7F == xid
    if frame.data[0] & 0x80:
        assert frame.data[1:3] == bytes([0, 0x80 | service]), "the first of several fragments"
        return
    answer = parse_response(frame.data[1:])
    if isinstance(answer, ErrorResponse):
        assert answer.status in set(Status) - {Status.SUCCESS}
        assert answer.additional == 0xFF
    else:
        assert answer.service == service


@given(data=st.binary(max_size=7), c203=st.sampled_from([1, 3]))
@settings(max_examples=40)
def test_a_poll_of_a_wrong_length_never_runs_the_drive(data: bytes, c203: int) -> None:
    made = bench(c203)
    made.connect()
    length = made.option.output_length
    if len(data) != length:
        made.poll(data)
        made.run(50)
        assert not made.drive.told_to_run
        assert made.drive.registers.ram[0xFA06] == 0
