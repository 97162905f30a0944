"""The faults of a seed: few kinds at a time, each at a random instant and place (swarm testing)."""

from collections.abc import Collection, Mapping, Sequence
from random import Random

from harness.kernel import NS_PER_MS, NS_PER_S
from harness.verify.campaign.entries import Entry, written_time

BEGIN_NS = 700 * NS_PER_MS
LAST_NS = 5 * NS_PER_S
"""Faults begin `BEGIN_NS` behind the start, and all are over `LAST_NS` later."""
_SHORTEST_REST_NS = 200 * NS_PER_MS
_AT_REST = ("cpu_retentive_lost", "cpu_stopped", "cpu_unpowered")
"""No CPU is in RUN again sooner than in some tenths of a second."""
_MOST_KINDS = 4
_MOST_FAULTS = 8
_LONGEST_NS = 1500 * NS_PER_MS
_SETTINGS: Mapping[str, Mapping[str, Sequence[object]]] = {
    "cpu_jitter": {"up_to": ("1 ms", "5 ms", "30 ms")},
    "cpu_overrun": {"execution_time": ("20 ms", "50 ms", "100 ms")},
    "cpu_stopped": {"restart": ("warm", "cold"), "data": ("initial", "kept")},
    "drive_answers_late": {"delay": ("15 ms", "60 ms", "200 ms"), "probability": (0.2, 0.7)},
    "drive_disconnected": {"direction": ("both", "to_drive", "from_drive")},
    "drive_slow": {"reply_time": ("25 ms", "45 ms", "78 ms", "130 ms")},
    "drive_tripped": {"display": ("OC1", "OL2", "Err5", "E")},
    "gateway_buffer_overwritten": {"probability": (0.1, 0.6)},
    "gateway_slow": {"processing_time": ("8 ms", "20 ms", "60 ms")},
    "line_babbling": {"direction": ("from_drives", "to_drives", "both")},
    "line_broken_one_way": {"direction": ("from_drives", "to_drives")},
    "line_bytes_delayed": {"delay": ("2 ms", "10 ms", "40 ms"), "probability": (0.1, 0.6)},
    "line_bytes_doubled": {"byte_doubling_rate": (0.003, 0.05)},
    "line_bytes_lost": {"byte_loss_rate": (0.003, 0.05)},
    "line_noise": {"bit_error_rate": (0.0005, 0.003, 0.01, 0.1)},
    "profibus_jitter": {"up_to": ("100 us", "900 us")},
    "profibus_wrong_configuration": {"refuses": ("configuration", "ident_number")},
    "transfers_torn": {"probability": (0.3, 1.0)},
}
"""How much of a fault: what one of the settings is drawn from. The bus cycle is 1 ms at least."""
_ENDS_WITHOUT_SUPPLY = {"devicenet_bus_off": "drive_unpowered"}
"""What lasts until the supply was away, and the fault that takes it away."""


def draw_faults(
    random: Random,
    places: Mapping[str, Sequence[str]],
    kinds: Sequence[str],
    on_devicenet: Collection[str],
) -> list[Entry]:
    """The faults of a seed, of these `kinds` where the plant can have them, in their order.

    `on_devicenet` are the drives whose cable has no directions.
    """
    possible = sorted(name for name in kinds if places.get(name))
    if not possible:
        return []
    chosen = random.sample(possible, min(len(possible), random.randint(1, _MOST_KINDS)))
    events = []
    for _ in range(random.randint(1, _MOST_FAULTS)):
        name = random.choice(chosen)
        lasts_ns = int(_LONGEST_NS ** random.uniform(0.7, 1.0))
        if name in _AT_REST:
            lasts_ns = max(lasts_ns, _SHORTEST_REST_NS)
        over_ns = lasts_ns
        if name in _ENDS_WITHOUT_SUPPLY:
            over_ns += _SHORTEST_REST_NS
        at_ns = BEGIN_NS + random.randrange(LAST_NS - over_ns)
        event: Entry = {
            "at": written_time(at_ns),
            "lasts": written_time(lasts_ns),
            "inject": name,
        }
        if on := random.choice(list(places[name])):
            event["on"] = on
        if name in _SETTINGS and not (name == "drive_disconnected" and on in on_devicenet):
            drawn = {key: random.choice(values) for key, values in _SETTINGS[name].items()}
            event["settings"] = drawn
        events.append((at_ns, event))
        if name in _ENDS_WITHOUT_SUPPLY:
            at_ns += lasts_ns
            away: Entry = {
                "at": written_time(at_ns),
                "lasts": written_time(_SHORTEST_REST_NS),
                "inject": _ENDS_WITHOUT_SUPPLY[name],
                "on": on,
            }
            events.append((at_ns, away))
    return [event for _, event in sorted(events, key=lambda item: item[0])]
