"""What one seed of a campaign does to a plant: a whole scenario, drawn, as plain data.

Each seed draws a configuration, its own few kinds of faults, where the counter of the trigger
stands and which engine runs it. After the faults the plant gets time to recover, and then
everything must be well: that is part of the scenario, as steps.
"""

from collections.abc import Mapping, Sequence
from random import Random

from fbgen.blocks.dev_parameters import has_channel
from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.plant import DeviceNetDrive, DeviceNetNetwork, Plant, PlantDrive, PlantGateway
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.scenario.model import Variation
from harness.scenario.plant_changes import varied_plant
from harness.verify.campaign.configurations import (
    SEEDS_PER_PROGRAM,
    TRIGGERS,
    asked_units,
    draw_program,
    draw_start,
    telegram_gateways,
)
from harness.verify.campaign.disturbances import BEGIN_NS, LAST_NS, draw_faults
from harness.verify.campaign.entries import Entry, written_time
from harness.verify.campaign.interfaces import asked_in_parameter_channel, well_at_an_interface

_ACTIONS = 12
_ROUND_NS, _WELL_NS = 4 * NS_PER_S, 10 * NS_PER_S
_BEFORE_RESETS = ("500 ms", "710 ms", "930 ms")
"""Not in step with the heartbeat: drive 00 hears nothing while it answers that."""
_USUAL_CYCLE_MS = 10
"""In `_ROUND_NS` all drives of a line are asked with such a cycle, and a reset is through."""
_JOBS_SHARE = 0.3
"""Of what is asked for behind a gateway for process data."""
_REFERENCE_SHARE = 0.02
"""The reference engine is slow; both engines give the same."""


@dataclass(frozen=True, slots=True)
class Subject:
    """A plant file that a campaign tries: its plan, the variations that it allows, and where each
    fault can be in it. `catalog` has its own sequences, too."""

    file: str
    plan: Plant
    catalog: Catalog
    variations: tuple[Entry, ...]
    places: Mapping[str, Sequence[str]]


def draw(seed: int, turn: int, subject: Subject, kinds: Sequence[str]) -> Entry:
    """The scenario of a seed, with faults of these `kinds`; it is the `turn`th of its plant."""
    plan, catalog = subject.plan, subject.catalog
    of_program = Random(f"campaign program {turn // SEEDS_PER_PROGRAM}")
    program = draw_program(of_program, plan, subject.variations, catalog)
    random = Random(f"campaign {seed}")
    varied = varied_plant(plan, Variation.model_validate(program), catalog)
    return {
        "version": 1,
        "title": f"Seed {seed} of a campaign",
        "plant": subject.file,
        "seed": seed,
        "engine": "reference" if random.random() < _REFERENCE_SHARE else "compiled",
        "variations": [program],
        **draw_start(random, plan, program, catalog),
        "rules": ["all"],
        "faults": draw_faults(
            random, subject.places, kinds, {drive.name for drive in plan.devicenet_drives}
        ),
        "steps": [
            *_work(random, plan, catalog, _sequences(plan, catalog)),
            *_recovery(varied, catalog, _patience(program, plan), _sequences(plan, catalog)),
        ],
    }


def _sequences(plan: Plant, catalog: Catalog) -> list[str]:
    """The sequences of the plant that leave no drive running."""
    return [
        name
        for name in plan.sequences
        if not catalog.sequences[name].telegrams
        and not any(
            "run" in (getattr(step, "bits", None) or ()) for step in catalog.sequences[name].steps
        )
    ]


def _work(random: Random, plan: Plant, catalog: Catalog, sequences: Sequence[str]) -> list[Entry]:
    """What the PLC is asked for meanwhile, and where its triggers begin."""
    steps: list[Entry] = []
    lines = telegram_gateways(plan, catalog)
    for line in lines:
        count = f"plc.TOS_Gateway_{line.name}_DB.instLine.instTelegram.instTrigger.statCount"
        steps.append({"set": {count: random.choice(TRIGGERS)}})
    asked_by_telegrams = asked_units(plan, catalog)
    drives = [(gateway, drive) for gateway in plan.units for drive in gateway.drives]
    left_ns = BEGIN_NS + LAST_NS + NS_PER_S
    for _ in range(_ACTIONS):
        pause_ns = random.randrange(left_ns // _ACTIONS * 2) + NS_PER_MS
        gateway, drive = random.choice(drives)
        if gateway in asked_by_telegrams:
            asked = _asked(random, gateway.name, drive, sequences)
        elif random.random() < _JOBS_SHARE:
            asked = asked_in_parameter_channel(random, gateway.name, drive)
        else:
            asked = _asked(random, gateway.name, drive, ())
        steps += [{"wait": written_time(min(pause_ns, left_ns))}, {"set": asked}]
        left_ns = max(left_ns - pause_ns, NS_PER_MS)
    return [*steps, {"wait": written_time(left_ns)}]


def _asked(
    random: Random, gateway: str, drive: PlantDrive | DeviceNetDrive, sequences: Sequence[str]
) -> Entry:
    base = f"plc.TOS_Plant.{gateway}.{drive.name}"
    control = f"{base}.control"
    match random.randrange(9):
        case 0 | 1:
            hz = round(random.uniform(5.0, drive.max_frequency_hz), 1)
            run = {f"{control}.enable": True, f"{control}.run": True}
            return {f"{control}.frequency": hz, **run}
        case 2:
            return {f"{control}.run": False}
        case 3:
            return {f"{control}.reverse": random.random() < 0.5}
        case 4:
            return {f"{control}.reset": random.random() < 0.5}
        case 5:
            return {f"plc.TOS_Plant.{gateway}.line.emergencyStop": random.random() < 0.5}
        case 6 | 7 if sequences:
            return {f"{base}.{random.choice(sequences)}.execute": random.random() < 0.7}
        case _:
            return {f"{control}.enable": random.random() < 0.5}


def _patience(program: Entry, plan: Plant) -> float:
    """How much longer than usual it takes until all drives have been asked: a telegram takes some
    cycles of the PLC."""
    cycle_ms: float = program.get("cycle_time_ms", plan.cycle_time_ms)
    return max(cycle_ms / _USUAL_CYCLE_MS, 1.0)


def _recovery(
    plan: Plant, catalog: Catalog, patience: float, sequences: Sequence[str]
) -> list[Entry]:
    """Nothing is asked for, drives are reset, more than once: a reset may be lost. Then all must be
    well: everything answers and stands, and no alarm is left of the line or of a drive."""
    round_time = written_time(round(patience * _ROUND_NS))
    lines = [f"plc.TOS_Plant.{gateway.name}.line" for gateway in plan.units]
    drives = [
        f"plc.TOS_Plant.{gateway.name}.{drive.name}"
        for gateway in plan.units
        for drive in gateway.drives
    ]
    controls = [f"{drive}.control" for drive in drives]
    on_lines = asked_units(plan, catalog)
    executes = {
        f"plc.TOS_Plant.{gateway.name}.{drive.name}.{name}.execute": False
        for gateway in on_lines
        for drive in gateway.drives
        for name in sequences
    }
    for unit in plan.units:
        if unit not in on_lines:
            for member in unit.drives:
                executes |= {f"plc.TOS_Plant.{unit.name}.{member.name}.parameter.execute": False}
    steps: list[Entry] = [
        {"set": {f"{line}.emergencyStop": False for line in lines}},
        {"set": {f"{control}.run": False for control in controls} | executes},
        {"set": {f"{control}.enable": True for control in controls}},
        {"wait": round_time},
    ]
    for pause in _BEFORE_RESETS:
        steps += [
            {"set": {f"{control}.reset": False for control in controls}},
            {"wait": pause},
            {"set": {f"{control}.reset": True for control in controls}},
            {"wait": round_time},
        ]
    well: Entry = {}
    for unit in plan.units:
        for member in unit.drives:
            base = f"plc.TOS_Plant.{unit.name}.{member.name}"
            if isinstance(member, DeviceNetDrive):
                well |= {f"{base}.state.online": True, f"{base}.state.inhibited": False}
                if has_channel(member, catalog):
                    well |= {f"{base}.parameter.busy": False, f"{base}.state.trip": ""}
            elif isinstance(unit, PlantGateway) and unit not in on_lines:
                well |= well_at_an_interface(plan, unit, member, catalog)
            elif not isinstance(unit, DeviceNetNetwork) and unit.status_poll:
                well |= {f"{base}.polled.valid": True, f"{base}.polled.lost": False}
            well |= {f"{base}.state.tripped": False, f"{base}.state.running": False}
            well |= {f"{base}.alarms": 0, f"drive.{member.name}.running": False}
    for line in lines:
        well |= {f"{line}.online": True, f"{line}.alarms": 0}
    return [*steps, {"expect": well, "within": written_time(round(patience * _WELL_NS))}]
