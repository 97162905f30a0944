"""pyprofibus, configured from a GSD file, runs the slave of a plant that names the same file."""

import sys
from contextlib import closing
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant, plugged
from harness.fieldbus import SlaveState
from harness.serial import gateways_to_serve
from tests.unit.serial.foreign_master import Interplay
from tests.unit.wire.foreign_gsd import foreign_station

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")
ROOT = Path(__file__).parents[3]
EXAMPLES = ROOT / "examples"
PLANTS = {
    "tospbdp001": (
        EXAMPLES / "manual_example" / "plant.yaml",
        "layout: gsd10",
        EXAMPLES / "manual_example" / "esco1803.gsd",
        "Binary Mode",
    ),
    "pbdp110": (
        EXAMPLES / "pbdp110" / "plant.yaml",
        "layout: module2",
        ROOT / "tests" / "unit" / "wire" / "made_up_pbdp110.gsd",
        "Module 2: two drives with parameters",
    ),
}


@pytest.mark.parametrize("kind", PLANTS)
def test_both_sides_come_from_one_gsd_file(kind: str, tmp_path: Path) -> None:
    example, layout, gsd, module = PLANTS[kind]
    path = tmp_path / "plant.yaml"
    text = example.read_text("utf-8").replace("profibus_address: 3", "profibus_address: 2")
    named = f'gsd: "{gsd.as_posix()}"\n    modules: ["{module}"]'
    path.write_text(text.replace(layout, named), "utf-8")

    catalog = load_catalog()
    plan = load_plant(path, catalog)
    (entry,) = plan.gateways
    chosen = plugged(entry, catalog.gateway(entry.type))
    assert chosen is not None
    served = gateways_to_serve(plan, catalog)
    slave = served.devices.slave(entry.name)

    theirs = foreign_station(gsd.read_bytes())
    theirs.clearConfiguredModules()
    theirs.setConfiguredModule(module)
    configuration = b"".join(bytes(one.getDU()) for one in theirs.getCfgDataElements())
    sizes = (chosen.output_length, chosen.input_length)
    ident = theirs.getIdentNumber()
    with closing(Interplay(served.kernel, slave, configuration, sizes, ident)) as both:
        both.master.slave.setUserPrmData(theirs.getUserPrmData())
        both.until(bool)
        assert slave.state is SlaveState.DATA_EXCHANGE
        assert len(both.inputs) == chosen.input_length
        assert slave.type.ident_number == chosen.station.ident_number
        assert not slave.prm_fault
