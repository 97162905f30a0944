"""Noise on a serial line of the PLC: no damaged reply is ever taken for a value.

Every bit on the line is wrong with 1e-3. What the PLC shows is compared with what the drives have,
every cycle. The checksum has 8 bits and parity sees odd errors alone, so a wrong value is possible;
the seeds are fixed, and none of these runs has one.
"""

from pathlib import Path

import pytest

from harness.installation import PlantSetup, plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.pytest_plugin.injected_faults import InjectedFaults

_VALUES = ("tripCode", "tripped", "statusWord", "frequency", "current")
_EXAMPLES = Path(__file__).parents[3] / "examples"


def _wrong_values(example: str, seconds: int) -> tuple[int, int]:
    """How often a value was wrong at the end of a cycle, and how many telegrams had errors."""
    rig = plant(_EXAMPLES / example / "plant.yaml", PlantSetup(seed=1, engine="compiled"))
    rig.start()
    rig.run_for(3 * NS_PER_S)
    unit = rig.plan.units[0]
    bases = [f"TOS_Plant.{unit.name}.{drive.name}" for drive in unit.drives]
    right = [rig.cpu.engine.global_value(f"{base}.polled") for base in bases]
    InjectedFaults(rig).inject("line_noise", unit.name, bit_error_rate=0.001)
    wrong = 0
    for _ in range(seconds * 100):
        rig.run_for(10 * NS_PER_MS)
        for base, before in zip(bases, right, strict=True):
            now = rig.cpu.engine.global_value(f"{base}.polled")
            assert isinstance(now, dict)
            assert isinstance(before, dict)
            wrong += any(now[name] != before[name] for name in _VALUES)
    assert rig.cpu.diagnostics == []
    errors = rig.cpu.engine.global_value(f"TOS_Plant.{unit.name}.line.errorCount")
    assert isinstance(errors, int)
    return wrong, errors


@pytest.mark.parametrize("example", ["serial", "modbus"])
def test_no_wrong_value_in_a_minute_of_noise(example: str) -> None:
    wrong, errors = _wrong_values(example, 60)
    assert wrong == 0
    assert errors > 20


@pytest.mark.slow
@pytest.mark.parametrize("example", ["serial", "modbus"])
def test_no_wrong_value_in_an_hour_of_noise(example: str) -> None:
    wrong, errors = _wrong_values(example, 3600)
    assert wrong == 0
    assert errors > 1200
