"""A DeviceNet slave: duplicate MAC check, predefined connection set, explicit messages and I/O.

It is a "group 2 only" server: a master reaches it by the unconnected port first, and by nothing but
Allocate and Release there; messages of group 3 are not for it. What DeviceNet does not say of a
frame is not answered. Facts: DEV003Z-1 manual E6581737, pages 7, 8, 14 and 33 to 36; IEC 62026-3 as
public implementations have it.
"""

from collections.abc import Callable

from fbgen.wire.devicenet import NO_ADDITIONAL_CODE, BodyFormat, Choice, Frame, Service, Status
from fbgen.wire.devicenet_fragments import io_frames
from fbgen.wire.devicenet_ids import Group2, SlaveMessage, group_2, slave_message
from fbgen.wire.devicenet_messages import (
    RESPONSE,
    DuplicateCheck,
    ErrorResponse,
    Header,
    MessageError,
    Request,
    Response,
    encode_response,
    parse_duplicate_check,
    parse_header,
    parse_request,
)
from harness.fieldbus.devicenet.allocation import (
    Allocation,
    is_allocation,
    refuse_allocation,
    refuse_release,
    refuse_unconnected,
)
from harness.fieldbus.devicenet.application import Application
from harness.fieldbus.devicenet.change_of_state import Producer
from harness.fieldbus.devicenet.connection import (
    COS,
    EXPLICIT,
    POLLED,
    Connection,
    ConnectionState,
    WatchdogAction,
)
from harness.fieldbus.devicenet.explicit import ExplicitEnd
from harness.fieldbus.devicenet.io_data import IoReader
from harness.fieldbus.devicenet.settings import Network, NodeSettings
from harness.kernel import Event, Kernel

_CHECKS = 2
_COS_CHOICE = Choice.CHANGE_OF_STATE | Choice.CYCLIC
_INSTANCES = ((Choice.EXPLICIT, EXPLICIT), (Choice.POLLED, POLLED), (_COS_CHOICE, COS))
_UNCONNECTED_FORM = BodyFormat.C8_I8
"""Class and instance of requests to the unconnected port have a byte each."""


class DeviceNetSlave:
    """The network side of a device. `send` puts a frame on the bus; `receive` takes one from it.

    Functions in `observers` are called when the lamps may have changed. `ack_timer_ms` and
    `ack_retries` are those of the Acknowledge Handler.
    """

    __slots__ = (
        "_application",
        "_checks_left",
        "_events",
        "_explicit",
        "_io_reader",
        "_kernel",
        "_put",
        "_receivers",
        "ack_retries",
        "ack_timer_ms",
        "allocation",
        "bus_off_count",
        "bus_off_interrupt",
        "connections",
        "network",
        "observers",
        "producer",
        "settings",
    )

    def __init__(
        self,
        kernel: Kernel,
        send: Callable[[Frame], None],
        settings: NodeSettings,
        application: Application,
    ) -> None:
        self._kernel = kernel
        self._put = send
        self._application = application
        self._events: list[Event] = []
        self._checks_left = 0
        self.settings = settings
        self.network = Network.OFF
        self.allocation = Allocation()
        self.connections: dict[int, Connection] = {}
        self.producer: Producer | None = None
        self._io_reader = IoReader(0)
        self.bus_off_count = 0
        self.bus_off_interrupt = False
        self.ack_timer_ms = 16
        self.ack_retries = 1
        self.observers: list[Callable[[], None]] = []
        mac = settings.mac
        self._explicit = ExplicitEnd(
            kernel,
            group_2(Group2.EXPLICIT_RESPONSE, mac),
            send,
            self._connected,
            limit=settings.explicit_bytes,
            timeout_ns=settings.fragment_timeout_ns,
        )
        self._receivers: dict[int, Callable[[bytes], None]] = {
            group_2(Group2.UNCONNECTED_REQUEST, mac): self._unconnected,
            group_2(Group2.EXPLICIT_REQUEST, mac): self._explicit_frame,
            group_2(Group2.POLL, mac): self._poll,
            group_2(Group2.COS_ACKNOWLEDGE, mac): self._acknowledged,
        }

    # The node

    def power_on(self) -> None:
        """Begin with the self test."""
        if self.network is Network.OFF:
            self.network = Network.SELF_TEST
            self._later(self.settings.self_test_ns, self._begin_check)
            self.changed()

    def power_off(self) -> None:
        """Everything is forgotten at once."""
        self._leave(Network.OFF)
        self.bus_off_count = 0
        self.ack_timer_ms, self.ack_retries = 16, 1

    def restart(self) -> None:
        """As the service Reset of the Identity object asks for, when its answer is out."""
        self._later(2 * self.settings.response_ns, self._power_cycle)

    def bus_off(self) -> None:
        """The CAN chip went off the bus. Whether it comes back is an attribute."""
        if self.network in (Network.OFF, Network.SELF_TEST):
            return
        self.bus_off_count = min(self.bus_off_count + 1, 0xFF)
        self._leave(Network.FAULT)
        if self.bus_off_interrupt:
            self._begin_check()

    def receive(self, frame: Frame) -> None:
        """Take a frame from the bus. What is none of its own, or malformed, changes nothing."""
        if self.network in (Network.OFF, Network.SELF_TEST, Network.FAULT):
            return
        if frame.identifier == group_2(Group2.DUPLICATE_MAC_CHECK, self.settings.mac):
            self._same_mac(frame.data)
        elif self.network is Network.ONLINE:
            receiver = self._receivers.get(frame.identifier)
            if receiver is not None:
                receiver(frame.data)

    @property
    def established(self) -> bool:
        """Whether any connection is."""
        return any(item.established for item in self.connections.values())

    @property
    def io_established(self) -> bool:
        """Whether an I/O connection is."""
        return any(item.established for key, item in self.connections.items() if key != EXPLICIT)

    @property
    def io_running(self) -> bool:
        """Whether an I/O connection is, and not idle."""
        return any(
            item.established and not item.idle
            for key, item in self.connections.items()
            if key != EXPLICIT
        )

    @property
    def io_timed_out(self) -> bool:
        """Whether an I/O connection timed out and was not established again."""
        timed_out = ConnectionState.TIMED_OUT
        return any(item.state is timed_out for item in self.connections.values())

    # Duplicate MAC check

    def _begin_check(self) -> None:
        self.network = Network.CHECKING
        self._checks_left = _CHECKS
        self.changed()
        self._check()

    def _check(self) -> None:
        if not self._checks_left:
            self.network = Network.ONLINE
            self.changed()
            return
        self._checks_left -= 1
        self._put(self._own_check(response=False))
        self._later(self.settings.check_ns, self._check)

    def _same_mac(self, data: bytes) -> None:
        """Another node has this MAC ID, or asks whether somebody has it."""
        try:
            check = parse_duplicate_check(data)
        except MessageError:
            return
        if self.network is Network.ONLINE and not check.response:
            self._put(self._own_check(response=True))
        else:
            self._leave(Network.FAULT)

    def _own_check(self, *, response: bool) -> Frame:
        settings = self.settings
        data = DuplicateCheck(response, settings.vendor, settings.serial).encode()
        return Frame(group_2(Group2.DUPLICATE_MAC_CHECK, settings.mac), data)

    # Explicit messages

    def _unconnected(self, data: bytes) -> None:
        """Allocate and Release for whoever asks. Any other request is refused."""
        if not data or (header := parse_header(data[0])).fragment:
            return
        if len(data) == 1 or data[1] & RESPONSE:
            return
        answer: Response | ErrorResponse = refuse_unconnected()
        try:
            request = parse_request(data[1:], _UNCONNECTED_FORM)
        except MessageError:
            pass
        else:
            if is_allocation(request):
                answer = self._allocate_or_release(request, header.mac)
        # Short, and beside the connection: what goes on there in fragments goes on.
        identifier = group_2(Group2.EXPLICIT_RESPONSE, self.settings.mac)
        frame = Frame(identifier, bytes([header.byte]) + encode_response(answer))
        self._later(self.settings.response_ns, lambda: self._put(frame))

    def _explicit_frame(self, data: bytes) -> None:
        connection = self.connections.get(EXPLICIT)
        if connection is None or not data:
            return
        if parse_header(data[0]).mac != self.allocation.master:
            return
        connection.message()
        self._explicit.receive(data)

    def _connected(self, header: Header, body: bytes) -> None:
        """A whole message of the master over the explicit connection."""
        if not body or body[0] & RESPONSE:
            return
        try:
            request = parse_request(body, self.settings.body_format)
        except MessageError:
            self._respond(header, ErrorResponse(Status.NOT_ENOUGH_DATA, NO_ADDITIONAL_CODE))
            return
        if is_allocation(request):
            answer = self._allocate_or_release(request, header.mac)
        else:
            answer = self._application.serve(request)
        self._respond(header, answer)

    def _respond(self, header: Header, answer: Response | ErrorResponse) -> None:
        body = encode_response(answer)
        self._later(self.settings.response_ns, lambda: self._explicit.send(header, body))

    # Allocation

    def _allocate_or_release(self, request: Request, master: int) -> Response | ErrorResponse:
        if request.service == Service.ALLOCATE:
            refused = refuse_allocation(self.allocation, request)
            if refused is None:
                self._allocate(Choice(request.data[0]), request.data[1])
                return Response(Service.ALLOCATE, bytes([self.settings.body_format]))
        else:
            refused = refuse_release(self.allocation, request, master)
            if refused is None:
                self._release(Choice(request.data[0]))
                return Response(Service.RELEASE)
        return refused

    def _allocate(self, choice: Choice, master: int) -> None:
        self.allocation = Allocation(self.allocation.choice | choice, master)
        application, settings = self._application, self.settings
        for bits, instance in _INSTANCES:
            if not choice & bits:
                continue
            sizes = {
                EXPLICIT: (settings.explicit_bytes, settings.explicit_bytes),
                POLLED: (application.input_length, application.output_length),
                COS: (application.input_length, 0),
            }[instance]
            connection = Connection(
                self._kernel, instance, sizes, settings.unused_ns, self._timed_out
            )
            self.connections[instance] = connection
            if instance == POLLED:
                self._io_reader = IoReader(connection.consumed_size)
            elif instance == COS:
                self._begin_cos(connection, choice)
        self.changed()

    def _begin_cos(self, connection: Connection, choice: Choice) -> None:
        producer = Producer(
            self._kernel,
            connection,
            self.settings.sample_ns,
            self._application.produce,
            lambda data: self._send_io(SlaveMessage.COS, connection, data),
        )
        producer.timer_ms, producer.retries = self.ack_timer_ms, self.ack_retries
        producer.begin(
            cyclic=bool(choice & Choice.CYCLIC), suppressed=bool(choice & Choice.ACK_SUPPRESSION)
        )
        self.producer = producer

    def _release(self, choice: Choice) -> None:
        for bits, instance in _INSTANCES:
            if choice & bits:
                self._delete(instance)

    def _delete(self, instance: int) -> None:
        connection = self.connections.pop(instance, None)
        if connection is None:
            return
        carried = instance != EXPLICIT and connection.established
        connection.end()
        gone = next(bits for bits, number in _INSTANCES if number == instance)
        left = self.allocation.choice & ~gone
        if instance == COS:
            left &= ~Choice.ACK_SUPPRESSION
            if self.producer is not None:
                self.producer.end()
            self.producer = None
        elif instance == EXPLICIT:
            self._explicit.reset()
        self.allocation = Allocation(left, self.allocation.master) if left else Allocation()
        explicit = self.connections.get(EXPLICIT)
        deferred = explicit is not None and explicit.state is ConnectionState.DEFERRED_DELETE
        if deferred and not self.io_established:
            self._delete(EXPLICIT)
        if carried:
            self._lost(instance)
        self.changed()

    def _lost(self, instance: int) -> None:
        """A connection is lost: it counts if it carried commands, or if no I/O is left."""
        if instance == POLLED or not self.io_established:
            self._application.communication_lost()

    def _timed_out(self, connection: Connection) -> None:
        if connection.instance == EXPLICIT:
            if connection.action is WatchdogAction.DEFERRED_DELETE and self.io_established:
                connection.state = ConnectionState.DEFERRED_DELETE
            else:
                self._delete(EXPLICIT)
        self._lost(connection.instance)
        self.changed()

    # I/O

    def _poll(self, frame: bytes) -> None:
        connection = self.connections.get(POLLED)
        if connection is None or not connection.established:
            return
        data = self._io_reader.feed(frame)
        if data is None or len(data) > connection.consumed_size:
            return
        connection.message()
        connection.idle = not data
        if len(data) == connection.consumed_size:
            self._application.consume(data)
        self._later(self.settings.response_ns, self._answer_poll)

    def _answer_poll(self) -> None:
        connection = self.connections.get(POLLED)
        if connection is not None:
            self._send_io(SlaveMessage.POLL_RESPONSE, connection, self._application.produce())

    def _acknowledged(self, frame: bytes) -> None:
        if self.producer is not None and not frame:
            self.producer.acknowledge()

    def _send_io(self, message: SlaveMessage, connection: Connection, data: bytes) -> None:
        identifier = slave_message(message, self.settings.mac)
        for frame in io_frames(identifier, data, connection.produced_size):
            self._put(frame)

    # Inside

    def _power_cycle(self) -> None:
        self.power_off()
        self._application.reset()
        self.power_on()

    def _leave(self, network: Network) -> None:
        """Off the network: nothing is under way any more, and no connection is left."""
        for event in self._events:
            self._kernel.cancel(event)
        self._events.clear()
        lost = self.established
        for connection in self.connections.values():
            connection.end()
        if self.producer is not None:
            self.producer.end()
        self.producer = None
        self.connections.clear()
        self._explicit.reset()
        self.allocation = Allocation()
        self.network = network
        if lost:
            self._application.communication_lost()
        self.changed()

    def _later(self, delay_ns: int, action: Callable[[], None]) -> None:
        now_ns = self._kernel.now_ns
        self._events = [event for event in self._events if event[0] >= now_ns]
        self._events.append(self._kernel.after(delay_ns, action))

    def changed(self) -> None:
        """Tell the observers that the state of a connection may be another."""
        for observer in self.observers:
            observer()
