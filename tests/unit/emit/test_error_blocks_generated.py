"""The error blocks of S7-300/400: generated beside the user's project, never in its way."""

import re

import pytest

from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source
from harness.installation import PlantSetup, build_plant
from harness.kernel import NS_PER_MS
from harness.plc import CpuMode

PLANT = """
version: 1
name: hall
dialect: {dialect}
plc: {plc}
{more}
gateways:
  - name: gw1
    type: tospbdp001
    layout: gsd10
    profibus_address: 2
    access: per_identifier
    input_address: 256
    output_address: 256
    drives:
      - {{name: pump, inv_no: 11, series: vf-s11, max_frequency_hz: 50.0}}
  - name: gw2
    type: tospbdp001
    layout: gsd10
    profibus_address: 33
    access: per_identifier
    input_address: 300
    output_address: 300
    drives:
      - {{name: fan, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}}
"""


def plan(dialect: str, plc: str, more: str = ""):
    text = PLANT.format(dialect=dialect, plc=plc, more=more)
    return read_plant(Source("plant.yaml", text))


def files(dialect: str, plc: str, more: str = "") -> dict[str, str]:
    made = generate(plan(dialect, plc, more), load_catalog())
    return {file.name: file.text for file in made.files}


def test_tia_has_a_source_for_each_of_them_and_one_for_their_notes():
    names = files("tia", "s7-300")
    assert {"OB82.scl", "OB85.scl", "OB86.scl", "OB122.scl", "TOS_Errors.db"} <= names.keys()


def test_step7_has_them_in_a_source_of_their_own_by_their_numbers():
    made = files("step7", "s7-400")
    assert list(made) == [
        "hall.sdf",
        "hall.scl",
        "hall_parameters.scl",
        "hall_calls.scl",
        "hall_error_obs.scl",
    ]
    heads = re.findall(r"^ORGANIZATION_BLOCK .*", made["hall_error_obs.scl"], re.MULTILINE)
    assert heads == [f"ORGANIZATION_BLOCK OB{number}" for number in (82, 85, 86, 122)]
    assert "ORGANIZATION_BLOCK" not in made["hall.scl"]
    assert '"TOS_Errors ' in made["hall.sdf"]
    assert "OB86" not in made["hall.sdf"]


@pytest.mark.parametrize(("dialect", "plc"), [("tia", "s7-300"), ("step7", "s7-300")])
def test_who_has_own_ones_gets_none(dialect, plc):
    made = files(dialect, plc, "error_obs: mine")
    assert not any("ORGANIZATION_BLOCK" in text or "TOS_Errors" in text for text in made.values())


@pytest.mark.parametrize("plc", ["s7-1200", "s7-1500"])
def test_a_cpu_of_today_gets_none(plc):
    made = files("tia", plc)
    assert not any("ORGANIZATION_BLOCK" in text or "TOS_Errors" in text for text in made.values())


@pytest.fixture(params=["compiled", "reference"])
def plant(request):
    """A running S7-400 with two gateways, with the generated text."""
    built = build_plant(plan("tia", "s7-400"), load_catalog(), PlantSetup(engine=request.param))
    built.start()
    built.run_for(200 * NS_PER_MS)
    return built


def noted(plant, name: str):
    return plant.cpu.engine.global_value(f"TOS_Errors.{name}")


def test_ob86_tells_the_gateways_apart(plant):
    plant.gateways["gw2"].power_off()
    plant.run_for(50 * NS_PER_MS)
    assert noted(plant, "lost") == {"gw1": False, "gw2": True}
    plant.gateways["gw2"].power_on()
    plant.run_for(500 * NS_PER_MS)
    assert noted(plant, "lost") == {"gw1": False, "gw2": False}
    assert noted(plant, "stationFailures") == 1


def test_ob122_notes_the_address(plant):
    plant.gateways["gw2"].power_off()
    plant.run_for(50 * NS_PER_MS)
    assert noted(plant, "accessErrors") > 0
    assert 300 <= noted(plant, "accessAddress") <= 309
    assert noted(plant, "imageErrors") == 0


def test_ob82_notes_the_module(plant):
    plant.stations["gw2"].slave.set_ext_diag(True)
    plant.run_for(20 * NS_PER_MS)
    plant.stations["gw2"].slave.set_ext_diag(False)
    plant.run_for(20 * NS_PER_MS)
    assert (noted(plant, "diagnoses"), noted(plant, "diagnosisAddress")) == (1, 300)
    assert plant.cpu.mode is CpuMode.RUN


def test_ob85_notes_the_address():
    catalog = load_catalog()
    text = PLANT.format(dialect="step7", plc="s7-400", more="")
    by_image = text.replace("per_identifier", "process_image")
    plant = build_plant(read_plant(Source("plant.yaml", by_image)), catalog, PlantSetup())
    plant.start()
    plant.run_for(200 * NS_PER_MS)
    plant.gateways["gw1"].power_off()
    plant.run_for(50 * NS_PER_MS)
    assert noted(plant, "imageErrors") > 0
    assert 256 <= noted(plant, "imageAddress") <= 265
    assert noted(plant, "accessErrors") == 0


@pytest.mark.parametrize(
    ("missing", "access"),
    [
        ("OB82", "per_identifier"),
        ("OB86", "per_identifier"),
        ("OB122", "per_identifier"),
        ("OB85", "process_image"),
    ],
)
def test_each_of_them_alone_keeps_the_cpu_running(missing: str, access: str):
    """With all but one of them the event of that one takes the CPU to STOP, and says why."""
    catalog = load_catalog()
    text = PLANT.format(dialect="tia", plc="s7-400", more="").replace("per_identifier", access)
    wanted = read_plant(Source("plant.yaml", text), catalog)
    sources = [
        Source(file.name, file.text)
        for file in generate(wanted, catalog).files
        if file.name != f"{missing}.scl"
    ]
    plant = build_plant(wanted, catalog, PlantSetup(sources=sources))
    plant.start()
    plant.run_for(200 * NS_PER_MS)
    assert plant.cpu.mode is CpuMode.RUN
    if missing == "OB82":
        plant.stations["gw2"].slave.set_ext_diag(True)
    else:
        plant.gateways["gw2"].power_off()
    plant.run_for(50 * NS_PER_MS)
    assert plant.cpu.mode is CpuMode.STOP
    assert missing in str(plant.cpu.diagnostics)
