"""A plant for faults: five drives behind one gateway, and everything that faults may change."""

from collections.abc import Mapping

from fbgen.catalog import load_catalog
from fbgen.plant import Plant, load_plant
from harness.drives import Inverter
from harness.faults import FAULTS, Fault, Target
from harness.faults.settings import fault_settings
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_S
from harness.line import Pair
from tests.unit.scenario.scenario_files import ROOT

FIVE = ROOT / "examples" / "five_drives" / "plant.yaml"
POLLED = "TOS_Plant.gw1.{drive}.polled.{what}"


def five_drives() -> Plant:
    """The plan of the plant."""
    return load_plant(FIVE, load_catalog())


def started(plan: Plant, seed: int = 1) -> Installation:
    """The plant one second after the start."""
    installation = build_plant(plan, load_catalog(), PlantSetup(seed=seed))
    installation.start()
    installation.run_for(NS_PER_S)
    return installation


def fault(
    plant: Installation, name: str, settings: Mapping[str, float | str] | None = None
) -> Fault:
    """A fault as a scenario makes it, at gw1 or at drive3."""
    kind = FAULTS[name]
    on = {
        Target.WHOLE: "",
        Target.GATEWAY: "gw1",
        Target.TELEGRAMS: "gw1",
        Target.LINE: "gw1",
        Target.DRIVE: "drive3",
    }[kind.target]
    return kind.make(plant, on, fault_settings(kind, settings or {}, {}))


def polled(plant: Installation, drive: str, what: str) -> object:
    """What the PLC says of a drive."""
    return plant.cpu.engine.global_value(POLLED.format(drive=drive, what=what))


def all_is_well(plant: Installation) -> bool:
    """Whether the PLC has heard of all drives lately and misses none."""
    return all(
        polled(plant, drive, "valid") is True and polled(plant, drive, "lost") is False
        for drive in plant.drives
    )


def snapshot(plant: Installation) -> dict[str, object]:
    """What faults hold, by what it belongs to."""
    gateway, line, master = plant.gateways["gw1"], plant.lines["gw1"], plant.master
    return {
        "cpu": plant.cpu.mode,
        "scans": (plant.cpu.settings.execution_ns, plant.cpu.settings.execution_jitter_ns),
        "torn": plant.cpu.link.tear_probability,
        "refused": (
            plant.cpu.consistent_data.refused_reading,
            plant.cpu.consistent_data.refused_writing,
        ),
        "bus": master.mode,
        "connected": master.connected,
        "jitter": master.jitter_ns,
        "plugged": plant.stations["gw1"].plugged,
        "sync": (gateway.slave.sync, gateway.slave.freeze),
        "type": gateway.slave.type,
        "diagnosis": gateway.slave.ext_diag,
        "gateway": gateway.powered,
        "processing": gateway.settings.processing_ns,
        "stuck": gateway.trigger_stuck,
        "overwrites": gateway.overwrites.probability,
        "to_drives": _pair(line.master_pair),
        "from_drives": _pair(line.slave_pair),
        **{name: drive_state(drive) for name, drive in plant.drives.items()},
    }


def _pair(pair: Pair) -> dict[str, object]:
    disturbed = pair.interference
    return {
        "broken": pair.broken,
        "noise": disturbed.bit_errors.probability,
        "lost": disturbed.byte_losses.probability,
        "doubled": disturbed.byte_doublings.probability,
        "delays": disturbed.delays.probability,
        "delay": disturbed.delay_ns,
    }


def drive_state(drive: Inverter) -> dict[str, object]:
    port = drive.communication
    return {
        "powered": drive.powered,
        "local": drive.operation.words.local,
        "alarm": drive.monitors.alarm,
        "locked": drive.registers.locked,
        "worn": drive.registers.eeprom_faulty,
        "emergency": drive.emergency_terminal,
        "open": (port.port.receive_open, port.port.transmit_open),
        "numbers": (drive.inv_no, port.reply_number),
        "reply": (port.reply_time, port.late_replies.probability, port.late_ns),
    }
