"""The lists and the README of a plant with DeviceNet, read back."""

import re
from pathlib import Path

import pytest

from fbgen.blocks.dev_alarms import DEV_DRIVE_ALARMS, NETWORK_ALARMS
from fbgen.emit.generator import generate
from fbgen.plant import in_dialect, read_plant
from fbgen.source import Source
from tests.unit.artefacts.reading import data, sheets, table
from tests.unit.artefacts.test_german_lists import ENGLISH
from tests.unit.blocks.programs import shipped_catalog

ROOT = Path(__file__).parents[3]
PLANT = (ROOT / "tests" / "scenarios" / "devicenet" / "all_assemblies.yaml").read_text("utf-8")
GERMAN = f"{PLANT}language: de\n"
NAMES = re.compile("(Ctrl|Ref) from Net|Drive Status")
"""What is called so in every language."""
LISTS = ("alarms.csv", "parameters.csv", "watch.csv", "io.csv")


def test_every_byte_of_a_drive_is_named_the_low_one_first() -> None:
    rows = {
        row["Address"]: row["Comment"] for row in table(data("all_assemblies_io.csv", PLANT, "iec"))
    }
    assert rows["%IB64"] == "net1: who exchanges data: MAC ID 1, 3, 4, 5"
    assert rows["%IB71"] == "net1: who exchanges data: MAC ID 63"
    assert rows["%QB110"] == "extended: Control, low byte"
    assert rows["%QB111"] == "extended: Control, high byte"
    assert rows["%IB176"] == "both: What c026 chooses, low byte"
    assert len(rows) == 3 + 2 * (4 + 4 + 4 + 8 + 12 + 18)


def test_a_sheet_has_the_assemblies_and_what_the_plant_file_sets() -> None:
    rows = table(data("all_assemblies_parameters.csv", PLANT))
    of = {
        name: {row["parameter"]: row["value"] for row in rows if row["drive"] == name}
        for name in ("basic", "extended", "both")
    }
    assert of["basic"] == {"c203": "0", "FH": "60", "CMOd": "4", "FMOd": "7"}
    assert of["extended"] == {"c203": "1", "FH": "60"}
    assert of["both"] == {
        **{"c203": "5", "FH": "60"},
        **{"c002": "1", "c006": "3", "c022": "1", "c026": "2"},
    }
    assert {row["INV-NO"] for row in rows if row["drive"] == "both"} == {"MAC ID 63"}


def test_every_alarm_of_network_and_drives_stands_in_the_list() -> None:
    rows = sheets(data("all_assemblies_alarms.xlsx", PLANT))["DiscreteAlarms"]
    assert len(rows) == len(NETWORK_ALARMS) + 6 * len(DEV_DRIVE_ALARMS)
    assert (
        rows[0]["Alarm text [en-US], Alarm text"] == "net1: Scanner finds no drive of the network"
    )


def test_a_readme_says_where_the_bytes_lie_and_what_assemblies_lack() -> None:
    text = data("README.md", PLANT).decode("utf-8")
    assert "| net1 | 500 kbit/s | 0 | IB64 - IB71: bit N % 8 of byte N / 8 for MAC ID N |" in text
    assert (
        "| net1 | both | 63 | 105/155 | polled | 100 ms | IB160 - IB177 | QB160 - QB177 |" in text
    )
    assert "**basic: assemblies 20/70 have no bits that take the command.**" in text
    assert "**basic, extended, channel: no emergency stop" in text
    assert "| 840D |" in text
    assert "PROFIBUS" not in text


@pytest.mark.parametrize("name", LISTS)
def test_no_english_is_left_in_a_german_list(name: str) -> None:
    text = data(f"all_assemblies_{name}", GERMAN, "iec")
    left = {
        word
        for row in table(text)
        for column in row
        if column not in ("Quelle", "Watch", "Name", "Variable")
        for word in NAMES.sub("", row[column]).lower().split()
        if word in ENGLISH
    }
    assert not left


def test_gateways_lines_and_networks_are_in_one_plant() -> None:
    gateway = (ROOT / "examples" / "five_drives" / "plant.yaml").read_text("utf-8")
    serial = (ROOT / "examples" / "serial" / "plant.yaml").read_text("utf-8")
    both = serial + gateway[gateway.index("gateways:") :]
    text = both.replace("per_identifier", "process_image") + PLANT[PLANT.index("devicenet:") :]
    plant = read_plant(Source("plant.yaml", text), shipped_catalog())
    for dialect in ("step7", "iec"):
        there = in_dialect(plant, dialect, shipped_catalog())
        assert generate(there, shipped_catalog()).files
    rows = table(data(f"{plant.name}_watch.csv", text))
    units = {row["Watch"].split(".")[1] for row in rows}
    assert units == {item.name for item in plant.units}
