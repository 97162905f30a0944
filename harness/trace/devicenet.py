"""What is recorded of DeviceNet: the scanner, what it has of each drive, and the option in that.

The outputs are those that the option took last, the inputs those that came to the scanner last.
Fields that have a word in the catalogue are noted as words.
"""

from collections.abc import Callable, Iterable, Mapping

from fbgen.catalog import Catalog, DeviceNetGateway
from fbgen.catalog.devicenet_gateways import AssemblyField
from fbgen.plant import DeviceNetDrive
from fbgen.wire import devicenet
from harness.drives import Inverter
from harness.fieldbus.devicenet import CanPort, ConnectionState, Network, ScannedSlave
from harness.fieldbus.devicenet.connection import CONNECTIONS
from harness.installation.devicenet import DeviceNet
from harness.kernel import Kernel
from harness.trace.assembly_meaning import field_value
from harness.trace.device_channels import changed_bytes
from harness.trace.devicenet_frames import CanFrameWatch, ScannedDrive
from harness.trace.log import ChangeLog
from harness.trace.model import Channel, ChannelKind
from harness.trace.words import WORD_BITS

_Fields = list[tuple[int, AssemblyField]]


class NetworkWatch:
    """Looks at one network: each drive whenever something may have changed for it.

    `writer` gives the place of who wrote an output byte of the PLC last, by its address.
    """

    def __init__(
        self,
        log: ChangeLog,
        kernel: Kernel,
        catalog: Catalog,
        network: DeviceNet,
        drives: Mapping[str, Inverter],
        *,
        writer: Callable[[int], int | None],
    ) -> None:
        entry = network.entry
        self._log = log
        self._kernel = kernel
        self._scanner = network.scanner
        title = "what the scanner does"
        path = f"devicenet.{entry.name}.mode"
        self._mode = log.add(Channel(path, title, "text", "devicenet", entry.name))
        self.frames = _frames(network, catalog)
        self._drives = [
            _DriveWatch(log, kernel, network, item, drives[item.name], writer=writer)
            for item in entry.drives
        ]
        watches = {item.mac: watch for item, watch in zip(entry.drives, self._drives, strict=True)}

        def changed(slave: ScannedSlave) -> None:
            watches[slave.entry.mac].look()

        network.scanner.on_state.append(changed)
        by_name = {watch.name: watch for watch in self._drives}

        def passed(_: int, frame: devicenet.Frame, __: CanPort) -> None:
            name, carries_data = self.frames.drive_of(frame.identifier)
            if name is None:
                return
            if carries_data:
                by_name[name].data_passed()
            else:
                by_name[name].look()

        network.bus.taps.append(passed)
        self.look_at_scanner()

    def look_at_scanner(self) -> None:
        """Note the mode of the scanner."""
        self._log.note(self._mode, self._kernel.now_ns, self._scanner.mode)

    def look(self) -> None:
        """Note everything as it is now."""
        self.look_at_scanner()
        for watch in self._drives:
            watch.look()


class _DriveWatch:
    """One drive: its option, and what the scanner has of it."""

    def __init__(
        self,
        log: ChangeLog,
        kernel: Kernel,
        network: DeviceNet,
        entry: DeviceNetDrive,
        drive: Inverter,
        *,
        writer: Callable[[int], int | None],
    ) -> None:
        self.name = entry.name
        self._log = log
        self._kernel = kernel
        self._entry = entry
        self._option = option = network.options[entry.name]
        self._drive = drive
        self._slave = network.scanner.slaves[entry.mac]
        self._pair = option.assemblies.chosen
        self._writer = writer
        self._before = b""
        self._came: bytes | None = None
        self._seen: tuple[object, ...] = ()
        add = self._add
        self._online = add("online", "is on the network", "bool")
        self._exchanging = add("exchanging", "exchanges data with the scanner", "bool")
        self._network = add("network", "how far the node has got", "text")
        self._scanned = add("scanner", "its state in the scan list", "text")
        self._state = add("state", "state of the Control Supervisor", "text")
        self._connections = {
            instance: add(f"connection.{name}", f"connection {name.replace('_', ' ')}", "text")
            for name, instance in CONNECTIONS.items()
        }
        self._outputs = add("outputs", "bytes from the scanner", "bytes")
        self._inputs = add("inputs", "bytes to the scanner", "bytes")
        known = option.gateway
        self._out_fields = self._fields("output", self._pair.output.fields, known)
        self._in_fields = self._fields("input", self._pair.input.fields, known)
        self._lamps = {
            lamp.name: add(f"led.{lamp.name}", f"lamp {lamp.name.replace('_', ' ')}", "text")
            for lamp in known.leds
        }
        self._lights = {
            lamp.name: {state.name: str(state.light) for state in lamp.states}
            for lamp in known.leds
        }
        option.node.observers.append(self.look)
        drive.observers.append(self.look)
        self.look()

    def _add(self, item: str, title: str, kind: ChannelKind, word: str | None = None) -> int:
        bits = WORD_BITS if kind == "word" else 0
        path = f"devicenet.{self.name}.{item}"
        return self._log.add(
            Channel(path, title, kind, "devicenet", self.name, bits=bits, word=word)
        )

    def _fields(
        self, side: str, fields: Iterable[AssemblyField], known: DeviceNetGateway
    ) -> _Fields:
        found: _Fields = []
        for field in fields:
            word = None if field.word is None else f"{known.id}.{field.word}"
            kind: ChannelKind = "integer" if word is None else "word"
            found.append((self._add(f"{side}.{field.name}", field.title, kind, word), field))
        return found

    def look(self) -> None:
        """Note everything as it is now."""
        note, now_ns, option = self._log.note, self._kernel.now_ns, self._option
        node = option.node
        self.data_passed()
        connections = [(key, found.state) for key, found in node.connections.items()]
        seen = node.network, self._slave.state, connections, self._drive.tripped
        if seen == self._seen:
            return
        self._seen = seen
        note(self._online, now_ns, node.network is Network.ONLINE)
        note(self._exchanging, now_ns, self._slave.exchanging)
        note(self._network, now_ns, node.network.name.lower())
        note(self._scanned, now_ns, self._slave.state.name.lower())
        for instance, channel in self._connections.items():
            connection = node.connections.get(instance)
            state = ConnectionState.NON_EXISTENT if connection is None else connection.state
            note(channel, now_ns, state.name.lower())
        for light in option.lights:
            note(self._lamps[light.lamp], now_ns, self._lights[light.lamp][light.state])

    def data_passed(self) -> None:
        """Note the data, and the state that follows from them."""
        now_ns, pair = self._kernel.now_ns, self._option.assemblies.chosen
        outputs = self._option.assemblies.outputs(pair)
        if outputs != self._before:
            self._outputs_came(now_ns, outputs)
        inputs = self._slave.inputs
        if inputs is not self._came:
            self._came = inputs
            self._log.note(self._inputs, now_ns, inputs)
            for channel, field in self._in_fields if len(inputs) == self._pair.input.length else ():
                self._log.note(channel, now_ns, field_value(field, inputs))
        self._log.note(self._state, now_ns, self._option.state.name.lower())

    def _outputs_came(self, now_ns: int, outputs: bytes) -> None:
        """Note the outputs, each field with who wrote it."""
        note, first = self._log.note, self._entry.output_address
        length = self._pair.output.length
        same_size = len(outputs) == length
        before = self._before if len(self._before) == length else bytes(length)
        others = changed_bytes(before, outputs) if same_size else []
        for channel, field in self._out_fields if same_size else ():
            mine = [at for at in others if field.offset <= at < field.offset + field.length]
            writer = self._writer(first + mine[0]) if mine else None
            note(channel, now_ns, field_value(field, outputs), writer)
        note(self._outputs, now_ns, outputs, self._writer(first + others[0]) if others else None)
        self._before = outputs


def _frames(network: DeviceNet, catalog: Catalog) -> CanFrameWatch:
    entry = network.entry
    drives = tuple(
        ScannedDrive(
            *(item.name, item.mac, catalog.devicenet_gateway(item.type)),
            *(catalog.drive(item.series), network.options[item.name].assemblies.chosen),
        )
        for item in entry.drives
    )
    senders = {network.trunk: entry.name} | {port: name for name, port in network.drops.items()}
    return CanFrameWatch(network.bus, entry.name, senders, drives, entry.mac)
