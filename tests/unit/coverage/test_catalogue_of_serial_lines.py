"""Catalogue coverage of serial lines of the PLC: ComNos, bits, refusals."""

from pathlib import Path

import pytest

from fbgen.wire import modbus
from fbgen.wire.toshiba import seal
from harness.installation import PlantSetup, plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.verify.coverage import watch
from harness.verify.coverage.catalogue import (
    READ,
    READ_WORDS,
    REFUSALS,
    WRITTEN,
    WRITTEN_WORDS,
    CatalogueCoverage,
)

EXAMPLES = Path(__file__).parents[3] / "examples"
ASKED = {
    "serial": [seal(bytes.fromhex(one)) for one in ("02 47 12 34 00 00", "02 50 00 09 FF FF")],
    "modbus": [modbus.seal(bytes.fromhex(one)) for one in ("02 03 12 34 00 01", "02 42 00 00")],
}


@pytest.mark.parametrize(
    ("example", "refusals"),
    [
        ("serial", {"toshiba 0001", "toshiba 0002"}),
        ("modbus", {"modbus 01", "modbus 02"}),
    ],
)
def test_telegrams_tell_comnos_bits_and_refusals(example: str, refusals: set[str]) -> None:
    coverage = CatalogueCoverage()
    installation = plant(EXAMPLES / example / "plant.yaml", PlantSetup())
    watch(installation, coverage)
    installation.start()
    installation.cpu.engine.set_global("TOS_Plant.line1.fan.control.enable", True)
    installation.run_for(2 * NS_PER_S)
    installation.cpu.stop()
    installation.run_for(200 * NS_PER_MS)
    for frame in ASKED[example]:
        installation.devices.modules["line1"].port.transmit(frame)
        installation.run_for(100 * NS_PER_MS)
    seen = {
        group: {item for item, found in items.items() if found}
        for group, items in coverage.items.items()
    }
    assert "vf-s11 FA00 command_word" in seen[WRITTEN]
    assert "vf-s11.command.network_command = 1" in seen[WRITTEN_WORDS]
    assert "vf-s11.command.run = 1" not in seen[WRITTEN_WORDS]
    assert {"vf-s11 FC90 trip_code", "vf-s11 FD00 output_frequency"} <= seen[READ]
    assert {f"vf-s11.status.{name}" for name in ("standby = 1", "running = 0")} <= seen[READ_WORDS]
    told = {" ".join(item.split()[:2]) for item in seen[REFUSALS]}
    assert told == refusals
    assert len(coverage.items[REFUSALS]) >= 4
