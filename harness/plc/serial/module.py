"""A communication module for a serial line: its port, its receive buffer, what it is sending.

Sources: TIA Portal Information System, "Send_P2P", "Receive_P2P" and "Error messages"; 1024 bytes
of receive buffer: S7-1200 System Manual A5E02486680, 13.6, RCV_PTP. Our own: how long a job and a
message need between CPU and module (`transfer_ns`); a message that finds no room is lost.
"""

from collections import deque

from harness.kernel import NS_PER_MS, NS_PER_S, Event, Kernel
from harness.line import Line, Reception, Role, SerialFormat
from harness.plc.serial.conditions import LONGEST_MESSAGE, ReceiveConditions
from harness.plc.serial.reader import NO_RESPONSE, Message, MessageReader

OVERFLOW, TOO_MANY = 0x81E0, 0x81E6
CANCELLED = 0x81D5
_AFTER_BYTES = 2
"""At the end of a gap a byte that ends just then comes first."""


class SendJob:
    """One transmission: under way, over, or cancelled with a status."""

    __slots__ = ("end_ns", "status")

    def __init__(self) -> None:
        self.end_ns: int | None = None
        self.status = 0

    def over(self, now_ns: int) -> bool:
        """True when the last stop bit is out, or nothing will go out any more."""
        return self.status != 0 or (self.end_ns is not None and self.end_ns <= now_ns)


class ModbusSettings:
    """What Modbus_Comm_Load has set, and which master has a request under way."""

    __slots__ = ("master", "reply_ms", "retries")

    def __init__(self, reply_ms: int, retries: int) -> None:
        self.reply_ms = reply_ms
        self.retries = retries
        self.master: object | None = None


class SerialModule:
    """One module with one port, supplied by the CPU.

    `epoch` counts what the program's instances must notice: starts of the CPU and losses of supply.
    `lost_messages` counts what found no room. `failed` is a module that does not answer the CPU.
    """

    __slots__ = (
        *("_job", "_kernel", "_messages", "_reader", "_response", "_timer", "buffer_bytes"),
        *("buffered_messages", "conditions", "configured", "epoch", "failed", "idle_bits"),
        *("line", "lost_messages", "modbus", "name", "port", "powered", "transfer_ns"),
    )

    def __init__(
        self,
        kernel: Kernel,
        line: Line,
        format: SerialFormat,  # noqa: A002 - the field's term
        conditions: ReceiveConditions | None = None,
        name: str = "",
    ) -> None:
        self._kernel = kernel
        self.line = line
        self.name = name
        self.port = line.attach(self, Role.MASTER, format)
        self.configured = (format, conditions or ReceiveConditions())
        self.conditions = self.configured[1]
        self.buffer_bytes = 1024
        self.buffered_messages = 255
        self.transfer_ns = 2 * NS_PER_MS
        self.idle_bits = 0
        self.epoch = self.lost_messages = 0
        self.modbus: ModbusSettings | None = None
        self.powered = True
        self.failed = False
        self._messages: deque[Message] = deque()
        self._job: SendJob | None = None
        self._timer: Event | None = None
        self._response: Event | None = None
        self._reader = self._new_reader()

    # --- supply, CPU, settings ----------------------------------------------------------------

    def cpu_started(self) -> None:
        """STOP to RUN: the instances of the program begin anew; what was received stays."""
        self.epoch += 1
        if self.modbus is not None:
            self.modbus.master = None

    def cpu_stopped(self) -> None:
        """RUN to STOP: what is being sent ends in the middle of a character."""
        self._cancel()

    def power_off(self) -> None:
        """The supply goes, and everything that was received with it."""
        self._cancel()
        self.powered = False
        self.epoch += 1
        self.clear()
        self.port.format, self.conditions = self.configured
        self.idle_bits = 0
        self.modbus = None
        self._reader = self._new_reader()

    def power_on(self) -> None:
        """The supply comes: the device configuration counts again."""
        self.powered = True

    def configure(
        self,
        format: SerialFormat | None = None,  # noqa: A002 - the field's term
        conditions: ReceiveConditions | None = None,
    ) -> None:
        """Other settings until the supply is lost; what was received is deleted."""
        self.port.format = format or self.port.format
        self.conditions = conditions or self.conditions
        self.clear()
        self._reader = self._new_reader()

    def clear(self) -> None:
        """Delete what was received, and what of a message is there."""
        self._messages.clear()
        self._reader.reset()
        self._stop_timers()

    @property
    def available(self) -> bool:
        """True for a module that answers the CPU."""
        return self.powered and not self.failed

    # --- sending ------------------------------------------------------------------------------

    @property
    def sending(self) -> bool:
        """True while a job is under way."""
        return self._job is not None and not self._job.over(self._kernel.now_ns)

    def send(self, data: bytes) -> SendJob:
        """Send, after the way from the CPU and the idle line that was asked for."""
        job = self._job = SendJob()
        wait_ns = self.transfer_ns + self.idle_bits * self._bit_ns
        self._kernel.after(wait_ns, lambda: self._send_now(job, data))
        return job

    def _send_now(self, job: SendJob, data: bytes) -> None:
        if job.status:
            return
        job.end_ns = self.port.transmit(data).end_ns
        if self.conditions.response_ms is not None:
            due_ns = job.end_ns + self.conditions.response_ms * NS_PER_MS
            self._response = self._kernel.at(due_ns, self._no_response)

    def _no_response(self) -> None:
        self._response = None
        self._keep(Message(b"", NO_RESPONSE))

    def _cancel(self) -> None:
        if self._job is not None and self.sending:
            self._job.status = CANCELLED
        self._job = None
        self.port.abort()

    # --- receiving ----------------------------------------------------------------------------

    def receive(self, reception: Reception) -> None:
        """Hear what has ended on the line."""
        if not self.powered:
            return
        if self._response is not None and reception.data:
            self._kernel.cancel(self._response)
            self._response = None
        marks = reception.marks or bytes(len(reception.data))
        for index, byte in enumerate(reception.data):
            self._keep(*self._reader.feed(byte, marks[index], reception.byte_end_ns(index)))
        self._set_timer()

    def take(self) -> Message | None:
        """The oldest message, which then is no longer there."""
        return self._messages.popleft() if self._messages else None

    def _keep(self, *messages: Message) -> None:
        for message in messages:
            room = self.buffer_bytes - sum(len(one.data) for one in self._messages)
            if len(self._messages) >= self.buffered_messages:
                self._lose(TOO_MANY)
            elif len(message.data) > min(room, LONGEST_MESSAGE):
                self._lose(OVERFLOW)
            else:
                self._messages.append(message)

    def _lose(self, status: int) -> None:
        self.lost_messages += 1
        if self._messages and self._messages[-1].status == status:
            return
        self._messages.append(Message(b"", status))

    def _set_timer(self) -> None:
        if self._timer is not None:
            self._kernel.cancel(self._timer)
            self._timer = None
        due_ns = self._reader.deadline_ns
        if due_ns is not None:
            self._timer = self._kernel.at(due_ns, self._expire, _AFTER_BYTES)

    def _expire(self) -> None:
        """A message ends by time, unless somebody sends: then its characters decide."""
        self._timer = None
        if self.line.slave_pair.busy and not self.port.transmitting:
            self._timer = self._kernel.after(self._bit_ns, self._expire, _AFTER_BYTES)
            return
        self._keep(*self._reader.expire(self._kernel.now_ns))
        self._set_timer()

    def _stop_timers(self) -> None:
        for event in (self._timer, self._response):
            if event is not None:
                self._kernel.cancel(event)
        self._timer = self._response = None

    @property
    def _bit_ns(self) -> int:
        return NS_PER_S // self.port.format.baud

    def _new_reader(self) -> MessageReader:
        return MessageReader(self.conditions, self._bit_ns)
