"""Two faults at once: what they hold is held until both have ended, in whichever order.

Over all pairs: behind the end of the first one, the plant is as with the second one alone; behind
the end of both it is as it was. Both may be the same fault with other settings.
"""

from collections.abc import Mapping
from itertools import combinations, combinations_with_replacement

import pytest

from fbgen.plant import Plant
from harness.faults import FAULTS, Fault, Target
from harness.installation import Installation
from harness.kernel import NS_PER_S
from tests.unit.faults.fault_plant import all_is_well, fault, five_drives, snapshot, started
from tests.unit.faults.pairs import end_independently, one_behind_the_other

ELSEWHERE = (Target.NETWORK, Target.OPTION, Target.MODULE)
HERE = sorted(name for name, kind in FAULTS.items() if kind.target not in ELSEWHERE)
"""The faults of a plant with a gateway; for DeviceNet see `test_devicenet_faults`."""
STRONGER: dict[str, Mapping[str, float | str]] = {
    "cpu_jitter": {"up_to": "8 ms"},
    "cpu_overrun": {"execution_time": "80 ms"},
    "drive_answers_late": {"delay": "200 ms", "probability": 0.1},
    "drive_disconnected": {"direction": "to_drive"},
    "drive_slow": {"reply_time": "90 ms"},
    "gateway_buffer_overwritten": {"probability": 0.5},
    "gateway_slow": {"processing_time": "40 ms"},
    "line_broken_one_way": {"direction": "to_drives"},
    "line_bytes_delayed": {"delay": "5 ms", "probability": 0.5},
    "line_bytes_doubled": {"byte_doubling_rate": 0.5},
    "line_bytes_lost": {"byte_loss_rate": 0.5},
    "line_noise": {"bit_error_rate": 0.5, "direction": "to_drives"},
    "profibus_jitter": {"up_to": "1900 us"},
    "transfers_torn": {"probability": 0.5},
}
"""Settings for the second one of two equal faults."""


@pytest.fixture(scope="module")
def plan() -> Plant:
    return five_drives()


def two(plant: Installation, names: tuple[str, str]) -> tuple[Fault, Fault]:
    """Both faults; the second one stronger if they are of the same kind."""
    settings = STRONGER.get(names[1], {}) if names[0] == names[1] else {}
    return fault(plant, names[0]), fault(plant, names[1], settings)


def held(plant: Installation) -> dict[str, object]:
    """What faults hold. Sync and Freeze are the gateway's, which may lose them by itself."""
    return {key: value for key, value in snapshot(plant).items() if key != "sync"}


@pytest.mark.parametrize("first", HERE)
def test_two_faults_end_independently_of_each_other(plan: Plant, first: str) -> None:
    plant = started(plan)
    for second in [name for name in HERE if name >= first]:
        end_independently(plant, two(plant, (first, second)), held)


@pytest.mark.slow
@pytest.mark.parametrize("names", list(combinations_with_replacement(HERE, 2)))
def test_after_two_faults_the_plant_works_again(plan: Plant, names: tuple[str, str]) -> None:
    plant = started(plan)
    one_behind_the_other(plant, two(plant, names), 6 * NS_PER_S)
    assert all_is_well(plant)
    assert not plant.cpu.diagnostics


def test_three_faults_that_hold_one_thing_end_in_any_order(plan: Plant) -> None:
    plant = started(plan)
    names = ("line_broken", "line_broken_one_way", "line_broken_one_way")
    faults = [fault(plant, name) for name in names]
    pair = plant.lines["gw1"].slave_pair
    for item in faults:
        item.inject()
    for first, second in combinations(range(3), 2):
        faults[first].clear()
        faults[second].clear()
        assert pair.broken, "one is left"
        faults[first].inject()
        faults[second].inject()
    for item in faults:
        item.clear()
    assert not pair.broken
