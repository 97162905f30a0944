"""What one seed of a campaign does to a plant: a whole scenario, drawn, as plain data.

Every seed draws its own small subset of the kinds of faults and how many of them (swarm testing),
where the counter of the trigger stands (its wrap-around on purpose), how the program reaches the
data and which engine runs it. After the faults the plant gets time to recover, and then everything
must be well: that is part of the scenario, as steps.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from random import Random
from typing import Any, TypeAlias

from fbgen.plant import Plant, PlantDrive
from harness.kernel import NS_PER_MS, NS_PER_S, NS_PER_US

Entry: TypeAlias = dict[str, Any]
"""A mapping of a scenario file."""

_BEGIN_NS = 700 * NS_PER_MS
_DISTURBED_NS = 5 * NS_PER_S
_MOST_KINDS = 4
_MOST_FAULTS = 8
_LONGEST_NS = 1500 * NS_PER_MS
_ACTIONS = 12
_TRIGGERS = (0, 1, 253, 254, 255)
VARIATIONS: tuple[Entry, ...] = (
    {},
    {"access": "per_identifier", "layout": "gsd10"},
    {"access": "per_identifier", "layout": "doc9"},
    {"access": "dpxx_dat", "layout": "whole10"},
    {"access": "process_image", "layout": "gsd10"},
)
"""The ways in which a plant is built, as far as it allows them."""
_REFERENCE_SHARE = 0.02
"""The reference engine is slow; both engines give the same."""


@dataclass(frozen=True, slots=True)
class Subject:
    """A plant file that a campaign tries: its plan, the variations that it allows, and where each
    fault can be in it."""

    file: str
    plan: Plant
    variations: tuple[Entry, ...]
    places: Mapping[str, Sequence[str]]


def draw(seed: int, subject: Subject, kinds: Sequence[str]) -> Entry:
    """The scenario of a seed, with faults of these `kinds`."""
    random = Random(f"campaign {seed}")
    plan = subject.plan
    return {
        "version": 1,
        "title": f"Seed {seed} of a campaign",
        "plant": subject.file,
        "seed": seed,
        "engine": "reference" if random.random() < _REFERENCE_SHARE else "compiled",
        "variations": [dict(random.choice(subject.variations))],
        "rules": ["all"],
        "faults": _faults(random, subject.places, kinds),
        "steps": [*_work(random, plan), *_recovery(plan)],
    }


def _faults(
    random: Random, places: Mapping[str, Sequence[str]], kinds: Sequence[str]
) -> list[Entry]:
    possible = sorted(name for name in kinds if places.get(name))
    if not possible:
        return []
    chosen = random.sample(possible, min(len(possible), random.randint(1, _MOST_KINDS)))
    events = []
    for _ in range(random.randint(1, _MOST_FAULTS)):
        name = random.choice(chosen)
        lasts_ns = int(_LONGEST_NS ** random.uniform(0.7, 1.0))
        at_ns = _BEGIN_NS + random.randrange(_DISTURBED_NS - lasts_ns)
        event: Entry = {"at": _time(at_ns), "lasts": _time(lasts_ns), "inject": name}
        if on := random.choice(list(places[name])):
            event["on"] = on
        if name == "drive_tripped":
            event["settings"] = {"display": random.choice(("OC1", "OL2", "Err5", "E"))}
        events.append((at_ns, event))
    return [event for _, event in sorted(events, key=lambda item: item[0])]


def _time(time_ns: int) -> str:
    return f"{max(time_ns // NS_PER_US, 1)} us"


def _work(random: Random, plan: Plant) -> list[Entry]:
    """What the PLC is asked for meanwhile, and where its triggers begin."""
    steps: list[Entry] = []
    for gateway in plan.gateways:
        count = f"plc.TOS_Gateway_{gateway.name}_DB.instLine.instTelegram.instTrigger.statCount"
        steps.append({"set": {count: random.choice(_TRIGGERS)}})
    drives = [(gateway.name, drive) for gateway in plan.gateways for drive in gateway.drives]
    left_ns = _BEGIN_NS + _DISTURBED_NS + NS_PER_S
    for _ in range(_ACTIONS):
        pause_ns = random.randrange(left_ns // _ACTIONS * 2) + NS_PER_MS
        gateway_name, drive = random.choice(drives)
        base = f"plc.TOS_Plant.{gateway_name}.{drive.name}"
        steps += [{"wait": _time(min(pause_ns, left_ns))}, {"set": _asked(random, base, drive)}]
        left_ns = max(left_ns - pause_ns, NS_PER_MS)
    return [*steps, {"wait": _time(left_ns)}]


def _asked(random: Random, base: str, drive: PlantDrive) -> Entry:
    control = f"{base}.control"
    match random.randrange(6):
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
        case _:
            return {f"{control}.enable": random.random() < 0.5}


def _recovery(plan: Plant) -> list[Entry]:
    """Nothing is asked for, drives are reset, twice: a reset may be lost. Then all must be well."""
    controls = [
        f"plc.TOS_Plant.{gateway.name}.{drive.name}.control"
        for gateway in plan.gateways
        for drive in gateway.drives
    ]
    steps: list[Entry] = [
        {"set": {f"{control}.run": False for control in controls}},
        {"set": {f"{control}.enable": True for control in controls}},
        {"wait": "4 s"},
    ]
    for _ in range(2):
        steps += [
            {"set": {f"{control}.reset": False for control in controls}},
            {"wait": "500 ms"},
            {"set": {f"{control}.reset": True for control in controls}},
            {"wait": "4 s"},
        ]
    well: Entry = {}
    for gateway in plan.gateways:
        for drive in gateway.drives:
            base = f"plc.TOS_Plant.{gateway.name}.{drive.name}"
            if gateway.status_poll:
                well |= {f"{base}.polled.valid": True, f"{base}.polled.lost": False}
            well |= {f"{base}.state.tripped": False, f"{base}.state.running": False}
            well[f"drive.{drive.name}.running"] = False
    for gateway in plan.gateways:
        well[f"plc.TOS_Plant.{gateway.name}.line.online"] = True
    return [*steps, {"expect": well, "within": "10 s"}]
