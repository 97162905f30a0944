"""The DeviceNet networks of a plant: cable, scanner, and the options in its inverters."""

from collections.abc import Mapping

from fbgen.catalog import Catalog, DeviceNetGateway
from fbgen.dataclass import dataclass
from fbgen.plant import DeviceNetConnection, DeviceNetDrive, DeviceNetNetwork, assemblies_of
from fbgen.wire.devicenet import Choice, Frame
from harness.drives import Inverter
from harness.fieldbus.devicenet import CanBus, CanPort, NodeWithMac, ScanEntry, Scanner
from harness.gateways.dev003z import Dev003z, Dev003zSettings
from harness.kernel import NS_PER_MS, Kernel
from harness.plc import Cpu
from harness.plc.devicenet_scanner import ImagePlace, plug_scanner

_CHOICES: Mapping[DeviceNetConnection, Choice] = {
    "polled": Choice.POLLED,
    "change_of_state": Choice.POLLED | Choice.CHANGE_OF_STATE,
    "cyclic": Choice.POLLED | Choice.CYCLIC,
}


@dataclass(frozen=True, slots=True)
class DeviceNet:
    """One network. `trunk` is where the scanner hangs on it. By the names of the drives go
    `options`, `drops`, where these hang on it, and `strangers`: nodes with the same MAC IDs, which
    are not plugged."""

    entry: DeviceNetNetwork
    bus: CanBus
    scanner: Scanner
    trunk: CanPort
    options: Mapping[str, Dev003z]
    drops: Mapping[str, CanPort]
    strangers: Mapping[str, NodeWithMac]


def network_of(
    kernel: Kernel, catalog: Catalog, entry: DeviceNetNetwork, drives: Mapping[str, Inverter]
) -> DeviceNet:
    """The network with its options on; the scanner is off."""
    bus = CanBus(kernel, entry.rate * 1000)
    options: dict[str, Dev003z] = {}
    drops: dict[str, CanPort] = {}
    for item in entry.drives:
        known, settings = catalog.devicenet_gateway(item.type), _settings(catalog, entry, item)
        option, drop = _option(known, settings, drives[item.name], kernel, bus)
        options[item.name], drops[item.name] = option, drop

    def send(frame: Frame) -> None:
        trunk.send(frame)

    entries = [_scanned(item, catalog) for item in entry.drives]
    scanner = Scanner(kernel, send, entries, entry.mac, entry.scan_ms * NS_PER_MS)
    trunk = bus.attach(scanner.receive)
    strangers = {item.name: NodeWithMac(bus, item.mac) for item in entry.drives}
    return DeviceNet(entry, bus, scanner, trunk, options, drops, strangers)


def connect(cpu: Cpu, network: DeviceNet) -> None:
    """Put the scanner beside the CPU. Raises DiagnosticError FB7402 for addresses."""
    entry = network.entry
    table = None
    if entry.active_address is not None:
        table = ImagePlace(entry.name, entry.active_address)
    places = {
        item.mac: ImagePlace(item.name, item.input_address, item.output_address)
        for item in entry.drives
    }
    plug_scanner(cpu, network.scanner, places, table)


def _settings(catalog: Catalog, network: DeviceNetNetwork, item: DeviceNetDrive) -> Dev003zSettings:
    known = catalog.devicenet_gateway(item.type)
    pair = assemblies_of(item, known)
    assert pair is not None, "checked when the plant was read"
    rates = {rate: code for code, rate in known.devicenet.baud_rates.items()}
    own = {option.id for option in known.options}
    return Dev003zSettings(
        item.series,
        item.mac,
        rates[network.rate],
        {**item.settings, known.assembly_parameter: pair.setting},
        {name: value for name, value in item.options.items() if name in own},
    )


def _option(
    known: DeviceNetGateway, settings: Dev003zSettings, drive: Inverter, kernel: Kernel, bus: CanBus
) -> tuple[Dev003z, CanPort]:
    def send(frame: Frame) -> None:
        drop.send(frame)

    option = Dev003z(kernel, known, drive, send, settings)
    drop = bus.attach(option.receive)
    return option, drop


def _scanned(item: DeviceNetDrive, catalog: Catalog) -> ScanEntry:
    pair = assemblies_of(item, catalog.devicenet_gateway(item.type))
    assert pair is not None, "checked when the plant was read"
    choice = _CHOICES[item.connection]
    lengths = pair.output.length, pair.input.length
    return ScanEntry(item.mac, *lengths, choice, item.packet_rate_ms)
