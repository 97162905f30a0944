"""A serial port of an inverter: when it listens, when it answers, and when it has heard nothing.

What is said there is the business of the speaker of a protocol, how telegrams are found that of its
ear. Which ComNos set the port stands in the catalogue.

Facts: VF-S11 communications manual E6581222, pp. 4-13, 22; VF-AS1 RS485 manual E6581315, pp. 5-20,
43; TOSPBDP001 manual, sections 6 to 9. Inferred: as the line is half duplex, a telegram that begins
while the inverter still owes a reply or sends one is not heard; a telegram that came damaged, or
that nobody carries out, does not restart the time-out.
"""

from typing import Protocol

from fbgen.catalog import SerialPort
from harness.drives.device import Owner
from harness.drives.inter_drive import MasterPort, role_of
from harness.drives.settings import InverterSettings
from harness.drives.speakers import TOSHIBA, Ear, ear_for, protocol_of
from harness.kernel import NS_PER_S, Event, Kernel
from harness.line import Line, Parity, Port, Rate, Reception, Role, SerialFormat

_SENT_STOP_BITS = 2
_NEVER = 1 << 62
_EXPIRY_PRIORITY = 1
"""A telegram that ends at the very instant of the time-out is in time."""


class _Receive(Protocol):
    def __call__(self, reception: Reception) -> None: ...


class Communication:
    """One port of an inverter: a node on the line.

    What may change at any time: `reply_time`; with the probability of `late_replies` a reply comes
    `late_ns` later than that; `foreign_number` is an INV-NO to which it listens in place of its
    own, `reply_number` one with which it answers. `heard_ns` is when it had heard what it answers
    or has answered last; up to `deaf_until_ns` nothing is heard. `protocol` is the one that it
    speaks, None if the inverter was told to speak one that it does not have. It listens on `hears`.
    A port that is that of a master to other inverters when it is connected is wired as a master.
    """

    __slots__ = (
        "_deadline_ns",
        "_ear",
        "_foreign_number",
        "_frame",
        "_master",
        "_owner",
        "_registers",
        "_reply",
        "_settings",
        "_timed_out",
        "_timeout",
        "_timer",
        "_waiting",
        "_writes_only",
        "deaf_until_ns",
        "facts",
        "heard_ns",
        "hears",
        "inv_no",
        "kernel",
        "late_ns",
        "late_replies",
        "port",
        "protocol",
        "receive",
        "reply_number",
        "reply_time",
    )
    receive: _Receive
    """Hear what has ended on the line: the ear of the protocol that is spoken now."""

    def __init__(
        self,
        kernel: Kernel,
        line: Line,
        owner: Owner,
        facts: SerialPort,
        settings: InverterSettings,
    ) -> None:
        """`facts` is the port as the catalogue has it."""
        self.kernel = kernel
        own = role_of(owner.series, facts, owner.registers)
        role = Role.SLAVE if own is None or own.sends is None else Role.MASTER
        self.hears = line.master_pair if role is Role.SLAVE else line.slave_pair
        self.facts = facts
        self._timeout, self._waiting = facts.timeout, facts.send_waiting_time
        self._owner = owner
        self._registers = owner.registers
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
        self.deaf_until_ns = self.heard_ns = kernel.now_ns
        self.inv_no = 0
        self.protocol: str | None = None
        self._timed_out = False
        self._writes_only = settings.timeout_restart == "writes"
        device = owner.device
        self._master = MasterPort(
            self, owner.series, owner.registers, device.read, lambda: device.tripped
        )
        self.port: Port = line.attach(self, role, self._format())
        self._ear = self._listen()
        self.number_changed()

    def number_changed(self) -> None:
        """Take over INV-NO from the rotary switch or, if that is at 0, from F802."""
        self.inv_no = self._settings.rotary_switch or self._registers.word(self.facts.inv_no)
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
            self.kernel.cancel(self._timer)
            self._timer = None

    def restart(self, silence_ns: int) -> None:
        """Begin anew, deaf and mute for a while; the parameters that waited act from now on."""
        self.stop()
        self._timed_out = False
        self.deaf_until_ns = self.kernel.now_ns + silence_ns
        self.port.format = self._format()
        self._ear = self._listen()
        self.number_changed()

    def stop(self) -> None:
        """Fall silent in the middle of a reply if need be, until `restart`."""
        if self._reply is not None:
            self.kernel.cancel(self._reply)
        self.port.abort()
        self._master.stop()
        self._ear.reset()
        self.timeout_changed()
        self.deaf_until_ns = _NEVER

    # What a speaker asks for

    def carried_out(self, reads: bool) -> None:
        """A telegram is about to be carried out: that starts the time-out anew."""
        if self._timed_out:
            self._timed_out = False
            self._owner.device.heard(self.facts)
        if reads and self._writes_only:
            return
        seconds = self._registers.word(self._timeout)
        if not seconds:
            return
        self._deadline_ns = self.kernel.now_ns + seconds * NS_PER_S
        if self._timer is None:
            self._timer = self.kernel.at(self._deadline_ns, self._expire, _EXPIRY_PRIORITY)

    @property
    def mute(self) -> bool:
        """True while the inverter restarts: what it has just carried out is not answered."""
        return self.deaf_until_ns > self.kernel.now_ns

    def answer(self, frame: bytes, heard_ns: int) -> None:
        """Send a reply to what was over at `heard_ns`, after the reply time."""
        times = self.reply_time
        span_ns = times.maximum_ns - times.minimum_ns
        kernel = self.kernel
        delay_ns = times.minimum_ns + int(kernel.random.random() * (span_ns + 1))
        waiting = self._waiting
        if waiting is not None and self._registers.word(waiting):
            delay_ns += round(self._registers.value(waiting) * NS_PER_S)
        if self.late_replies.hits(1):
            delay_ns += self.late_ns
        self.heard_ns = heard_ns
        begin_ns = heard_ns + delay_ns
        if begin_ns < kernel.now_ns:
            begin_ns = kernel.now_ns
        self._frame = frame
        self._reply = kernel.at(begin_ns, self._send)
        self.deaf_until_ns = begin_ns + self.port.format.duration_ns(len(frame))

    # Inside

    def _send(self) -> None:
        self._reply = None
        self.port.transmit(self._frame)

    def _expire(self) -> None:
        """One event runs behind the deadline instead of one per telegram."""
        self._timer = None
        if self._deadline_ns is None:
            return
        if self._deadline_ns > self.kernel.now_ns:
            self._timer = self.kernel.at(self._deadline_ns, self._expire, _EXPIRY_PRIORITY)
            return
        self._deadline_ns = None
        self._timed_out = True
        self._owner.device.time_out(self.facts)

    def _listen(self) -> Ear:
        facts = self.facts
        chosen = 0 if facts.protocol is None else self._registers.word(facts.protocol)
        self.protocol = protocol_of(facts, chosen)
        ear = ear_for(self, self.protocol, self._owner, self._settings.options)
        self.receive = ear.receive
        self.inter_drive_changed()
        return ear

    def inter_drive_changed(self) -> None:
        """Begin or end to send set-points to other inverters, as F806 or F826 says."""
        if self.protocol == TOSHIBA:
            self._master.start()

    def _format(self) -> SerialFormat:
        registers, facts, series = self._registers, self.facts, self._owner.series
        rate = series.baud_rates(facts)[registers.word(facts.baud_rate)]
        parity = series.parities(facts)[registers.word(facts.parity)]
        return SerialFormat(rate, Parity[parity.upper()], _SENT_STOP_BITS)
