"""The parameter sheets: what has to be set by hand, for this plant.

Sources: TOSPBDP001 manual v1.1, 3 (rotary switches), 6 (parameters), 7 (F113, F132).
"""

import csv
from io import StringIO

import pytest

from fbgen.artefacts import with_artefacts
from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source

PLANT = """
version: 1
name: hall
dialect: tia
plc: s7-1500
sequences: [{sequences}]
gateways:
  - name: gw1
    title: Hall 3
    type: tospbdp001
    layout: gsd10
    profibus_address: 47
    access: per_identifier
    input_address: 256
    output_address: 256
    drives:
      - {{name: pump, inv_no: 11, series: vf-s11, max_frequency_hz: 50.0}}
      - {{name: fan, title: "Fan | roof", inv_no: 3, series: vf-s11, max_frequency_hz: 62.5}}
"""


CHANNELS = """
version: 1
name: hall
dialect: tia
plc: s7-1500
gateways:
  - name: gw1
    type: pbdp110
    layout: module2
    profibus_address: 5
    access: dpxx_dat
    hardware_identifier: 270
    drives:
      - {name: pump, channel: A, series: vf-s11, max_frequency_hz: 50.0}
      - {name: fan, channel: B, series: g7, max_frequency_hz: 62.5}
"""


def sheets(sequences: str = "check_parameters") -> dict[str, str]:
    return made_for(PLANT.format(sequences=sequences))


def made_for(text: str) -> dict[str, str]:
    catalog = load_catalog()
    plant = read_plant(Source("plant.yaml", text), catalog)
    made = with_artefacts(generate(plant, catalog), plant, catalog)
    found = {item.name: item.data for item in made.artefacts}
    return {name: data.decode("utf-8-sig") for name, data in found.items() if "parameters" in name}


@pytest.fixture(scope="module")
def made() -> dict[str, str]:
    return sheets()


def table(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(StringIO(text)))


def test_each_drive_has_its_rows(made: dict[str, str]) -> None:
    rows = table(made["hall_parameters.csv"])
    values = {(row["drive"], row["parameter"]): (row["value"], row["word"]) for row in rows}
    assert values["pump", "F800"] == ("4", "0004")
    assert values["pump", "F801"] == ("1", "0001")
    assert values["pump", "F802"] == ("11", "000B")
    assert values["fan", "F802"] == ("3", "0003")
    assert values["pump", "F803"] == ("1", "0001")
    assert values["fan", "FH"] == ("62.5", "186A")
    assert values["pump", "F113"] == ("45", "002D")
    assert values["pump", "F132"] == ("10", "000A")


def test_what_the_machine_decides_has_no_value(made: dict[str, str]) -> None:
    rows = {row["parameter"]: row for row in table(made["hall_parameters.csv"])}
    assert (rows["CMOd"]["value"], rows["FMOd"]["word"]) == ("", "")
    assert "bit 15" in rows["CMOd"]["why"]


def test_the_rows_that_the_plc_reads_back_are_marked(made: dict[str, str]) -> None:
    rows = table(made["hall_parameters.csv"])
    marked = {row["parameter"] for row in rows if row["compared"]}
    assert marked == {"F800", "F801", "F802", "F803", "FH"}
    assert not any(row["compared"] for row in table(sheets("stop")["hall_parameters.csv"]))


def test_every_row_names_its_source(made: dict[str, str]) -> None:
    assert all("manual" in row["source"] for row in table(made["hall_parameters.csv"]))


def test_the_sheet_shows_the_rotary_switches_of_the_address(made: dict[str, str]) -> None:
    text = made["hall_parameters.md"]
    assert "PROFIBUS address 47" in text
    assert "| A | upper rotary switch | **7** |" in text
    assert "| B | lower rotary switch | **4** |" in text
    assert "| SW5 | rotary switch of the option board RS4003Z | 0: " in text


def test_the_sheet_is_a_table_whatever_the_titles_say(made: dict[str, str]) -> None:
    rows = [line for line in made["hall_parameters.md"].splitlines() if line.startswith("|")]
    assert rows
    assert {row.replace("\\|", "").count("|") for row in rows} <= {5, 8}


LINE = """
version: 1
name: hall
dialect: tia
plc: s7-1500
sequences: [check_parameters]
serial:
  - name: line1
    hardware_identifier: 270
    protocol: modbus
    baud: 38400
    parity: odd
    drives:
      - {name: pump, inv_no: 7, series: vf-as1, max_frequency_hz: 50.0}
"""


def test_on_a_serial_line_a_sheet_is_that_of_the_line_and_of_its_port() -> None:
    rows = {row["parameter"]: row for row in table(made_for(LINE)["hall_parameters.csv"])}
    values = {name: row["value"] for name, row in rows.items()}
    assert values == {
        **{"F820": "2", "F801": "2", "F802": "7", "F803": "1", "F829": "1", "F804": "", "FH": "50"}
    }
    assert {name for name, row in rows.items() if row["compared"]} == values.keys() - {"F804"}
    assert "unverified" in rows["F820"]["why"]
    assert "unverified" not in rows["F802"]["why"]
    of_s11 = made_for(LINE.replace("vf-as1", "vf-s11").replace("baud: 38400", "baud: 19200"))
    known = {row["parameter"]: row for row in table(of_s11["hall_parameters.csv"])}
    # 19200 bit/s is documented, odd parity is not
    assert "unverified" not in known["F800"]["why"]
    assert "unverified" in known["F801"]["why"]
    assert "CM PtP RS422/485; 19200 bit/s" in of_s11["hall_parameters.md"]
    assert "Err5" in rows["F804"]["why"]


def test_behind_a_gateway_for_process_data_nothing_of_the_line_is_asked_for() -> None:
    pump, fan = made_for(CHANNELS)["hall_parameters.md"].split("## Drive ")[1:]
    assert "| FH | 0011 | **50** Hz |" in pump
    assert "RS4003Z" not in pump
    assert "F80" not in pump
    # a series of which no document at hand tells
    assert "No document at hand says" in fan
    assert "**62.5** Hz" in fan
    assert "|" not in fan
