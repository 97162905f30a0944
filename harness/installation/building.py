"""From a plant file to a simulated installation.

The inverters are set as the TOSPBDP001 manual v1.1, section 6, says: 19200 bit/s (F800 = 4), even
parity (F801 = 1), INV-NO (F802), communication timeout 1 s (F803 = 1); FH is the plant file's.
"""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from fbgen.catalog import Catalog, Drive, OptionValue, load_catalog, with_own_sequences
from fbgen.diagnostics import error
from fbgen.nearest import nearest
from fbgen.plant import Plant, PlantDrive, PlantGateway, load_plant, with_prefix
from harness.drives import Inverter, InverterSettings, ReplyTime
from harness.drives.settings import TimeoutRestart
from harness.engine.loading import engine_named, read_program
from harness.fieldbus import DpMaster, Parameters, Station, StationSettings, watchdog_factors
from harness.gateways.tospbdp001 import Tospbdp001, tospbdp001_settings
from harness.installation.plant import Installation
from harness.installation.programs import generated_program
from harness.installation.setup import DriveConditions, PlantSetup
from harness.kernel import NS_PER_MS, Kernel
from harness.line import Line, Spacing, Topology
from harness.plc import Cpu, CpuFamily, CpuSettings, Mounting

BAUD_RATE_19200 = 4
PARITY_EVEN = 1
TIMEOUT_S = 1


def plant(path: str | Path, setup: PlantSetup | None = None) -> Installation:
    """The installation that a plant file describes, with the text that fbgen generates for it.

    Raises DiagnosticError as `load_plant`, `generate` and `build_plant`.
    """
    catalog = with_own_sequences(load_catalog(), Path(path).parent)
    return build_plant(load_plant(Path(path), catalog), catalog, setup or PlantSetup())


def build_plant(plan: Plant, catalog: Catalog, setup: PlantSetup) -> Installation:
    """The installation of a plant, switched off, with its program loaded.

    Raises DiagnosticError FB7501 for conditions of devices that the plant does not have, FB7502 for
    a gateway that cannot be simulated, and whatever is wrong in the PLC text.
    """
    _one_master(plan)
    _all_known("drive", setup.drives, [item.name for item in plan.drives], plan)
    _all_known("gateway", setup.memories, [item.name for item in plan.gateways], plan)
    kernel = Kernel(setup.seed)
    master = DpMaster(kernel, setup.bus)
    cpu = Cpu(kernel, _cpu_settings(plan, setup.cpu), master)
    lines: dict[str, Line] = {}
    gateways: dict[str, Tospbdp001] = {}
    stations: dict[str, Station] = {}
    drives: dict[str, Inverter] = {}
    spacing: dict[str, Spacing] = {}
    for entry in plan.gateways:
        line = lines[entry.name] = Line(kernel, _topology(catalog, entry))
        gateway = gateways[entry.name] = _gateway(kernel, catalog, entry, line)
        station = stations[entry.name] = _station(master, entry, gateway, setup)
        reply_ns = {
            item.inv_no: catalog.drive(item.series).times.reply_max.ns for item in entry.drives
        }
        spacing[entry.name] = Spacing(line, gateway.port, reply_ns)
        by_image = entry.access == "process_image"
        cpu.mount(Mounting(station, by_image, entry.hardware_identifier))
        for item in entry.drives:
            conditions = setup.drives.get(item.name, DriveConditions())
            drives[item.name] = _drive(kernel, catalog.drive(item.series), item, line, conditions)
    if setup.program is not None:
        program = setup.program
    elif setup.sources is None:
        program = generated_program(plan, catalog)
    else:
        program = read_program(setup.sources, plan.code_dialect)
    load = setup.factory or engine_named(setup.engine, setup.probes)
    cpu.load(program, load)
    return Installation(
        *(plan, catalog, kernel, cpu, master, gateways, stations, lines, drives, spacing),
        memories=setup.memories,
        start_after_ns=setup.start_after_ns,
    )


def _cpu_settings(plan: Plant, times: CpuSettings) -> CpuSettings:
    last = max(
        (address or 0) + 0xFF
        for entry in plan.gateways
        for address in (entry.input_address, entry.output_address)
    )
    return replace(
        times,
        family=CpuFamily(plan.plc),
        cycle_ns=round(plan.cycle_time_ms * NS_PER_MS),
        memory_bytes=max(times.memory_bytes, last + 1),
        obs=replace(
            times.obs,
            main_function=with_prefix("TOS_Main", plan.prefix),
            restart_function=with_prefix("TOS_Restart", plan.prefix),
        ),
    )


def _one_master(plan: Plant) -> None:
    first = plan.gateways[0]
    for entry in plan.gateways:
        if entry.dp_master != first.dp_master:
            raise error(
                "FB7502",
                f"the gateway '{entry.name}' belongs to DP master system {entry.dp_master}, "
                f"'{first.name}' to {first.dp_master}",
                entry.span_of("dp_master"),
                "the harness has one master: simulate the gateways of each in a plant of their own",
            )


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


def _station(
    master: DpMaster, entry: PlantGateway, gateway: Tospbdp001, setup: PlantSetup
) -> Station:
    factors = None if setup.watchdog_ns is None else watchdog_factors(setup.watchdog_ns)
    settings = StationSettings(
        entry.name,
        entry.profibus_address,
        gateway.settings.layout.configuration,
        Parameters(gateway.settings.ident_number, factors),
        entry.output_address or 0,
        entry.input_address or 0,
    )
    return master.add(settings, gateway.slave)


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


def _all_known(kind: str, names: Iterable[str], known: Collection[str], plan: Plant) -> None:
    for name in names:
        if name not in known:
            raise error(
                "FB7501",
                f"there is no {kind} '{name}' in the plant '{plan.name}' to set conditions for",
                None,
                nearest(name, known),
            )
