"""Generated blocks on Modbus_Master: settings, a lost module, the time of an emergency stop."""

from pathlib import Path

import pytest

from fbgen.blocks.serial_times import serial_times
from fbgen.catalog import load_catalog
from fbgen.plant import changed, load_plant
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import Parity
from harness.pytest_plugin.injected_faults import InjectedFaults

CATALOG = load_catalog()
PLANT = load_plant(Path(__file__).parents[3] / "examples" / "modbus" / "plant.yaml", CATALOG)
LINE = "TOS_Plant.line1"


def _started(**changes: object) -> Installation:
    rig = build_plant(changed(PLANT, CATALOG, **changes), CATALOG, PlantSetup(seed=1))
    rig.start()
    rig.run_for(2 * NS_PER_S)
    return rig


def _value(rig: Installation, path: str) -> object:
    return rig.cpu.engine.global_value(f"{LINE}.{path}")


def test_the_program_sets_the_module_as_the_line_is() -> None:
    rig = _started()
    module = rig.devices.modules["line1"]
    assert module.configured[0].baud == 9600
    assert (module.port.format.baud, module.port.format.parity) == (19_200, Parity.EVEN)
    assert module.modbus is not None
    timeout_ms = serial_times(PLANT, PLANT.serial[0], CATALOG).timeout_ms
    assert (module.modbus.retries, module.modbus.reply_ms) == (0, int(timeout_ms) // 5 * 3)


def test_a_module_that_was_lost_is_set_anew_and_asked_again() -> None:
    rig = _started()
    module = rig.devices.modules["line1"]
    module.power_off()
    rig.run_for(2 * NS_PER_S)
    assert (_value(rig, "line.online"), _value(rig, "line.portStatus")) == (False, 0x8282)
    assert _value(rig, "pump.polled.lost") is True
    module.power_on()
    rig.run_for(2 * NS_PER_S)
    assert (_value(rig, "line.online"), _value(rig, "pump.polled.lost")) == (True, False)
    assert module.port.format.baud == 19_200
    assert rig.cpu.diagnostics == []


@pytest.mark.parametrize("cycle_ms", [10.0, 25.0])
def test_the_emergency_stop_is_out_in_the_time_that_the_line_states(cycle_ms: float) -> None:
    """The poll asks a silent drive all the time, so the stop mostly finds a request under way."""
    limit_ms = serial_times(
        changed(PLANT, CATALOG, cycle_time_ms=cycle_ms), PLANT.serial[0], CATALOG
    ).emergency_stop_ms
    longest_ms = 0
    for later_ms in range(0, 130, 13):
        rig = _started(cycle_time_ms=cycle_ms)
        InjectedFaults(rig).inject("drive_disconnected", "pump")
        rig.run_for(NS_PER_S + later_ms * NS_PER_MS)
        rig.cpu.engine.set_global(f"{LINE}.line.emergencyStop", True)
        begun_ns = rig.kernel.now_ns
        while not rig.drives["fan"].tripped:
            rig.run_for(NS_PER_MS)
            assert rig.kernel.now_ns < begun_ns + NS_PER_S
        longest_ms = max(longest_ms, (rig.kernel.now_ns - begun_ns) // NS_PER_MS)
    assert longest_ms <= limit_ms + 1
    assert longest_ms > limit_ms / 2
