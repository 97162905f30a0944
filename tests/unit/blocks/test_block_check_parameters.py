"""Steps `check:`: what a sequence does with a ComNo that is not as it is to be."""

from pathlib import Path

import pytest

from fbgen.catalog import Catalog, load_catalog, with_own_sequences
from fbgen.diagnostics import DiagnosticError
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source

SEQUENCE = """
version: 1
id: look
title: Look
description: Looks.
does_not_protect: This is no safety function.
source: written for this test
series: [vf-s11]
steps:
{steps}
"""


GATEWAY = """
version: 1
name: hall
dialect: tia
plc: s7-1500
sequences: [look]
gateways:
  - name: gw1
    type: tospbdp001
    layout: gsd10
    profibus_address: 2
    access: per_identifier
    input_address: 256
    output_address: 256
    drives:
      - {name: mixer, inv_no: 11, series: vf-s11, max_frequency_hz: 50.0}
"""
LINES = """
version: 1
name: hall
dialect: tia
plc: s7-1500
sequences: [look]
serial:
  - name: line1
    hardware_identifier: 270
    protocol: modbus
    parity: odd
    drives:
      - {{name: pump, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}}
{second}
"""
SECOND = """
  - name: line2
    hardware_identifier: 271
    protocol: modbus
    parity: none
    drives:
      - {name: fan, inv_no: 2, series: vf-s11, max_frequency_hz: 50.0}
"""


def of_plant(catalog: Catalog, text: str) -> str:
    plant = read_plant(Source("hall.yaml", text), catalog)
    return "\n".join(file.text for file in generate(plant, catalog).files)


def own(folder: Path, *steps: str) -> Catalog:
    (folder / "sequences").mkdir()
    text = SEQUENCE.format(steps="\n".join(f"  - {step}" for step in steps))
    (folder / "sequences" / "look.yaml").write_text(text, encoding="utf-8")
    return with_own_sequences(load_catalog(), folder)


def finding(folder: Path, *steps: str) -> tuple[str, int, str]:
    with pytest.raises(DiagnosticError) as caught:
        own(folder, *steps)
    (found,) = caught.value.diagnostics
    assert found.span is not None
    return found.code, found.span.line - 10, found.message


def test_what_is_set_at_every_inverter_needs_no_value(tmp_path: Path) -> None:
    assert own(tmp_path, "check: baud_rate", "check: F802".replace("F802", "0802"))


def test_anything_else_needs_one(tmp_path: Path) -> None:
    code, line, message = finding(tmp_path, "check: parity", "check: acceleration_time")
    assert (code, line) == ("FB1107", 1)
    assert "acceleration_time" in message


def test_a_setting_that_is_not_for_all_needs_one_too(tmp_path: Path) -> None:
    assert finding(tmp_path, "check: input_function_res")[0] == "FB1107"


def test_a_value_has_to_be_one_of_the_comno(tmp_path: Path) -> None:
    assert finding(tmp_path, "{check: acceleration_time, equals: 7000.0}")[:2] == ("FB1107", 0)


def test_one_comno_is_checked_once(tmp_path: Path) -> None:
    code, line, message = finding(tmp_path, "check: parity", 'check: "0801"')
    assert (code, line) == ("FB1102", 1)
    assert "twice" in message


def test_what_the_sheet_has_is_not_checked_a_second_time(tmp_path: Path) -> None:
    code, line, message = finding(tmp_path, "check: parity", "check_settings: all")
    assert (code, line) == ("FB1102", 1)
    assert "0801" in message


@pytest.mark.parametrize("steps", [["check: parity", "check: baud_rate"], ["check_settings: all"]])
def test_behind_a_gateway_the_values_are_those_of_the_series(
    steps: list[str], tmp_path: Path
) -> None:
    text = of_plant(own(tmp_path, *steps), GATEWAY)
    assert "#expected_0800 := 16#0004;" in text
    assert "#expected_0801 := 16#0001;" in text
    assert "wanted_" not in text
    assert "0829" not in text


def test_on_one_line_the_values_are_those_of_the_line(tmp_path: Path) -> None:
    catalog = own(tmp_path, "check: parity", 'check: "0829"')
    text = of_plant(catalog, LINES.format(second=""))
    assert "#expected_0801 := 16#0002;" in text
    assert "#expected_0829 := 16#0001;" in text
    assert "wanted_" not in text


def test_what_differs_from_line_to_line_is_handed_over(tmp_path: Path) -> None:
    text = of_plant(own(tmp_path, "check_settings: all"), LINES.format(second=SECOND))
    assert "#expected_0801 := #wanted_0801;" in text
    assert text.count("wanted_0801 := 16#0002") == 1
    assert text.count("wanted_0801 := 16#0000") == 1
    # the same on both
    assert "#expected_0829 := 16#0001;" in text


def test_what_not_all_sheets_have_is_left_out(tmp_path: Path) -> None:
    both = GATEWAY + LINES.format(second="")[LINES.index("serial:") :]
    text = of_plant(own(tmp_path, "check_settings: all"), both)
    assert "expected_0800" in text
    assert "expected_0829" not in text


def test_a_value_that_no_line_of_the_plant_gives_is_told(tmp_path: Path) -> None:
    catalog = own(tmp_path, "check: protocol_selection")
    with pytest.raises(DiagnosticError) as caught:
        of_plant(catalog, GATEWAY)
    (found,) = caught.value.diagnostics
    assert found.code == "FB1107"
    assert "0829" in found.message
    assert "'gw1'" in found.message


def test_a_comno_has_to_be_there(tmp_path: Path) -> None:
    assert finding(tmp_path, "check: no_such_comno")[:2] == ("FB1105", 0)
