"""Looks on at a plant for catalogue coverage: words, ComNos, trips, RET_VALs.

Telegrams are those on the lines and cables, as the drives hear and answer them; a gateway's own
heartbeats, in ASCII, belong to no test. Serial lines and DeviceNet have modules of their own.
"""

from collections.abc import Mapping

from fbgen.catalog import Catalog, Drive, TelegramGateway
from fbgen.lang.types import Scalar
from fbgen.plant import layout_of
from fbgen.source import Span
from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import Address, Reply, Request
from harness.engine.environment import Area
from harness.fieldbus import DpMaster, Station, Transfer
from harness.installation import Installation
from harness.line import Line, Port, Transmission
from harness.plc.consistent_data import RetVal
from harness.plc.hardware_access import Instruction
from harness.verify.coverage.catalogue import (
    GATEWAY_WORDS,
    READ,
    READ_RESULTS,
    READ_WORDS,
    TRIPS,
    WRITE_RESULTS,
    WRITTEN,
    WRITTEN_WORDS,
    CatalogueCoverage,
)
from harness.verify.coverage.comnos import know_comnos, see_comno
from harness.verify.coverage.devicenet_watch import watch_devicenet
from harness.verify.coverage.interface_watch import InterfaceWatch
from harness.verify.coverage.left_out import NEVER_READ, NEVER_WRITTEN, UNUSED
from harness.verify.coverage.serial_watch import SerialLineWatch
from harness.verify.coverage.word_items import values_in, values_of

_INSTRUCTIONS = {
    "DPRD_DAT": READ_RESULTS,
    "SFC14": READ_RESULTS,
    "DPWR_DAT": WRITE_RESULTS,
    "SFC15": WRITE_RESULTS,
}
_NEVER_GIVEN = {READ_RESULTS: NEVER_READ, WRITE_RESULTS: NEVER_WRITTEN}


def watch(plant: Installation, coverage: CatalogueCoverage) -> None:
    """Look on at a plant from now on."""
    for entry in plant.telegram_entries:
        gateway = plant.gateways[entry.name]
        known = plant.catalog.telegram_gateway(entry.type)
        control_at = gateway.settings.layout.control_offset
        _GatewayWatch(coverage, plant.master, known, plant.stations[entry.name], control_at)
        series = {one.inv_no: plant.catalog.drive(one.series) for one in entry.drives}
        if series:
            writing = _writing(plant.catalog, known.protocol)
            _LineWatch(coverage, plant.lines[entry.name], gateway.port, series, writing)
    _watch_interfaces(plant, coverage)
    for line in plant.plan.serial:
        SerialLineWatch(plant, coverage, line)
    watch_devicenet(plant, coverage)
    _watch_trips(plant, coverage)
    _watch_instructions(plant, coverage)


def _watch_interfaces(plant: Installation, coverage: CatalogueCoverage) -> None:
    for entry in plant.interface_entries:
        known = plant.catalog.process_data_gateway(entry.type)
        device, station = plant.interfaces[entry.name], plant.stations[entry.name]
        watching = InterfaceWatch(coverage, known, layout_of(entry, known), device, station)
        plant.master.taps.append(watching.transferred)
        writing = _writing(plant.catalog, known.protocol)
        for one in entry.drives:
            channel = (one.channel or "").lower()
            line, port = plant.lines[f"{entry.name}.{channel}"], device.channels[channel].link.port
            _LineWatch(coverage, line, port, {0: plant.catalog.drive(one.series)}, writing)


def _writing(catalog: Catalog, protocol: str) -> set[int]:
    """The commands of a protocol that write."""
    return {
        command.code for command in catalog.toshiba_protocol(protocol).commands if command.writes
    }


class _GatewayWatch:
    """The control word that the master sends and the status word that it gets."""

    __slots__ = ("_control", "_control_at", "_coverage", "_known", "_last", "_station", "_status")

    def __init__(
        self,
        coverage: CatalogueCoverage,
        master: DpMaster,
        known: TelegramGateway,
        station: Station,
        control_at: int,
    ) -> None:
        self._coverage = coverage
        self._station = station
        self._known = known
        self._control, self._status = known.control, known.status_word
        self._control_at = control_at
        self._last = b"", b""
        for word in (self._control, self._status):
            items = values_of(f"{known.id}.{word.name}", word)
            coverage.know(GATEWAY_WORDS, (item for item in items if item not in UNUSED))
        master.taps.append(self._transferred)

    def _transferred(self, transfer: Transfer) -> None:
        if transfer.station is not self._station:
            return
        outputs, inputs = transfer.outputs, transfer.inputs
        last = outputs[self._control_at : self._control_at + 2], inputs[:2]
        if last == self._last:
            return
        self._last = last
        for word, data in zip((self._control, self._status), last, strict=True):
            for item in values_in(
                f"{self._known.id}.{word.name}", word, int.from_bytes(data, "big")
            ):
                self._coverage.see(GATEWAY_WORDS, item)


class _LineWatch:
    """Requests of the gateway and replies of its drives; the same bytes are looked at only once."""

    __slots__ = ("_coverage", "_first", "_gateway", "_series", "_told", "_writing")

    def __init__(
        self,
        coverage: CatalogueCoverage,
        line: Line,
        gateway: Port,
        series: Mapping[int, Drive],
        writing: set[int],
    ) -> None:
        """`series` are the drives by INV-NO, `writing` the commands that write. A telegram without
        INV-NO belongs to the first one."""
        self._coverage = coverage
        self._gateway = gateway
        self._series = series
        self._first = next(iter(series.values()))
        self._writing = writing
        self._told: set[bytes] = set()
        for drive in series.values():
            know_comnos(coverage, drive)
        line.taps.append(self._heard)

    def _heard(self, transmission: Transmission) -> None:
        data = transmission.data
        if data in self._told:
            return
        self._told.add(data)
        if transmission.sender is self._gateway:
            request = toshiba_binary.parse_request(data)
            if isinstance(request, Request) and request.command in self._writing:
                self._tell(WRITTEN, WRITTEN_WORDS, request.address, request.com_no, request.data)
        elif transmission.sender is not None:
            reply = toshiba_binary.parse_reply(data)
            if isinstance(reply, Reply) and reply.command not in self._writing:
                self._tell(READ, READ_WORDS, reply.address, reply.com_no, reply.data)

    def _tell(self, group: str, words: str, address: Address, number: int, data: int) -> None:
        drive = self._first
        if isinstance(address, int):
            drive = self._series.get(address, drive)
        see_comno(self._coverage, (group, words), drive, number, data)


def _watch_trips(plant: Installation, coverage: CatalogueCoverage) -> None:
    names: dict[str, dict[int, str]] = {}
    for drive in plant.drives.values():
        series = drive.series
        known = {one.code: f"{series.id} {one.display} ({one.code:02X})" for one in series.trips}
        known.pop(0, None)
        coverage.know(TRIPS, known.values())
        names[series.id] = known

    def look() -> None:
        for drive in plant.drives.values():
            if drive.tripped:
                coverage.see(TRIPS, names[drive.series.id].get(drive.trip_code, ""))

    plant.cpu.after_scan.append(look)


def _watch_instructions(plant: Installation, coverage: CatalogueCoverage) -> None:
    """Note what the instructions give to the program; only to one that calls them."""
    for name, instruction in list(plant.cpu.instructions.items()):
        if name in _INSTRUCTIONS:
            plant.cpu.instructions[name] = _noting(coverage, _INSTRUCTIONS[name], instruction)


def _noting(coverage: CatalogueCoverage, group: str, instruction: Instruction) -> Instruction:
    names = {
        int(one): f"16#{one:04X} {one.name.lower().replace('_', ' ')}"
        for one in RetVal
        if one not in _NEVER_GIVEN[group]
    }

    def noted(arguments: "Mapping[str, Scalar | Area]", span: Span) -> Scalar:
        ret_val = instruction(arguments, span)
        assert isinstance(ret_val, int), "RET_VAL is an INT"
        coverage.know(group, names.values())
        coverage.see(group, names.get(ret_val & 0xFFFF, ""))
        return ret_val

    return noted
