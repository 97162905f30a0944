"""A DeviceNet master with a scan list: it allocates slaves, exchanges I/O, looks for lost ones.

Polled: once in a scan a slave gets its outputs and answers with its inputs. With change of state or
cyclic data beside it the slave sends by itself, and outputs go out when they change, and as often
as the expected packet rate asks for. With change of state alone there are no outputs.
"""

from collections.abc import Callable, Sequence
from enum import Enum
from functools import partial
from typing import Literal

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import BodyFormat, Choice, Frame, Service
from fbgen.wire.devicenet_fragments import io_frames
from fbgen.wire.devicenet_ids import Group2, SlaveMessage, group_2, slave_message
from fbgen.wire.devicenet_messages import (
    DuplicateCheck,
    ErrorResponse,
    MessageError,
    Request,
    Response,
    parse_duplicate_check,
)
from harness.fieldbus.devicenet.connection import COS, POLLED
from harness.fieldbus.devicenet.io_data import IoReader
from harness.fieldbus.devicenet.requester import Answer, Done, Requester
from harness.kernel import NS_PER_MS, NS_PER_S, Kernel

_BITS = (
    *(Choice.POLLED, Choice.CHANGE_OF_STATE, Choice.CYCLIC),
    Choice.EXPLICIT,
)
"""What is released of a slave that was allocated already, one by one: explicit messages last."""
_COS_CHOICE = Choice.CHANGE_OF_STATE | Choice.CYCLIC
_MISSED = 3
_RETRY_NS = NS_PER_S // 4
_CHECK_NS = NS_PER_S
_CHECKS = 2
_RATE_ATTRIBUTE = 9
_PERIODS = 4


class SlaveState(Enum):
    """How far a slave of the scan list has got."""

    WAITING = "not looked for yet"
    CONNECTING = "being allocated"
    RUNNING = "exchanging data"
    LOST = "lost"


@dataclass(frozen=True, slots=True)
class ScanEntry:
    """A slave of the scan list: bytes each way, connections, and the expected packet rate."""

    mac: int
    output_length: int
    input_length: int
    choice: Choice = Choice.POLLED
    rate_ms: int = 100


class ScannedSlave:
    """What the master has of a slave: `outputs` to be written, `inputs` as they came last.

    `attempt` counts what the master does to reach it: an answer to an earlier one comes too late.
    """

    __slots__ = (
        "attempt",
        "cos_reader",
        "entry",
        "heard_ns",
        "inputs",
        "missed",
        "outputs",
        "poll_reader",
        "requester",
        "sent",
        "sent_ns",
        "state",
        "waits",
    )

    def __init__(self, entry: ScanEntry, requester: Requester) -> None:
        self.entry = entry
        self.requester = requester
        self.outputs = bytes(entry.output_length)
        self.inputs = bytes(entry.input_length)
        self.state = SlaveState.WAITING
        self.attempt = 0
        self.poll_reader = IoReader(entry.input_length)
        self.cos_reader = IoReader(entry.input_length)
        self.missed = 0
        self.waits = False
        self.sent: bytes | None = None
        self.sent_ns = self.heard_ns = 0

    @property
    def exchanging(self) -> bool:
        """Whether data come and go."""
        return self.state is SlaveState.RUNNING


class Scanner:
    """The master on the bus. While `idle` it polls without data: slaves go on as they were told.
    `idle` follows the CPU; `held_idle` is so whatever the CPU does.

    `on` until it is stopped, or finds out that another node has its MAC ID.
    Functions in `on_state` are called with a slave whose state is another.
    """

    __slots__ = (
        "_kernel",
        "_life",
        "_online",
        "_put",
        "_receivers",
        "_scan_ns",
        "held_idle",
        "idle",
        "mac",
        "on",
        "on_state",
        "serial",
        "slaves",
        "vendor",
    )

    def __init__(
        self,
        kernel: Kernel,
        send: Callable[[Frame], None],
        entries: Sequence[ScanEntry],
        mac: int = 0,
        scan_ns: int = 10 * NS_PER_MS,
    ) -> None:
        self._kernel = kernel
        self._put = send
        self._scan_ns = scan_ns
        self.mac = mac
        self.vendor, self.serial = 0, 0
        self.idle = self.held_idle = self.on = False
        self.on_state: list[Callable[[ScannedSlave], None]] = []
        self._life = 0
        self._online = False
        self.slaves = {
            entry.mac: ScannedSlave(entry, Requester(kernel, mac, entry.mac, send))
            for entry in entries
        }
        self._receivers: dict[int, Callable[[bytes], None]] = {}
        for address, slave in self.slaves.items():
            response = group_2(Group2.EXPLICIT_RESPONSE, address)
            self._receivers[response] = slave.requester.receive
            polled = slave_message(SlaveMessage.POLL_RESPONSE, address)
            self._receivers[polled] = partial(self._polled, slave)
            self._receivers[slave_message(SlaveMessage.COS, address)] = partial(self._cos, slave)

    @property
    def mode(self) -> Literal["OFF", "IDLE", "RUN"]:
        """What it does: nothing, poll without data, exchange data."""
        if not self.on:
            return "OFF"
        return "IDLE" if self.idle or self.held_idle else "RUN"

    def start(self) -> None:
        """Say who it is, twice, and then begin to scan."""
        self.on = True
        self._online = False
        for number in range(_CHECKS):
            self._later(number * _CHECK_NS, lambda: self._put(self._check(response=False)))
        self._later(_CHECKS * _CHECK_NS, self._begin)

    def _begin(self) -> None:
        self._online = True
        self._scan()

    def stop(self) -> None:
        """No supply: silence, and all slaves are forgotten."""
        self.on = False
        self._life += 1
        for slave in self.slaves.values():
            slave.requester.clear()
            self._becomes(slave, SlaveState.WAITING)

    def _becomes(self, slave: ScannedSlave, state: SlaveState) -> None:
        slave.state = state
        for told in self.on_state:
            told(slave)

    def _later(self, delay_ns: int, action: Callable[[], None]) -> None:
        """Do it then, if the scanner has been on all the time."""
        life = self._life
        self._kernel.after(delay_ns, lambda: action() if life == self._life else None)

    def receive(self, frame: Frame) -> None:
        """Take a frame from the bus."""
        receiver = self._receivers.get(frame.identifier)
        if not self.on:
            return
        if receiver is not None:
            receiver(frame.data)
        elif frame.identifier == group_2(Group2.DUPLICATE_MAC_CHECK, self.mac):
            self._same_mac(frame.data)

    def _same_mac(self, data: bytes) -> None:
        """Another node has this MAC ID, or asks whether somebody has it."""
        try:
            check = parse_duplicate_check(data)
        except MessageError:
            return
        if self._online and not check.response:
            self._put(self._check(response=True))
        else:
            self.stop()

    def request(self, mac: int, request: Request, done: Done) -> None:
        """Send a slave an explicit request; `done` gets its answer, None for none."""
        self.slaves[mac].requester.request(request, done)

    def _check(self, *, response: bool) -> Frame:
        data = DuplicateCheck(response, self.vendor, self.serial).encode()
        return Frame(group_2(Group2.DUPLICATE_MAC_CHECK, self.mac), data)

    # Coming to a slave

    def _connect(self, slave: ScannedSlave) -> None:
        slave.attempt += 1
        self._becomes(slave, SlaveState.CONNECTING)
        choice = slave.entry.choice | Choice.EXPLICIT
        request = Request(Service.ALLOCATE, 3, 1, bytes([choice, self.mac]))
        done = partial(self._allocated, slave, slave.attempt)
        slave.requester.request(request, done, unconnected=True)

    def _allocated(self, slave: ScannedSlave, attempt: int, answer: Answer) -> None:
        if attempt != slave.attempt:
            return
        if not isinstance(answer, Response) or len(answer.data) != 1:
            if isinstance(answer, ErrorResponse):
                self._release(slave)
            self._lose(slave)
            return
        slave.requester.form = BodyFormat(answer.data[0] & 3)
        self._set_rates(slave, [POLLED, COS])

    def _set_rates(self, slave: ScannedSlave, instances: list[int]) -> None:
        choice = slave.entry.choice
        has = {POLLED: bool(choice & Choice.POLLED), COS: bool(choice & _COS_CHOICE)}
        left = [instance for instance in instances if has[instance]]
        if not left:
            slave.waits, slave.sent, slave.missed = False, None, 0
            slave.heard_ns = self._kernel.now_ns
            self._becomes(slave, SlaveState.RUNNING)
            return
        rate = slave.entry.rate_ms.to_bytes(2, "little")
        request = Request(Service.SET_ATTRIBUTE_SINGLE, 5, left[0], bytes([_RATE_ATTRIBUTE]) + rate)

        attempt = slave.attempt

        def done(answer: Answer) -> None:
            if attempt != slave.attempt:
                return
            if isinstance(answer, Response):
                self._set_rates(slave, left[1:])
            else:
                self._lose(slave)

        slave.requester.request(request, done)

    def _release(self, slave: ScannedSlave) -> None:
        """Release what may be allocated from an earlier life of this master."""
        for bits in _BITS:
            request = Request(Service.RELEASE, 3, 1, bytes([bits]))
            slave.requester.request(request, lambda _: None, unconnected=True)

    def _lose(self, slave: ScannedSlave) -> None:
        """Try again later, once: whatever was tried before does not go on."""
        slave.attempt += 1
        self._becomes(slave, SlaveState.LOST)
        self._later(_RETRY_NS, partial(self._retry, slave, slave.attempt))

    def _retry(self, slave: ScannedSlave, attempt: int) -> None:
        if attempt == slave.attempt:
            self._connect(slave)

    # Exchanging data

    def _scan(self) -> None:
        for slave in self.slaves.values():
            if slave.state is SlaveState.WAITING:
                self._connect(slave)
            elif slave.exchanging:
                self._exchange(slave)
        self._later(self._scan_ns, self._scan)

    def _exchange(self, slave: ScannedSlave) -> None:
        choice, now_ns = slave.entry.choice, self._kernel.now_ns
        rate_ns = slave.entry.rate_ms * NS_PER_MS
        if choice & _COS_CHOICE and now_ns - slave.heard_ns > _PERIODS * rate_ns:
            self._drop(slave)
            return
        if not choice & Choice.POLLED:
            return
        if slave.waits:
            slave.missed += 1
            if slave.missed >= _MISSED:
                self._drop(slave)
                return
        data = slave.outputs if self.mode == "RUN" else b""
        if choice & _COS_CHOICE and slave.sent == data and now_ns - slave.sent_ns < rate_ns:
            return
        slave.waits, slave.sent, slave.sent_ns = True, data, now_ns
        identifier = group_2(Group2.POLL, slave.entry.mac)
        for frame in io_frames(identifier, data, slave.entry.output_length):
            self._put(frame)

    def _drop(self, slave: ScannedSlave) -> None:
        slave.requester.clear()
        self._lose(slave)

    def _polled(self, slave: ScannedSlave, frame: bytes) -> None:
        data = slave.poll_reader.feed(frame)
        if data is not None and slave.exchanging:
            slave.waits, slave.missed = False, 0
            self._take(slave, data)

    def _cos(self, slave: ScannedSlave, frame: bytes) -> None:
        data = slave.cos_reader.feed(frame)
        if data is None:
            return
        if not slave.entry.choice & Choice.ACK_SUPPRESSION:
            self._put(Frame(group_2(Group2.COS_ACKNOWLEDGE, slave.entry.mac), b""))
        self._take(slave, data)

    def _take(self, slave: ScannedSlave, data: bytes) -> None:
        """A slave with data of another length is not the one of the scan list: it is given up."""
        slave.heard_ns = self._kernel.now_ns
        if len(data) == slave.entry.input_length:
            slave.inputs = data
        elif slave.exchanging:
            self._drop(slave)
