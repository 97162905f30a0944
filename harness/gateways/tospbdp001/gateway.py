"""The TOSPBDP001: PROFIBUS DP slave on one side, Toshiba inverter line on the other.

Behaviour after the TOSPBDP001 manual v1.1, sections 3 and 6 to 9. A change of the trigger byte
makes the gateway take INV-NO, CMD, ComNo and DATA into its one buffer. After its processing time it
puts 2FH in front and the checksum behind and sends; it does not wait for a reply. What it receives
is compared with the one form it knows, 2FH, six bytes, checksum; the six bytes go to the PLC after
the same processing time, anything else only counts in the status word. A telegram that waits is
overwritten by the next change of the trigger: the buffer has no queue.

Inferred where the manual is silent: the processing time runs from the first change since the last
telegram went out, so that a PLC that triggers all the time is served at the device's own pace; of
telegrams that collide on the line and arrive as one heap the gateway counts one.
"""

from collections.abc import Callable
from functools import partial

from fbgen.diagnostics import error
from fbgen.wire import toshiba_ascii
from fbgen.wire.toshiba import ASCII_START, ErrorReply, Reply, Request, is_sealed, seal
from harness.fieldbus import DpSlave, SlaveType
from harness.gateways.tospbdp001.leds import (
    DARK,
    Fault,
    Leds,
    Light,
    device_light,
    diagnosis_light,
)
from harness.gateways.tospbdp001.memory import Memory
from harness.gateways.tospbdp001.settings import (
    OfflineInputs,
    OfflineOutputs,
    StartupLock,
    SubnetErrorLed,
    TosSettings,
)
from harness.gateways.tospbdp001.status import StatusWord
from harness.kernel import Event, Kernel
from harness.line import Line, Rate, Reception, Role, Transmission

FRAME_BYTES = 8
_TELEGRAM_BYTES = 6
_DATA_VALID = 0x2000
_HIGHEST_ADDRESS = 99


class Tospbdp001:
    """One gateway, without supply at first.

    `switch_a` and `switch_b` are the rotary switches for the PROFIBUS address, B x 10 + A.
    `overwritten` counts telegrams that were lost because the next trigger came before they went
    out, `telegrams` those that went out. `overwrites` is the probability that a telegram is lost in
    the buffer: zeros go out in its place, which no drive obeys. Functions in `observers` are called
    when something that can be seen at the device may have changed.
    """

    __slots__ = (
        "_answer_to_heartbeat",
        "_buffer",
        "_control_due_ns",
        "_heap_end_ns",
        "_heartbeat_event",
        "_initialised",
        "_kernel",
        "_life",
        "_locked",
        "_look_event",
        "_offline_event",
        "_outputs",
        "_reply",
        "_sending",
        "_telegram_due_ns",
        "_trigger",
        "_trigger_stuck",
        "_work_in_life",
        "fault",
        "name",
        "observers",
        "overwrites",
        "overwritten",
        "port",
        "powered",
        "powered_on_ns",
        "settings",
        "slave",
        "status",
        "switch_a",
        "switch_b",
        "telegrams",
    )

    def __init__(
        self, kernel: Kernel, settings: TosSettings, line: Line, address: int = 2, name: str = ""
    ) -> None:
        layout = settings.layout
        self._kernel = kernel
        self.name = name
        self.settings = settings
        self.slave = DpSlave(
            kernel,
            self,
            SlaveType(settings.ident_number, layout.configuration, settings.user_parameter_bytes),
            address,
            (layout.output_length, layout.input_length),
        )
        self.observers: list[Callable[[], None]] = []
        self.port = line.attach(self, Role.MASTER, settings.serial_format)
        self.switch_a = self.switch_b = 0
        self.set_switches(address)
        self.fault = Fault.NONE
        self.powered = False
        self.powered_on_ns = 0
        self._answer_to_heartbeat = toshiba_ascii.parse_request(settings.heartbeat)
        self._trigger_stuck = False
        self.overwrites = Rate(kernel.random)
        self._life = 0
        self._work_in_life = partial(self._work, 0)
        self._heartbeat_event: Event | None = None
        self._look_event: Event | None = None
        self._offline_event: Event | None = None
        self._forget()

    def _forget(self) -> None:
        self.status = StatusWord(self.settings)
        self.telegrams = self.overwritten = 0
        self._initialised = False
        self._locked = self.settings.startup_lock is not StartupLock.NONE
        self._outputs = bytes(self.settings.layout.output_length)
        self._trigger = self.settings.trigger_power_on
        self._buffer: bytes | None = None
        self._telegram_due_ns = self._control_due_ns = -1
        self._sending: Transmission | None = None
        self._heap_end_ns = -1
        self._reply = bytes(_TELEGRAM_BYTES)

    # --- supply, switches, faults -----------------------------------------------------------

    def set_switches(self, address: int) -> None:
        """Turn the address switches; the device looks at them at its next power-on.

        Raises DiagnosticError FB7301 for an address that the two switches cannot show.
        """
        if not 0 <= address <= _HIGHEST_ADDRESS:
            raise error(
                "FB7301",
                f"the address switches of '{self.name}' cannot be set to {address}",
                None,
                f"two rotary switches show 0 to {_HIGHEST_ADDRESS}",
            )
        self.switch_b, self.switch_a = divmod(address, 10)

    def power_on(self, memory: Memory | None = None) -> None:
        """24 V comes: initialise, read the address switches, wait for the master.

        With a `memory` it had its supply all the time, and this is what is in it.
        """
        if self.powered:
            return
        self.powered = True
        self.powered_on_ns = self._kernel.now_ns
        self._forget()
        if memory is not None:
            self._trigger = memory.trigger
            self._reply = memory.reply
            self.status = StatusWord(self.settings, memory.status)
        self._changed()
        if self.settings.startup_ns:
            self._kernel.after(self.settings.startup_ns, partial(self._start, self._life))
        else:
            self._start(self._life)

    def power_off(self) -> None:
        """24 V goes: silence on both sides at once, everything is forgotten."""
        self.powered = False
        self._life += 1
        self._work_in_life = partial(self._work, self._life)
        self.port.abort()
        self.slave.power_off()
        self._stop_sending()
        self._forget()
        self._changed()

    def fail(self, fault: Fault) -> None:
        """Break the device. It shows the fault and does nothing else until it is repaired."""
        self.fault = fault
        if self.powered and fault is not Fault.NONE:
            self.power_off()
            self.powered = True
            self._changed()

    def repair(self) -> None:
        """Mend the device and switch it off and on."""
        self.fault = Fault.NONE
        self.power_off()
        self.power_on()

    def _start(self, life: int) -> None:
        if life != self._life or self.fault is not Fault.NONE:
            return
        self._initialised = True
        self._publish()
        self.slave.power_on(self.switch_b * 10 + self.switch_a)

    @property
    def leds(self) -> Leds:
        """What the six lamps show."""
        if not self.powered:
            return DARK
        online = self.slave.online
        stopped = self.status.faulty
        at_device = self.settings.subnet_error_led is SubnetErrorLed.DEVICE_STATUS
        subnet = Light.GREEN if self._initialised else Light.GREEN_FLASHING
        if stopped and not at_device:
            subnet = Light.RED
        return Leds(
            Light.GREEN if online else Light.OFF,
            Light.OFF if online else Light.RED,
            Light.OFF,
            diagnosis_light(self.fault, self.slave.cfg_fault, self.slave.prm_fault),
            subnet,
            device_light(self.fault, not self._initialised, stopped and at_device),
        )

    def report(self, code: int) -> None:
        """Show a status code until the next valid telegram; nothing without supply."""
        if self._initialised:
            self.status.report(code)
            self._publish()

    # --- PROFIBUS ---------------------------------------------------------------------------

    def exchange_started(self) -> None:
        """The fieldbus is online: the heartbeat begins."""
        if self._heartbeat_event is None:
            self._heartbeat_event = self._kernel.after(self.settings.heartbeat_ns, self._heartbeat)
        if self.settings.offline_timeout_ns:
            self._watch_subnet()
        self._changed()

    def exchange_lost(self) -> None:
        """The fieldbus is offline: silence towards the drives, what waited is dropped."""
        behaviour = self.settings.offline_outputs
        if behaviour is OfflineOutputs.NO_SCANNING:
            self._stop_sending()
        elif behaviour is OfflineOutputs.CLEAR:
            self.outputs_received(bytes(len(self._outputs)))
        self._changed()

    def outputs_received(self, outputs: bytes) -> None:
        """The PLC's bytes have changed. They are looked at now, or on the grid of the poll."""
        settings = self.settings
        poll_ns = settings.trigger_poll_ns
        self._outputs, before = outputs, self._outputs
        if poll_ns:
            if self._look_event is None:
                delay_ns = poll_ns - (self._kernel.now_ns - self.powered_on_ns) % poll_ns
                self._look_event = self._kernel.after(delay_ns, self._look_at_trigger)
        elif outputs[settings.layout.trigger_offset] != self._trigger:
            self._look_at_trigger()
        at = settings.layout.control_offset
        if outputs[at : at + 2] != before[at : at + 2] and self._control_due_ns < 0:
            self._control_due_ns = self._kernel.now_ns + settings.processing_ns
            if self._control_due_ns != self._telegram_due_ns:
                self._work_at(self._control_due_ns)

    @property
    def trigger_stuck(self) -> bool:
        """True while changes of the trigger byte are not seen."""
        return self._trigger_stuck

    @trigger_stuck.setter
    def trigger_stuck(self, stuck: bool) -> None:
        self._trigger_stuck = stuck
        if not stuck and self.slave.online:
            self._look_at_trigger()

    def _look_at_trigger(self) -> None:
        self._look_event = None
        if self._trigger_stuck:
            return
        layout = self.settings.layout
        trigger = self._outputs[layout.trigger_offset]
        if trigger == self._trigger:
            return
        self._trigger = trigger
        waiting = self._buffer is not None
        self._buffer = layout.telegram_of(self._outputs)
        if waiting:
            self.overwritten += 1
            return
        self._telegram_due_ns = self._kernel.now_ns + self.settings.processing_ns
        self._work_at(self._telegram_due_ns)

    def _work_at(self, time_ns: int) -> None:
        self._kernel.at(time_ns, self._work_in_life)

    def _work(self, life: int) -> None:
        if life != self._life:
            return
        now_ns = self._kernel.now_ns
        if 0 <= self._control_due_ns <= now_ns:
            self._control_due_ns = -1
            at = self.settings.layout.control_offset
            control = self._outputs[at] << 8 | self._outputs[at + 1]
            self.status.control(control)
            if control & _DATA_VALID:
                self._locked = False
            self._publish()
        if self._buffer is not None and 0 <= self._telegram_due_ns <= now_ns:
            self._send()

    def _publish(self) -> None:
        self.slave.set_inputs(self.status.word.to_bytes(2, "big") + self._reply)
        self._changed()

    def _changed(self) -> None:
        for observer in self.observers:
            observer()

    # --- towards the drives -----------------------------------------------------------------

    def _send(self) -> None:
        free_ns = self._free_ns()
        if free_ns > self._kernel.now_ns:
            self._telegram_due_ns = free_ns
            self._work_at(free_ns)
            return
        telegram, self._buffer = self._buffer, None
        self._telegram_due_ns = -1
        if telegram is not None and not self._locked:
            if self.overwrites.hits(1):
                telegram = bytes(_TELEGRAM_BYTES)
                self.overwritten += 1
            self.telegrams += 1
            self._sending = self.port.transmit(seal(telegram))

    def _heartbeat(self) -> None:
        free_ns = self._free_ns()
        if free_ns > self._kernel.now_ns:
            self._heartbeat_event = self._kernel.at(free_ns, self._heartbeat)
            return
        self._sending = self.port.transmit(self.settings.heartbeat)
        self._heartbeat_event = self._kernel.after(self.settings.heartbeat_ns, self._heartbeat)

    def _free_ns(self) -> int:
        """The instant at which what this gateway sends now is over."""
        return self._sending.end_ns if self._sending is not None else 0

    def _stop_sending(self) -> None:
        for event in (self._heartbeat_event, self._look_event, self._offline_event):
            if event is not None:
                self._kernel.cancel(event)
        self._heartbeat_event = self._look_event = self._offline_event = None
        self._buffer = None
        self._telegram_due_ns = -1

    # --- from the drives --------------------------------------------------------------------

    def receive(self, reception: Reception) -> None:
        """Something was on the line. The gateway tells its own kind of reply from all else."""
        if not self._initialised:
            return
        in_heap = reception.start_ns < self._heap_end_ns
        if reception.end_ns > self._heap_end_ns:
            self._heap_end_ns = reception.end_ns
        data = reception.data
        if reception.marks is None and len(data) == FRAME_BYTES and is_sealed(data):
            done = partial(self._take_reply, self._life, data[1:-1])
        elif in_heap or (reception.marks is None and self._answers_heartbeat(data)):
            return
        else:
            done = partial(self._count_faulty, self._life)
        self._kernel.after(self.settings.processing_ns, done)

    def _answers_heartbeat(self, data: bytes) -> bool:
        request = self._answer_to_heartbeat
        if data[0] != ASCII_START or not isinstance(request, Request):
            return False
        reply = toshiba_ascii.parse_reply(data)
        if isinstance(reply, Reply):
            return reply.com_no == request.com_no and reply.command == request.command
        return isinstance(reply, ErrorReply)

    def _take_reply(self, life: int, telegram: bytes) -> None:
        if life != self._life:
            return
        self._reply = telegram
        self.status.valid_telegram()
        self._publish()
        if self.settings.offline_timeout_ns:
            self._watch_subnet()

    def _count_faulty(self, life: int) -> None:
        if life == self._life:
            self.status.invalid_telegram()
            self._publish()

    def _watch_subnet(self) -> None:
        if self._offline_event is not None:
            self._kernel.cancel(self._offline_event)
        self._offline_event = self._kernel.after(
            self.settings.offline_timeout_ns, self._subnet_offline
        )

    def _subnet_offline(self) -> None:
        self._offline_event = None
        self.status.offline_timeout()
        if self.settings.offline_inputs is OfflineInputs.CLEAR:
            self._reply = bytes(_TELEGRAM_BYTES)
        self._publish()
