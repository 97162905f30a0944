"""How an inverter listens and answers on its line.

Facts: VF-S11 communications manual E6581222, pp. 4-13, 22; VF-AS1 RS485 manual E6581315, pp. 5-20,
43; TOSPBDP001 manual, sections 6 to 9. Inferred: as the line is half duplex, a telegram that begins
while the inverter still owes a reply or sends one is not heard; a telegram that came damaged, or
that nobody carries out, does not restart the time-out.
"""

from dataclasses import replace
from typing import Protocol

from fbgen.catalog.communication import baud_rate_of
from fbgen.wire import toshiba_ascii, toshiba_binary
from fbgen.wire.toshiba import (
    BROADCAST,
    TRIPPED_BIT,
    Address,
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Form,
    Group,
    Reply,
    Request,
)
from fbgen.wire.toshiba_stream import request_stream
from harness.drives.registers import Registers
from harness.drives.settings import InverterSettings
from harness.kernel import NS_PER_S, Event, Kernel
from harness.line import Line, Parity, Port, Rate, Reception, Role, SerialFormat

PARAMETERS = (
    "baud_rate",
    "parity",
    "inverter_number",
    "communication_timeout",
    "send_waiting_time",
)
"""Names of the ComNos that say how the inverter communicates."""

_SENT_STOP_BITS = 2
_NEVER = 1 << 62
_BINARY = Form.BINARY
_SINGLE = range(100)
"""Numbers that mean one inverter."""
_READS = (Command.R, Command.G)
_WRITE_RAM, _WRITE_EEPROM = Command.P, Command.W
_EXPIRY_PRIORITY = 1
"""A telegram that ends at the very instant of the time-out is in time."""


class Device(Protocol):
    """The inverter behind the port, as the port needs it."""

    @property
    def tripped(self) -> bool:
        """True from a trip to the reset."""

    def read(self, number: int) -> int | None:
        """The word of a cell, None if there is none."""

    def write_ram(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell until the next restart; why it is refused, or None."""

    def write_eeprom(self, number: int, word: int) -> ErrorCode | None:
        """Write a cell for good; why it is refused, or None."""

    def set_scaled(self, number: int, word: int) -> None:
        """Take a value of the commands S and s."""

    def time_out(self) -> None:
        """No telegram came within the time of F803."""


class Communication:
    """The inverter's serial port: a node on the line.

    What may change at any time: `reply_time`; with the probability of `late_replies` a reply comes
    `late_ns` later than that; `foreign_number` is an INV-NO to which it listens in place of its
    own, `reply_number` one with which it answers. `heard_ns` is when it had heard what it answers
    or has answered last.
    """

    __slots__ = (
        "_deadline_ns",
        "_deaf_until_ns",
        "_device",
        "_foreign_number",
        "_frame",
        "_kernel",
        "_registers",
        "_reply",
        "_settings",
        "_timer",
        "heard_ns",
        "inv_no",
        "late_ns",
        "late_replies",
        "port",
        "reply_number",
        "reply_time",
        "stream",
    )

    def __init__(
        self,
        kernel: Kernel,
        line: Line,
        registers: Registers,
        device: Device,
        settings: InverterSettings,
    ) -> None:
        self._kernel = kernel
        self._registers = registers
        self._device = device
        self._settings = settings
        self.reply_time = settings.reply_time
        self.late_replies = Rate(kernel.random)
        self.late_ns = 0
        self.reply_number: int | None = None
        self._foreign_number: int | None = None
        self._reply: Event | None = None
        self._frame = b""
        self._timer: Event | None = None
        self._deadline_ns: int | None = None
        self._deaf_until_ns = self.heard_ns = kernel.now_ns
        self.stream = request_stream()
        self.inv_no = 0
        self.port: Port = line.attach(self, Role.SLAVE, self._format())
        self.number_changed()

    def receive(self, reception: Reception) -> None:
        """Hear what has ended on the line."""
        if reception.start_ns < self._deaf_until_ns:
            return
        data, marks = reception.data, reception.marks
        if marks is None and (whole := self.stream.whole(data)) is not None:
            if whole.address == self.inv_no or whole.address not in _SINGLE:
                self._take(whole)
            return
        for message in self.stream.feed(data, reception.start_ns, reception.byte_ns, marks):
            self._take(message)
            if reception.end_ns < self._deaf_until_ns:
                self.stream.reset()
                return

    def number_changed(self) -> None:
        """Take over INV-NO from the rotary switch or, if that is at 0, from F802."""
        self.inv_no = self._settings.rotary_switch or self._registers.word("inverter_number")
        if self._foreign_number is not None:
            self.inv_no = self._foreign_number

    @property
    def foreign_number(self) -> int | None:
        """An INV-NO that is not its own and to which it listens; None for its own."""
        return self._foreign_number

    @foreign_number.setter
    def foreign_number(self, number: int | None) -> None:
        self._foreign_number = number
        self.number_changed()

    def timeout_changed(self) -> None:
        """Forget the running time-out: the new one starts with the next telegram."""
        self._deadline_ns = None
        if self._timer is not None:
            self._kernel.cancel(self._timer)
            self._timer = None

    def restart(self, silence_ns: int) -> None:
        """Begin anew, deaf and mute for a while; the parameters that waited act from now on."""
        self.stop()
        self._deaf_until_ns = self._kernel.now_ns + silence_ns
        self.port.format = self._format()
        self.number_changed()

    def stop(self) -> None:
        """Fall silent in the middle of a reply if need be, until `restart`."""
        if self._reply is not None:
            self._kernel.cancel(self._reply)
        self.port.abort()
        self.stream.reset()
        self.timeout_changed()
        self._deaf_until_ns = _NEVER

    def _take(self, message: Request | BadRequest) -> None:
        address = message.address
        several = address == BROADCAST or isinstance(address, Group)
        answers = address == self.inv_no or self._answers(address)
        if not answers and not (several and self._is_meant(address)):
            return
        if isinstance(message, BadRequest):
            if answers:
                self._refuse(message, message.error)
            return
        reads = message.command in _READS
        if reads and several and not self._settings.broadcast_reads:
            return
        if not reads or self._settings.timeout_restart == "any_answered":
            self._restart_timeout()
        self._carry_out(message, answers)

    def _answers(self, address: Address) -> bool:
        if address is None:
            return True
        if isinstance(address, Group):
            return address.lowest == self.inv_no
        return address == BROADCAST and self.inv_no == 0

    def _is_meant(self, address: Address) -> bool:
        return not isinstance(address, Group) or address.includes(self.inv_no)

    def _carry_out(self, request: Request, answers: bool) -> None:
        command, number, device = request.command, request.com_no, self._device
        value: int | None = request.data
        error: ErrorCode | None = None
        if command in _READS:
            value = device.read(number)
        elif command is _WRITE_RAM:
            error = device.write_ram(number, request.data)
        elif command is _WRITE_EEPROM:
            error = device.write_eeprom(number, request.data)
        else:
            device.set_scaled(number, request.data)
            return
        if not answers or self._deaf_until_ns > self._kernel.now_ns:
            return
        if error is not None:
            self._refuse(request, error)
        elif value is None:
            self._refuse(request, ErrorCode.COM_NO)
        else:
            if self.reply_number is not None:
                request = replace(request, address=self.reply_number)
            self._send_later(_answer(request, value, device.tripped))

    def _refuse(self, message: Request | BadRequest, error: ErrorCode) -> None:
        tripped = self._device.tripped
        form, checked = message.form, message.checked
        address = message.address if self.reply_number is None else self.reply_number
        reply = ErrorReply(address, error, tripped, form, checked)
        protocol = toshiba_binary if form is _BINARY else toshiba_ascii
        self._send_later(protocol.encode_reply(reply))

    def _send_later(self, frame: bytes) -> None:
        times = self.reply_time
        span_ns = times.maximum_ns - times.minimum_ns
        kernel = self._kernel
        delay_ns = times.minimum_ns + int(kernel.random.random() * (span_ns + 1))
        if self._registers.word("send_waiting_time"):
            delay_ns += round(self._registers.value("send_waiting_time") * NS_PER_S)
        if self.late_replies.hits(1):
            delay_ns += self.late_ns
        self.heard_ns = kernel.now_ns
        begin_ns = kernel.now_ns + delay_ns
        self._frame = frame
        self._reply = kernel.at(begin_ns, self._send)
        self._deaf_until_ns = begin_ns + self.port.format.duration_ns(len(frame))

    def _send(self) -> None:
        self._reply = None
        self.port.transmit(self._frame)

    def _restart_timeout(self) -> None:
        seconds = self._registers.word("communication_timeout")
        if not seconds:
            return
        self._deadline_ns = self._kernel.now_ns + seconds * NS_PER_S
        if self._timer is None:
            self._timer = self._kernel.at(self._deadline_ns, self._expire, _EXPIRY_PRIORITY)

    def _expire(self) -> None:
        """One event runs behind the deadline instead of one per telegram."""
        self._timer = None
        if self._deadline_ns is None:
            return
        if self._deadline_ns > self._kernel.now_ns:
            self._timer = self._kernel.at(self._deadline_ns, self._expire, _EXPIRY_PRIORITY)
            return
        self._deadline_ns = None
        self._device.time_out()

    def _format(self) -> SerialFormat:
        baud, parity = self._registers.cell("baud_rate"), self._registers.cell("parity")
        rate = baud_rate_of(baud.values[self._registers.word("baud_rate")])
        assert rate is not None, "checked when the inverter was made"
        return SerialFormat(
            rate,
            Parity[parity.values[self._registers.word("parity")].upper()],
            _SENT_STOP_BITS,
        )


def _answer(request: Request, value: int, tripped: bool) -> bytes:
    """The frame that says a value read or written."""
    address, command, com_no = request.address, request.command, request.com_no
    if request.form is _BINARY:
        cmd = command | TRIPPED_BIT if tripped else command
        return toshiba_binary.reply_frame(address, cmd, com_no, value)
    reply = Reply(address, command, com_no, value, tripped, request.form, request.checked)
    return toshiba_ascii.encode_reply(reply)
