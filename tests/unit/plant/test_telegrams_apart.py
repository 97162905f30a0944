"""Telegrams to different drives keep the reply time apart, also where drives answer at once.

Source: TOSPBDP001 manual v1.1, 9: 20 ms for the VF-S11, 78 ms for the VF-nC1.
"""

from pathlib import Path

import pytest

from fbgen.catalog import Catalog, load_catalog
from fbgen.plant import Plant, read_plant
from fbgen.resources import shipped
from fbgen.source import Source
from harness.fieldbus import CycleTimes
from harness.installation import DriveConditions, PlantSetup, build_plant, generated_sources
from harness.kernel import NS_PER_MS, NS_PER_S

PLANT = """
version: 1
name: apart
dialect: {dialect}
plc: {plc}
cycle_time_ms: 2
gateways:
  - name: gw1
    type: tospbdp001
    layout: gsd10
    profibus_address: 2
    access: {access}
    input_address: 256
    output_address: 256
    drives:
      - {{name: one, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}}
      - {{name: two, inv_no: 2, series: vf-s11, max_frequency_hz: 50.0}}
      - {{name: three, inv_no: 3, series: vf-s11, max_frequency_hz: 50.0}}
"""


@pytest.fixture
def catalog(tmp_path: Path) -> Catalog:
    """The catalogue with a VF-S11 that may take 78 ms to answer, as the VF-nC1 does."""
    text = (shipped("catalog") / "drives" / "vf-s11.yaml").read_text(encoding="utf-8")
    text = text.replace("reply_max: {ms: 20,", "reply_max: {ms: 78,")
    (tmp_path / "drives").mkdir()
    (tmp_path / "drives" / "vf-s11.yaml").write_text(text, encoding="utf-8")
    return load_catalog([tmp_path])


def plan(catalog: Catalog, dialect: str, plc: str, access: str) -> Plant:
    text = PLANT.format(dialect=dialect, plc=plc, access=access)
    return read_plant(Source("plant.yaml", text), catalog)


@pytest.mark.fact("tos.t.gap")
@pytest.mark.parametrize(
    ("dialect", "plc", "access"),
    [
        ("tia", "s7-1500", "per_identifier"),
        ("step7", "s7-300", "process_image"),
        ("iec", "iec", "process_image"),
    ],
)
def test_the_line_keeps_them_apart(catalog: Catalog, dialect: str, plc: str, access: str) -> None:
    wanted = plan(catalog, dialect, plc, access)
    at_once = {name: DriveConditions(reply_time_ns=NS_PER_MS) for name in ("one", "two", "three")}
    for phase_ns in (0, 700_000, 1_900_000):
        bus = CycleTimes(5 * NS_PER_MS, phase_ns)
        plant = build_plant(wanted, catalog, PlantSetup(drives=at_once, bus=bus))
        plant.start()
        plant.run_for(3 * NS_PER_S)
        assert plant.gateways["gw1"].telegrams > 50
        assert plant.spacing["gw1"].too_close == []


def test_without_the_wait_the_simulation_notices_it(catalog: Catalog) -> None:
    wanted = plan(catalog, "tia", "s7-1500", "per_identifier")
    sources = [
        Source(source.name, source.text.replace("apart := T#93ms", "apart := T#0ms"))
        for source in generated_sources(wanted, catalog)
    ]
    at_once = {name: DriveConditions(reply_time_ns=NS_PER_MS) for name in ("one", "two", "three")}
    plant = build_plant(wanted, catalog, PlantSetup(sources=sources, drives=at_once))
    plant.start()
    plant.run_for(3 * NS_PER_S)
    found = plant.spacing["gw1"].too_close
    assert found
    assert all(item.before != item.inv_no and item.distance_ns < 78 * NS_PER_MS for item in found)
