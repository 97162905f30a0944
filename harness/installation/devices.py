"""The devices of a plant without PLC and master: gateways, their lines, their inverters.

The inverters are set as the TOSPBDP001 manual v1.1, section 6, says: 19200 bit/s (F800 = 4), even
parity (F801 = 1), INV-NO (F802), communication timeout 1 s (F803 = 1); FH is the plant file's.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from fbgen.catalog import Catalog, Drive, OptionValue
from fbgen.diagnostics import error
from fbgen.plant import Plant, PlantDrive, PlantGateway
from harness.drives import Inverter, InverterSettings, ReplyTime
from harness.drives.settings import TimeoutRestart
from harness.gateways.tospbdp001 import Tospbdp001, tospbdp001_settings
from harness.installation.setup import DriveConditions
from harness.kernel import Kernel
from harness.line import Line, Spacing, Topology

BAUD_RATE_19200 = 4
PARITY_EVEN = 1
TIMEOUT_S = 1


@dataclass(frozen=True, slots=True)
class FieldDevices:
    """Gateways, lines and spacing go by the gateway's name, drives by their own."""

    gateways: Mapping[str, Tospbdp001]
    lines: Mapping[str, Line]
    drives: Mapping[str, Inverter]
    spacing: Mapping[str, Spacing]


def build_devices(
    plan: Plant, catalog: Catalog, kernel: Kernel, conditions: Mapping[str, DriveConditions]
) -> FieldDevices:
    """The devices of a plant; gateways are switched off, drives have their supply.

    `conditions` go by the drive's name. Raises DiagnosticError FB7502 for a gateway that cannot be
    simulated.
    """
    lines: dict[str, Line] = {}
    gateways: dict[str, Tospbdp001] = {}
    drives: dict[str, Inverter] = {}
    spacing: dict[str, Spacing] = {}
    for entry in plan.gateways:
        line = lines[entry.name] = Line(kernel, _topology(catalog, entry))
        gateway = gateways[entry.name] = _gateway(kernel, catalog, entry, line)
        reply_ns = {
            item.inv_no: catalog.drive(item.series).times.reply_max.ns for item in entry.drives
        }
        spacing[entry.name] = Spacing(line, gateway.port, reply_ns)
        for item in entry.drives:
            own = conditions.get(item.name, DriveConditions())
            drives[item.name] = _drive(kernel, catalog.drive(item.series), item, line, own)
    return FieldDevices(gateways, lines, drives, spacing)


def _topology(catalog: Catalog, entry: PlantGateway) -> Topology:
    wires = catalog.telegram_gateway(entry.type).subnetwork.wires
    return Topology.FOUR_WIRE if wires == 4 else Topology.TWO_WIRE


def _gateway(kernel: Kernel, catalog: Catalog, entry: PlantGateway, line: Line) -> Tospbdp001:
    if entry.type != "tospbdp001":
        raise error(
            "FB7502",
            f"the gateway '{entry.name}' is a {entry.type}, which cannot be simulated",
            entry.span_of("type"),
            "the harness has the tospbdp001",
        )
    known = catalog.telegram_gateway(entry.type)
    settings = tospbdp001_settings(known, known.layout(entry.layout), entry.options)
    return Tospbdp001(kernel, settings, line, entry.profibus_address, entry.name)


def _drive(
    kernel: Kernel, series: Drive, entry: PlantDrive, line: Line, conditions: DriveConditions
) -> Inverter:
    link = series.link
    parameters: Mapping[str, float] = {
        "baud_rate": BAUD_RATE_19200,
        "parity": PARITY_EVEN,
        link.inv_no: entry.inv_no,
        link.timeout: TIMEOUT_S,
        link.maximum_frequency: entry.max_frequency_hz,
        **conditions.parameters,
    }
    options = {item.id: item.default for item in series.options} | dict(entry.options)
    settings = _with_options(InverterSettings(name=entry.name, parameters=parameters), options)
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
        broadcast_reads=bool(options.get("broadcast_reads", False)),
    )
