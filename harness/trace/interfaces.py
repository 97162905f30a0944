"""What is recorded of an interface for process data: supply, cyclic data by field, lamps."""

from collections.abc import Callable

from fbgen.catalog import CyclicField, Layout, ProcessDataGateway
from harness.gateways.pbdp110 import Pbdp110
from harness.kernel import Kernel
from harness.trace.device_channels import DeviceChannels, changed_bytes
from harness.trace.log import ChangeLog
from harness.trace.model import ChannelKind


class InterfaceWatch:
    """Looks at one interface whenever something may have changed, and at each transfer to it.

    The outputs are those that have reached the interface and count, the inputs those that the
    master gets. Fields that have a word in the catalogue are noted as words.
    """

    def __init__(
        self,
        log: ChangeLog,
        kernel: Kernel,
        device: Pbdp110,
        known: ProcessDataGateway,
        *,
        writer: Callable[[int], int | None],
    ) -> None:
        """`writer` gives the place of who wrote a byte of the outputs last."""
        self._log = log
        self._kernel = kernel
        self._device = device
        self._writer = writer
        self._before = b""
        channels = DeviceChannels(log, device.name)
        add = channels.add
        self._powered = add("powered", "has supply", "bool")
        self._online = add("online", "exchanges data with the master", "bool")
        self._outputs = add("outputs", "bytes from the master", "bytes")
        self._inputs = add("inputs", "bytes to the master", "bytes")
        self._diagnosis = add("diagnosis", "user diagnosis byte", "integer")
        self._telegrams = add("telegrams", "requests sent to the drives", "integer")
        layout = known.layout(device.settings.modules[0].name)
        self._out_fields = _fields(channels, layout.output, "output", known, layout)
        self._in_fields = _fields(channels, layout.input, "input", known, layout)
        self._lamps = channels.lamps(device.leds._fields)
        device.observers.append(self.look)
        self.look()

    def look(self) -> None:
        """Note everything as it is now."""
        note, now_ns, device = self._log.note, self._kernel.now_ns, self._device
        outputs, inputs = device.slave.outputs, device.slave.inputs
        note(self._powered, now_ns, device.powered)
        note(self._online, now_ns, device.slave.online)
        if outputs != self._before:
            self._outputs_came(now_ns, outputs)
            self._before = outputs
        note(self._inputs, now_ns, inputs)
        for channel, field in self._in_fields:
            note(channel, now_ns, int.from_bytes(inputs[field.offset : field.end], "big"))
        note(self._diagnosis, now_ns, device.diagnosis)
        note(self._telegrams, now_ns, device.telegrams)
        for lamp, light in zip(self._lamps, device.leds, strict=True):
            note(lamp, now_ns, light.value)

    def _outputs_came(self, now_ns: int, outputs: bytes) -> None:
        """Note the outputs, each field with who wrote it."""
        note = self._log.note
        others = changed_bytes(self._before, outputs)
        for channel, field in self._out_fields:
            mine = [at for at in others if field.offset <= at < field.end]
            writer = self._writer(mine[0]) if mine else None
            value = int.from_bytes(outputs[field.offset : field.end], "big")
            note(channel, now_ns, value, writer)
        note(self._outputs, now_ns, outputs, self._writer(others[0]) if others else None)


def _fields(
    channels: DeviceChannels,
    fields: tuple[CyclicField, ...],
    side: str,
    known: ProcessDataGateway,
    layout: Layout,
) -> list[tuple[int, CyclicField]]:
    """A channel for each field that is no pad."""
    words = {word.name for word in known.words}
    starts = tuple(f"{channel.name}_" for channel in known.channels_of(layout))
    found = []
    for field in fields:
        if field.pad:
            continue
        name = next(field.name.removeprefix(at) for at in starts if field.name.startswith(at))
        word = f"{known.id}.{name}" if name in words else None
        kind: ChannelKind = "word" if word is not None else "integer"
        found.append((channels.add(f"{side}.{field.name}", field.title, kind, word), field))
    return found
