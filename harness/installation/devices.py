"""The devices of a plant without PLC and master: gateways, their lines, their inverters.

The inverters are set as the TOSPBDP001 manual v1.1, section 6, says: 19200 bit/s (F800 = 4), even
parity (F801 = 1), INV-NO (F802), communication timeout 1 s (F803 = 1); FH is the plant file's.
Those at a PBDP-110 have FH and the highest speed, as its manual advises (3), and nothing else.
"""

from collections.abc import Mapping
from dataclasses import replace

from fbgen.blocks.serial_times import serial_times
from fbgen.catalog import Catalog, Drive, OptionValue, ProcessDataGateway
from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.plant import (
    DeviceNetDrive,
    Plant,
    PlantDrive,
    PlantGateway,
    layout_of,
    plugged,
)
from harness.drives import Inverter, InverterSettings, ReplyTime, set_for_line
from harness.drives.settings import TimeoutRestart
from harness.fieldbus import DpSlave
from harness.gateways.pbdp110 import Pbdp110, drive_facts, pbdp110_settings
from harness.gateways.tospbdp001 import Tospbdp001, tospbdp001_settings
from harness.installation.devicenet import DeviceNet, network_of
from harness.installation.serial_lines import line_of, module_of, on_serial_line, port_at
from harness.installation.setup import DriveConditions
from harness.kernel import Kernel
from harness.line import Line, Spacing, Topology
from harness.plc.serial import SerialModule

_BAUD_RATE = 19_200
TIMEOUT_S = 1


@dataclass(frozen=True, slots=True)
class FieldDevices:
    """Gateways, lines and spacing go by the gateway's name, drives by their own.

    `modules` are the communication modules of the PLC, by the names of their serial lines; `lines`
    has these too. `gateways` are those for telegrams, each with one line; `interfaces` those for
    process data, whose lines go by the gateway's name and the channel's, as `gw1.a`. `networks`
    are those of DeviceNet, by their names.
    """

    gateways: Mapping[str, Tospbdp001]
    interfaces: Mapping[str, Pbdp110]
    lines: Mapping[str, Line]
    drives: Mapping[str, Inverter]
    spacing: Mapping[str, Spacing]
    modules: Mapping[str, SerialModule]
    networks: Mapping[str, DeviceNet]

    def device(self, name: str) -> Tospbdp001 | Pbdp110:
        """The gateway of a name, of whatever kind."""
        return self.gateways[name] if name in self.gateways else self.interfaces[name]

    def slave(self, name: str) -> DpSlave:
        """The PROFIBUS side of a gateway."""
        return self.device(name).slave


def build_devices(
    plan: Plant, catalog: Catalog, kernel: Kernel, conditions: Mapping[str, DriveConditions]
) -> FieldDevices:
    """The devices of a plant; gateways are switched off, drives have their supply.

    `conditions` go by the drive's name. Raises DiagnosticError FB7502 for a gateway that cannot be
    simulated.
    """
    lines: dict[str, Line] = {}
    gateways: dict[str, Tospbdp001] = {}
    interfaces: dict[str, Pbdp110] = {}
    drives: dict[str, Inverter] = {}
    spacing: dict[str, Spacing] = {}
    for entry in plan.gateways:
        known = catalog.gateways[entry.type]
        if isinstance(known, ProcessDataGateway):
            interface = _interface(kernel, catalog, known, entry)
            interfaces[entry.name] = interface.device
            lines |= {f"{entry.name}.{name}": line for name, line in interface.lines.items()}
            drives |= _drives_at(interface, catalog, entry, conditions)
            continue
        line = lines[entry.name] = Line(kernel, _topology(catalog, entry))
        gateway = gateways[entry.name] = _gateway(kernel, catalog, entry, line)
        reply_ns = {
            item.inv_no: catalog.drive(item.series).times.reply_max.ns for item in entry.drives
        }
        spacing[entry.name] = Spacing(line, gateway.port, reply_ns)
        for item in entry.drives:
            own = conditions.get(item.name, DriveConditions())
            series = catalog.drive(item.series)
            own = replace(own, parameters={**_on_a_line(series, item, own.port), **own.parameters})
            drives[item.name] = _drive(kernel, series, item, line, own)
    modules: dict[str, SerialModule] = {}
    for serial in plan.serial:
        line = lines[serial.name] = line_of(kernel, serial)
        modules[serial.name] = module_of(kernel, plan, serial, line)
        heard_s = serial_times(plan, serial, catalog).drive_timeout_s
        for item in serial.drives:
            series = catalog.drive(item.series)
            port = port_at(serial, series)
            own = conditions.get(item.name, DriveConditions())
            as_set = on_serial_line(serial, item, series, port, heard_s)
            own = replace(own, parameters={**as_set, **own.parameters}, port=port.name)
            drives[item.name] = _drive(kernel, series, item, line, own)
    networks: dict[str, DeviceNet] = {}
    for network in plan.devicenet:
        for member in network.drives:
            series = catalog.drive(member.series)
            own = conditions.get(member.name, DriveConditions())
            drives[member.name] = _drive(kernel, series, member, Line(kernel), own)
        networks[network.name] = network_of(kernel, catalog, network, drives)
    return FieldDevices(gateways, interfaces, lines, drives, spacing, modules, networks)


@dataclass(frozen=True, slots=True)
class _Interface:
    """An interface for process data with the cables to its drives, by the names of channels."""

    kernel: Kernel
    device: Pbdp110
    lines: Mapping[str, Line]


def _interface(
    kernel: Kernel, catalog: Catalog, known: ProcessDataGateway, entry: PlantGateway
) -> _Interface:
    if entry.type != "pbdp110":
        raise _not_simulated(entry)
    facts = {_channel(item): drive_facts(catalog.drive(item.series)) for item in entry.drives}
    settings = pbdp110_settings(known, layout_of(entry, known), entry.options, facts)
    if (chosen := plugged(entry, known)) is not None:
        codes = {
            (module.output_length, module.input_length): module.code
            for module in (*chosen.station.modules, *chosen.modules)
        }
        settings = replace(
            settings,
            modules=tuple(
                replace(
                    one,
                    configuration=codes.get(
                        (one.output_length, one.input_length), one.configuration
                    ),
                )
                for one in settings.modules
            ),
            ident_number=chosen.station.ident_number,
            user_parameter_bytes=len(chosen.user_parameters),
        )
    lines = {channel.name: Line(kernel) for channel in known.channels}
    device = Pbdp110(kernel, settings, lines, entry.profibus_address, entry.name)
    device.power_off()
    return _Interface(kernel, device, lines)


def _drives_at(
    interface: _Interface,
    catalog: Catalog,
    entry: PlantGateway,
    conditions: Mapping[str, DriveConditions],
) -> dict[str, Inverter]:
    """The drives at the channels of an interface, which lives on what they give."""
    drives = {}
    for item in entry.drives:
        series, channel = catalog.drive(item.series), _channel(item)
        own = conditions.get(item.name, DriveConditions())
        fastest = set_for_line(series, own.port, _BAUD_RATE, "even")
        parameters = {**fastest, **own.parameters}
        own = replace(own, parameters=parameters)
        drive = _drive(interface.kernel, series, item, interface.lines[channel], own)
        _give_supply(interface.device, channel, drive)
        drives[item.name] = drive
    return drives


def _give_supply(device: Pbdp110, channel: str, drive: Inverter) -> None:
    def follow() -> None:
        device.supply(channel, drive.powered)

    drive.observers.append(follow)
    follow()


def _channel(item: PlantDrive) -> str:
    assert item.channel is not None, "checked when the plant was read"
    return item.channel.lower()


def _topology(catalog: Catalog, entry: PlantGateway) -> Topology:
    wires = catalog.telegram_gateway(entry.type).subnetwork.wires
    return Topology.FOUR_WIRE if wires == 4 else Topology.TWO_WIRE


def _gateway(kernel: Kernel, catalog: Catalog, entry: PlantGateway, line: Line) -> Tospbdp001:
    if entry.type != "tospbdp001":
        raise _not_simulated(entry)
    known = catalog.telegram_gateway(entry.type)
    settings = tospbdp001_settings(known, layout_of(entry, known), entry.options)
    if (chosen := plugged(entry, known)) is not None:
        settings = replace(
            settings,
            ident_number=chosen.station.ident_number,
            user_parameter_bytes=len(chosen.user_parameters),
        )
    return Tospbdp001(kernel, settings, line, entry.profibus_address, entry.name)


def _not_simulated(entry: PlantGateway) -> DiagnosticError:
    return error(
        "FB7502",
        f"the gateway '{entry.name}' is a {entry.type}, which cannot be simulated",
        entry.span_of("type"),
        "the harness has the tospbdp001 and the pbdp110",
    )


def _on_a_line(series: Drive, entry: PlantDrive, port: str | None) -> Mapping[str, float]:
    """What the manual of the TOSPBDP001 has one set at an inverter."""
    return {
        **set_for_line(series, port, _BAUD_RATE, "even"),
        series.link.inv_no: entry.inv_no,
        series.link.timeout: TIMEOUT_S,
    }


def _drive(
    kernel: Kernel,
    series: Drive,
    entry: PlantDrive | DeviceNetDrive,
    line: Line,
    conditions: DriveConditions,
) -> Inverter:
    parameters: Mapping[str, float] = {
        series.link.maximum_frequency: entry.max_frequency_hz,
        **conditions.parameters,
    }
    options = {item.id: entry.options.get(item.id, item.default) for item in series.options}
    settings = _with_options(InverterSettings(name=entry.name, parameters=parameters), options)
    settings = replace(settings, port=conditions.port)
    if conditions.load is not None:
        settings = replace(settings, load=conditions.load)
    if conditions.reply_time_ns is not None:
        fixed = ReplyTime(conditions.reply_time_ns, conditions.reply_time_ns)
        settings = replace(settings, reply_time=fixed)
    return Inverter(kernel, line, series, settings)


def _with_options(
    settings: InverterSettings, options: Mapping[str, OptionValue]
) -> InverterSettings:
    restart: TimeoutRestart = (
        "writes" if options.get("timeout_restart") == "writes" else "any_answered"
    )
    return replace(
        settings,
        timeout_restart=restart,
        options=frozenset(name for name, value in options.items() if value is True),
    )
