"""Plants with several DP master systems: more gateways than one PROFIBUS has addresses."""

import re

import pytest

from bench.generate import plant_text
from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source
from harness.installation import PlantSetup, build_plant


def _two_gateways(second_master: int) -> str:
    text = PLANT_OF_TWO.replace("MASTER", str(second_master))
    assert text.count("profibus_address: 2") == 2
    return text


PLANT_OF_TWO = """\
version: 1
name: two
dialect: tia
plc: s7-300
gateways:
  - {name: gw1, type: tospbdp001, layout: gsd10, profibus_address: 2, access: per_identifier,
     input_address: 256, output_address: 256,
     drives: [{name: a, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}]}
  - {name: gw2, type: tospbdp001, layout: gsd10, profibus_address: 2, dp_master: MASTER,
     access: per_identifier, input_address: 276, output_address: 276,
     drives: [{name: b, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}]}
"""


def test_an_address_may_stand_twice_in_two_dp_master_systems() -> None:
    catalog = load_catalog()
    found = read_plant(Source("plant.yaml", _two_gateways(2)), catalog)
    assert [gateway.dp_master for gateway in found.gateways] == [1, 2]
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", _two_gateways(1)), catalog)
    assert [item.code for item in failure.value.diagnostics] == ["FB2015"]


def test_stations_of_two_dp_master_systems_are_told_apart_by_the_error_block() -> None:
    catalog = load_catalog()
    files = generate(read_plant(Source("plant.yaml", _two_gateways(2)), catalog), catalog).files
    (text,) = [file.text for file in files if file.name == "OB86.scl"]
    assert "16#0000FFFF" in text
    assert re.search(r"(?m)^ +258:$", text)
    assert re.search(r"(?m)^ +514:$", text)


def test_two_dp_master_systems_are_not_simulated_together() -> None:
    catalog = load_catalog()
    two = read_plant(Source("plant.yaml", _two_gateways(2)), catalog)
    with pytest.raises(DiagnosticError) as failure:
        build_plant(two, catalog, PlantSetup())
    assert [item.code for item in failure.value.diagnostics] == ["FB7502"]


def test_a_plant_may_have_more_than_99_gateways() -> None:
    found = read_plant(Source("plant.yaml", plant_text(120)), load_catalog())
    assert len(found.gateways) == 120
    assert {gateway.dp_master for gateway in found.gateways} == {1, 2}
