"""Records a plant while it runs: hooks of the devices and of the scan, no polling.

Recording changes nothing of the run: it draws nothing from the random source, and what it puts
into the kernel's queue (a look at drives whose frequency moves) comes last at its instant.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING

from fbgen.catalog import Catalog
from fbgen.plant import PlantGateway, with_prefix
from fbgen.source import Span
from harness.engine.loading import engine_name
from harness.fieldbus import Station, Transfer
from harness.trace.cpu import CpuWatch
from harness.trace.devicenet import NetworkWatch
from harness.trace.devicenet_frames import CanFrameWatch
from harness.trace.drives import DriveWatch
from harness.trace.frame_meanings import FrameMeanings
from harness.trace.frames import FrameWatch
from harness.trace.gateways import GatewayWatch
from harness.trace.interfaces import InterfaceWatch
from harness.trace.log import ChangeLog
from harness.trace.marks import Marks
from harness.trace.meaning import telegram_meaning
from harness.trace.model import Channel, Telegram, Trace, TraceWord
from harness.trace.places import Places
from harness.trace.plc import PlcWatch
from harness.trace.serial_lines import SerialLineWatch
from harness.trace.telegrams import TelegramRecorder
from harness.trace.variables import variable_channels
from harness.trace.who_wrote import who_wrote
from harness.trace.words import trace_word

if TYPE_CHECKING:
    from harness.installation import Installation

_PLANT_DATA = "TOS_Plant"
"""The data block with the states of all drives, as fbgen names it."""


class Recorder:
    """Listens to a plant from now on. `marks` are for whoever drives it; `finish` gives the trace.

    `variables` are paths of the PLC, recorded with all that is below them, beside the data block
    TOS_Plant of the generated program.
    """

    def __init__(self, plant: "Installation", variables: Iterable[str] = ()) -> None:
        """Raises DiagnosticError FB6020 and FB6024 for variables that the PLC does not have."""
        self._plant = plant
        self.begin_ns = plant.kernel.now_ns
        self._log = ChangeLog()
        self._places = Places()
        self._who = who_wrote(plant.cpu, self._places)
        self.marks = Marks(plant.kernel, self._places)
        self._telegrams = plant.record_telegrams()
        self._cpu = CpuWatch(self._log, plant.kernel, plant.cpu)
        self._gateways = {
            entry.name: GatewayWatch(
                self._log,
                plant.kernel,
                plant.gateways[entry.name],
                plant.catalog.telegram_gateway(entry.type),
                plant.spacing[entry.name],
                writer=partial(self._output_writer, plant.stations[entry.name]),
            )
            for entry in plant.telegram_entries
        }
        self._interfaces = {
            entry.name: InterfaceWatch(
                self._log,
                plant.kernel,
                plant.interfaces[entry.name],
                plant.catalog.process_data_gateway(entry.type),
                writer=partial(self._output_writer, plant.stations[entry.name]),
            )
            for entry in plant.interface_entries
        }
        self._frames: list[FrameWatch | CanFrameWatch]
        self._frames = [_frame_watch(plant, entry) for entry in plant.telegram_entries]
        self._frames += [
            watch for entry in plant.interface_entries for watch in _cable_watches(plant, entry)
        ]
        self._serial = [SerialLineWatch(self._log, plant, entry) for entry in plant.plan.serial]
        self._networks = [
            NetworkWatch(
                *(self._log, plant.kernel, plant.catalog, network, plant.drives),
                writer=self._image_writer,
            )
            for network in plant.networks.values()
        ]
        self._frames += [watch.frames for watch in self._serial]
        self._frames += [watch.frames for watch in self._networks]
        for drive in plant.drives.values():
            DriveWatch(self._log, plant.kernel, drive)
        channels = _variables(plant, variables)
        self._plc = PlcWatch(self._log, plant.cpu.engine, channels, self.begin_ns, self._who)
        watches: dict[str, GatewayWatch | InterfaceWatch] = {**self._gateways, **self._interfaces}
        stations = {id(plant.stations[name]): watch for name, watch in watches.items()}
        plant.master.taps.append(partial(_to_gateway, stations))
        plant.cpu.after_scan.append(self._scanned)
        plant.cpu.on_mode.append(lambda _: self._look_at_scanners())
        plant.cpu.on_supply.append(lambda _: self._look_at_scanners())

    @property
    def now_ns(self) -> int:
        """The instant of the plant."""
        return self._plant.kernel.now_ns

    def _scanned(self) -> None:
        self._cpu.scanned()
        self._plc.look(self._plant.kernel.now_ns)
        for line in self._serial:
            line.look()

    def _look_at_scanners(self) -> None:
        for network in self._networks:
            network.look_at_scanner()

    def variables_written(self, by: Mapping[str, Span | None] = MappingProxyType({})) -> None:
        """Somebody has written variables of the PLC: its program, or who drives the plant.

        `by` has the places of the latter by the paths of the channels.
        """
        places = {
            with_prefix(path, self._plant.plan.prefix).casefold(): self._places.of(span)
            for path, span in by.items()
        }
        self._plc.look(self._plant.kernel.now_ns, places)

    def _output_writer(self, station: Station, offset: int) -> int | None:
        if self._who is None or self._plant.master.clearing or not station.exchanging:
            return None
        return self._who.output(station, offset)

    def _image_writer(self, address: int) -> int | None:
        return None if self._who is None else self._who.output_byte(address)

    def finish(self, title: str = "", scenario: str = "") -> Trace:
        """All that was recorded so far. Recording goes on."""
        plant = self._plant
        self.look()
        return Trace(
            title or plant.plan.name,
            scenario,
            plant.kernel.seed,
            engine_name(plant.cpu.engine),
            plant.plan.code_dialect,
            self._who is not None,
            self.begin_ns,
            plant.kernel.now_ns,
            _words(self._log.channels, plant.catalog),
            tuple(self._places.found),
            tuple(self._log.channels),
            tuple(self._log.changes),
            tuple(
                sorted(
                    (frame for watch in self._frames for frame in watch.frames),
                    key=lambda frame: frame.start_ns,
                )
            ),
            self._sent(),
            tuple(self.marks.found),
        )

    def look(self) -> None:
        """Note everything as it is now, whatever the hooks have told."""
        self._cpu.look()
        for gateway in self._gateways.values():
            gateway.look()
        for interface in self._interfaces.values():
            interface.look()
        for line in self._serial:
            line.look()
        for network in self._networks:
            network.look()

    def _sent(self) -> tuple[Telegram, ...]:
        catalog = self._plant.catalog
        triggers = {watch.trigger: name for name, watch in self._gateways.items()}
        writers = {
            (triggers[change.channel], change.time_ns): change.writer
            for change in self._log.changes
            if change.channel in triggers
        }
        found = [
            replace(telegram, writer=writers.get((telegram.gateway, telegram.sent_ns)))
            for entry in self._plant.telegram_entries
            for telegram in _telegrams_of(entry, self._telegrams[entry.name], catalog)
        ]
        return tuple(sorted(found, key=lambda telegram: telegram.sent_ns))


def _to_gateway(watches: dict[int, GatewayWatch | InterfaceWatch], transfer: Transfer) -> None:
    if (watch := watches.get(id(transfer.station))) is not None:
        watch.look()


def _frame_watch(plant: "Installation", entry: PlantGateway) -> FrameWatch:
    series = {item.inv_no: plant.catalog.drive(item.series) for item in entry.drives}
    ports = {plant.drives[item.name].communication.port: item.name for item in entry.drives}
    gateway = plant.gateways[entry.name].port
    meanings = FrameMeanings(series, plant.catalog)
    return FrameWatch(plant.lines[entry.name], entry.name, gateway, ports, meanings)


def _cable_watches(plant: "Installation", entry: PlantGateway) -> Iterable[FrameWatch]:
    """The cables of an interface, each with one drive that has no INV-NO there."""
    device = plant.interfaces[entry.name]
    for item in entry.drives:
        channel = (item.channel or "").lower()
        line, port = plant.lines[f"{entry.name}.{channel}"], device.channels[channel].link.port
        meanings = FrameMeanings({0: plant.catalog.drive(item.series)}, plant.catalog)
        drives = {plant.drives[item.name].communication.port: item.name}
        yield FrameWatch(line, entry.name, port, drives, meanings)


def _variables(plant: "Installation", more: Iterable[str]) -> list[Channel]:
    program = plant.cpu.engine.program
    names = [with_prefix(name, plant.plan.prefix) for name in (_PLANT_DATA, *more)]
    if names[0].casefold() not in (*program.globals, *program.lists):
        del names[0]
    channels: dict[str, Channel] = {}
    for name in names:
        for channel in variable_channels(program, name):
            channels.setdefault(channel.path.casefold(), channel)
    return list(channels.values())


def _words(channels: Iterable[Channel], catalog: Catalog) -> tuple[TraceWord, ...]:
    names = dict.fromkeys(channel.word for channel in channels if channel.word is not None)
    return tuple(trace_word(name, catalog.word(name)) for name in names)


def _telegrams_of(
    entry: PlantGateway, recorder: TelegramRecorder, catalog: Catalog
) -> Iterable[Telegram]:
    for record in recorder.records:
        addressed = [item for item in entry.drives if item.inv_no == record.output[3]]
        series = catalog.drive((addressed or entry.drives)[0].series)
        meaning = telegram_meaning(record.output, record.input, series, catalog)
        yield Telegram(
            *(record.sent_ns, entry.name, record.output),
            *(record.received_ns, record.input, meaning),
        )
