"""Noise on a serial line of the PLC: no damaged reply is ever taken for a value.

Every bit on the line is wrong with 1e-3. What the PLC shows is compared with what the drives have,
every cycle. The checksum has 8 bits and parity sees odd errors alone, so a wrong value is possible;
the seeds are fixed, and none of these runs has one.
"""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import changed, load_plant
from harness.installation import PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.pytest_plugin.injected_faults import InjectedFaults

_VALUES = ("tripCode", "tripped", "statusWord", "frequency", "current")
_EXAMPLES = Path(__file__).parents[3] / "examples"
_LINES = [("serial", None), ("modbus", "instruction"), ("modbus", "own")]


def _wrong_values(example: str, frames: str | None, seconds: int) -> tuple[int, int]:
    """How often a value was wrong at the end of a cycle, and how many telegrams had errors."""
    catalog = load_catalog()
    plan = load_plant(_EXAMPLES / example / "plant.yaml", catalog)
    plan = changed(plan, catalog, modbus_frames=frames)
    rig = build_plant(plan, catalog, PlantSetup(seed=1, engine="compiled"))
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


@pytest.mark.parametrize(("example", "frames"), _LINES)
def test_no_wrong_value_in_a_minute_of_noise(example: str, frames: str | None) -> None:
    wrong, errors = _wrong_values(example, frames, 60)
    assert wrong == 0
    assert errors > 20


@pytest.mark.slow
@pytest.mark.parametrize(("example", "frames"), _LINES)
def test_no_wrong_value_in_an_hour_of_noise(example: str, frames: str | None) -> None:
    wrong, errors = _wrong_values(example, frames, 3600)
    assert wrong == 0
    assert errors > 1200
