"""What is recorded of a gateway: supply, cyclic data with their fields, lamps."""

from collections.abc import Callable

from fbgen.catalog import TelegramGateway
from harness.gateways.tospbdp001 import Tospbdp001
from harness.kernel import Kernel
from harness.line import Spacing
from harness.trace.device_channels import DeviceChannels, changed_bytes
from harness.trace.log import ChangeLog

_CODE_SHIFT, _CODE_MASK, _COUNT_MASK = 8, 0x1F, 0xFF
"""Where the status word has status code and error counter (TOSPBDP001 manual v1.1, 8 A)."""


class GatewayWatch:
    """Looks at one gateway whenever something may have changed, and at each transfer to it.

    Control word and trigger are those that have reached the gateway, zeros included that a master
    in CLEAR sends; the status word is what the gateway posts. `trigger` is the trigger's channel.
    """

    def __init__(
        self,
        log: ChangeLog,
        kernel: Kernel,
        gateway: Tospbdp001,
        known: TelegramGateway,
        spacing: Spacing,
        *,
        writer: Callable[[int], int | None],
    ) -> None:
        """`writer` gives the place of who wrote a byte of the outputs last."""
        self._log = log
        self._kernel = kernel
        self._gateway = gateway
        self._spacing = spacing
        self._writer = writer
        self._before = b""
        self._state: tuple[object, ...] = ()
        self._counts: tuple[int, ...] = ()
        self._control_offset = gateway.settings.layout.control_offset
        self._trigger_offset = gateway.settings.layout.trigger_offset
        channels = DeviceChannels(log, gateway.name)
        add = channels.add
        self._powered = add("powered", "has supply", "bool")
        self._online = add("online", "exchanges data with the master", "bool")
        self._control = add("control", "control word", "word", f"{known.id}.control")
        self.trigger = add("trigger", "trigger byte", "integer")
        self._outputs = add("outputs", "bytes from the master", "bytes")
        self._status = add("status", "status word", "word", f"{known.id}.status")
        self._code = add("status_code", "status code in the status word", "integer")
        self._count = add("error_count", "counter of faulty telegrams", "integer")
        self._inputs = add("inputs", "bytes to the master", "bytes")
        telegrams = add("telegrams", "telegrams sent to the drives", "integer")
        overwritten = add("overwritten", "telegrams overwritten before", "integer")
        too_close = add("too_close", "telegrams too close to the one before", "integer")
        self._counters = telegrams, overwritten, too_close
        self._lamps = channels.lamps(gateway.leds._fields)
        gateway.observers.append(self.look)
        self.look()

    def look(self) -> None:
        """Note everything as it is now."""
        note, now_ns, gateway = self._log.note, self._kernel.now_ns, self._gateway
        slave, status, lights = gateway.slave, gateway.status.word, gateway.leds
        state = gateway.powered, slave.online, status, lights
        if state != self._state:
            self._state = state
            note(self._powered, now_ns, gateway.powered)
            note(self._online, now_ns, slave.online)
        if (outputs := slave.outputs) != self._before:
            self._outputs_came(now_ns, outputs)
            self._before = outputs
        if state is self._state:
            note(self._status, now_ns, status)
            note(self._code, now_ns, status >> _CODE_SHIFT & _CODE_MASK)
            note(self._count, now_ns, status & _COUNT_MASK)
        note(self._inputs, now_ns, slave.inputs)
        counts = gateway.telegrams, gateway.overwritten, len(self._spacing.too_close)
        if counts != self._counts:
            self._counts = counts
            for channel, count in zip(self._counters, counts, strict=True):
                note(channel, now_ns, count)
        if state is self._state:
            for lamp, light in zip(self._lamps, lights, strict=True):
                note(lamp, now_ns, light.value)

    def _outputs_came(self, now_ns: int, outputs: bytes) -> None:
        """Note the outputs, with who wrote them: of several bytes, the first that is another."""
        note, at, trigger = self._log.note, self._control_offset, self._trigger_offset
        others = changed_bytes(self._before, outputs)
        control = [place for place in others if at <= place <= at + 1]
        writer = self._writer(control[0]) if control else None
        note(self._control, now_ns, outputs[at] << 8 | outputs[at + 1], writer)
        writer = self._writer(trigger) if trigger in others else None
        note(self.trigger, now_ns, outputs[trigger], writer)
        if writer is None and others:
            writer = self._writer(others[0])
        note(self._outputs, now_ns, outputs, writer)
