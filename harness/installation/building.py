"""From a plant file to a simulated installation.

Gateways, lines and inverters are those of `devices`; around them come the PLC and its DP master.
"""

from collections.abc import Collection, Iterable
from dataclasses import replace
from pathlib import Path

from fbgen.catalog import Catalog, TelegramGateway, load_catalog, with_own_sequences
from fbgen.diagnostics import DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.plant import Plant, PlantGateway, load_plant, place_of, plugged, with_prefix
from harness.engine.loading import engine_named, read_program
from harness.fieldbus import DpMaster, Parameters, Station, StationSettings, watchdog_factors
from harness.installation.conditions import without_effect
from harness.installation.devicenet import connect
from harness.installation.devices import FieldDevices, build_devices
from harness.installation.plant import Installation
from harness.installation.programs import generated_program, keep_loaded, numbers_in
from harness.installation.setup import PlantSetup
from harness.kernel import NS_PER_MS, Kernel
from harness.plc import Cpu, CpuFamily, CpuSettings, Mounting
from harness.plc.serial.adapter import SerialAdapter


def plant(path: str | Path, setup: PlantSetup | None = None) -> Installation:
    """The installation that a plant file describes, with the text that fbgen generates for it.

    Raises DiagnosticError as `load_plant`, `generate` and `build_plant`.
    """
    catalog = with_own_sequences(load_catalog(), Path(path).parent)
    return build_plant(load_plant(Path(path), catalog), catalog, setup or PlantSetup())


def build_plant(plan: Plant, catalog: Catalog, setup: PlantSetup) -> Installation:
    """The installation of a plant, switched off, with its program loaded.

    Raises DiagnosticError FB7501 for conditions of devices that the plant does not have, FB7502 for
    a gateway that cannot be simulated, FB7503 for conditions without effect, and whatever is wrong
    in the PLC text.
    """
    if plan.gateways:
        _one_master(plan)
    _all_known("drive", setup.drives, plan.series_of_drives, plan)
    effectless = [
        found
        for name, conditions in setup.drives.items()
        for found in without_effect(plan, name, conditions, {})
    ]
    if effectless:
        raise DiagnosticError(effectless)
    with_memory = [
        item.name
        for item in plan.gateways
        if isinstance(catalog.profibus_gateway(item.type), TelegramGateway)
    ]
    _all_known("gateway", setup.memories, with_memory, plan)
    kernel = Kernel(setup.seed)
    master = DpMaster(kernel, setup.bus)
    cpu = Cpu(kernel, _cpu_settings(plan, setup.cpu), master)
    cpu.services.leftovers = setup.leftovers
    devices = build_devices(plan, catalog, kernel, setup.drives)
    stations: dict[str, Station] = {}
    for entry in plan.gateways:
        chosen = plugged(entry, catalog.profibus_gateway(entry.type))
        parameters = b"" if chosen is None else chosen.user_parameters
        station = stations[entry.name] = _station(master, entry, devices, setup, parameters)
        by_image = entry.access == "process_image"
        identifier, diagnosis = entry.hardware_identifier, entry.diagnosis_address
        cpu.mount(Mounting(station, by_image, identifier, diagnosis))
    for index, line in enumerate(plan.serial, start=1):
        place = place_of(line, plan)
        module = devices.modules[line.name]
        cpu.serial_ports.plug(-index if place is None else place, module)
        if place is None:
            path = with_prefix(f"TIP_Adapters.{line.name}", plan.prefix)
            adapter = SerialAdapter(kernel, module, lambda: cpu.engine, path)
            cpu.after_scan.append(adapter.exchange)
    for network in devices.networks.values():
        connect(cpu, network)
    if setup.program is not None:
        program = setup.program
    elif setup.sources is None:
        program = generated_program(plan, catalog)
    else:
        program = read_program(setup.sources, plan.code_dialect, numbers_in(plan))
    load = setup.factory or engine_named(setup.engine, setup.probes)
    cpu.load(program, load)
    keep_loaded(program)
    return Installation(
        *(plan, catalog, kernel, cpu, master, devices, stations),
        memories=setup.memories,
        start_after_ns=setup.start_after_ns,
    )


def _cpu_settings(plan: Plant, times: CpuSettings) -> CpuSettings:
    addresses = [
        address or 0
        for entry in plan.gateways
        for address in (entry.input_address, entry.output_address)
    ]
    addresses += [
        address
        for item in plan.devicenet_drives
        for address in (item.input_address, item.output_address)
    ]
    addresses += [network.active_address or 0 for network in plan.devicenet]
    last = max(addresses, default=0) + 0xFF
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


def _station(
    master: DpMaster,
    entry: PlantGateway,
    devices: FieldDevices,
    setup: PlantSetup,
    user_parameters: bytes,
) -> Station:
    slave = devices.slave(entry.name)
    factors = None if setup.watchdog_ns is None else watchdog_factors(setup.watchdog_ns)
    settings = StationSettings(
        entry.name,
        entry.profibus_address,
        slave.type.configuration,
        Parameters(slave.type.ident_number, factors, user_data=user_parameters),
        entry.output_address or 0,
        entry.input_address or 0,
    )
    return master.add(settings, slave)


def _all_known(kind: str, names: Iterable[str], known: Collection[str], plan: Plant) -> None:
    for name in names:
        if name not in known:
            raise error(
                "FB7501",
                f"there is no {kind} '{name}' in the plant '{plan.name}' to set conditions for",
                None,
                nearest(name, known),
            )
