"""The lists beside the PLC text, each read back by a program that we did not write."""

import re
from collections import Counter
from functools import cache

import pytest
from defusedxml.ElementTree import fromstring

from fbgen.artefacts.alarm_lists import wincc_rows
from fbgen.artefacts.view import PlantLists
from fbgen.blocks.alarms import LINE_ALARMS, drive_alarms, that_can_come
from fbgen.lang.checked import Program
from fbgen.plant import LANGUAGES, read_plant
from fbgen.source import Source
from harness.engine.loading import read_program
from harness.engine.path_types import type_at
from tests.unit.artefacts.reading import (
    TWO_GATEWAYS,
    data,
    generated,
    generated_anew,
    sheets,
    table,
)
from tests.unit.blocks.programs import shipped_catalog

DIALECTS = ["tia", "step7", "iec", "twincat", "plcopen"]


@cache
def program(dialect: str) -> Program:
    """The PLC text of a dialect, read back and checked."""
    files = generated(dialect=dialect).files
    return read_program([Source(f.name, f.text) for f in files if f.is_program], LANGUAGES[dialect])


def type_of(path: str, dialect: str = "tia") -> str:
    """The type of a variable of the PLC text; texts without their length."""
    return type_at(program(dialect), path).name.partition("[")[0]


def test_the_alarm_list_has_the_columns_of_an_export_of_wincc() -> None:
    (name, rows), *others = sheets(data("hall_alarms.xlsx")).items()
    assert (name, others) == ("DiscreteAlarms", [])
    assert list(rows[0]) == [
        "ID", "Name", "Alarm text [en-US], Alarm text", "FieldInfo [Alarm text]", "Class",
        "Trigger tag", "Trigger bit", "Acknowledgement tag", "Acknowledgement bit",
        "PLC acknowledgement tag", "PLC acknowledgement bit", "Group", "Report",
        "Info text [en-US], Info text",
    ]  # fmt: skip


def test_every_alarm_of_every_line_and_drive_stands_once_in_the_list() -> None:
    rows = sheets(data("hall_alarms.xlsx"))["DiscreteAlarms"]
    alarms_of_a_drive = drive_alarms(["start_forward", "read_current"])
    assert len(rows) == 2 * (len(LINE_ALARMS) - 1) + 3 * len(alarms_of_a_drive)
    assert [row["ID"] for row in rows] == [str(number + 1) for number in range(len(rows))]
    for column in ("Name", "Alarm text [en-US], Alarm text"):
        assert max(Counter(row[column] for row in rows).values()) == 1
    bits = Counter((row["Trigger tag"], row["Trigger bit"]) for row in rows)
    assert max(bits.values()) == 1
    assert {row["Class"] for row in rows} == {"Errors", "Warnings"}
    assert all(0 <= int(row["Trigger bit"]) <= 15 for row in rows)


def names_of_alarms(text: str) -> set[str]:
    return {row["Name"] for row in sheets(data("hall_alarms.xlsx", text))["DiscreteAlarms"]}


def test_an_alarm_that_can_never_come_stands_in_no_list() -> None:
    unpolled = TWO_GATEWAYS.replace(
        "    layout: doc9\n", "    layout: doc9\n    status_poll: false\n"
    )
    left_out = names_of_alarms(TWO_GATEWAYS) - names_of_alarms(unpolled)
    drives = ("pump", "fan")
    assert left_out == {f"south_{drive}_{name}" for drive in drives for name in ("tripped", "lost")}
    assert not any(name.endswith("io_error") for name in names_of_alarms(TWO_GATEWAYS))


def test_the_block_raises_what_some_list_has_and_nothing_else() -> None:
    catalog = shipped_catalog()
    plant = read_plant(Source("plant.yaml", TWO_GATEWAYS), catalog)
    one, other = plant.gateways
    silent = one.model_copy(update={"status_poll": False})
    whole = other.model_copy(update={"status_poll": False, "access": "dpxx_dat"})
    every = drive_alarms([])
    assert {alarm.name for alarm in that_can_come(every, [silent, other])} == {
        alarm.name for alarm in every
    }
    gone = {alarm.name for alarm in every} - {
        alarm.name for alarm in that_can_come(every, [silent])
    }
    assert gone == {"tripped", "lost"}
    assert that_can_come(LINE_ALARMS, [silent, whole]) == LINE_ALARMS
    text = next(file.text for file in generated().files if file.name == "TOS_Alarms.scl")
    assert "polled.lost" in text
    assert "ioError" not in text


def test_the_trip_of_a_drive_is_a_field_in_its_alarm() -> None:
    rows = {row["Name"]: row for row in sheets(data("hall_alarms.xlsx"))["DiscreteAlarms"]}
    trip = rows["north_infeed_tripped"]
    assert trip["Alarm text [en-US], Alarm text"] == (
        'Infeed, belt <1>: Drive has tripped: <field ref="0" />'
    )
    assert trip["FieldInfo [Alarm text]"] == (
        "<ref id = 0; type = AlarmTag; Tag = TOS_Plant_north_infeed_state_trip; "
        "DisplayType = Text; Length = 40;>"
    )
    assert rows["north_infeed_lost"]["FieldInfo [Alarm text]"] == "<No value>"


def test_the_csv_of_the_alarms_says_what_the_workbook_says() -> None:
    assert table(data("hall_alarms.csv")) == sheets(data("hall_alarms.xlsx"))["DiscreteAlarms"]


def test_a_german_plant_has_german_alarms_under_german_columns() -> None:
    catalog = shipped_catalog()
    plant = read_plant(Source("plant.yaml", TWO_GATEWAYS), catalog)
    rows = wincc_rows(PlantLists(plant, catalog, generated(), "de"))
    assert "Alarm text [de-DE], Alarm text" in rows[0]
    assert "Info text [de-DE], Info text" in rows[0]
    assert rows[1][2] == "Hall north: Gateway nimmt nicht teil"
    english = wincc_rows(PlantLists(plant, catalog, generated(), "en"))
    for one, other in zip(rows[1:], english[1:], strict=True):
        assert one[2] != other[2]
        assert (one[:2], one[3:13]) == (other[:2], other[3:13])


def test_every_tag_that_the_alarms_name_is_among_the_hmi_tags() -> None:
    tags = {row["Name"]: row for row in sheets(data("hall_hmi_tags.xlsx"))["Hmi Tags"]}
    for alarm in sheets(data("hall_alarms.xlsx"))["DiscreteAlarms"]:
        tag = tags[alarm["Trigger tag"]]
        assert (tag["DataType"], tag["Length"]) == ("Word", "2")
        assert tag["Acquisition mode"] == "Cyclic continuous"
        for named in re.findall(r"Tag = (\w+);", alarm["FieldInfo [Alarm text]"]):
            assert tags[named]["DataType"] == "String"


def test_every_hmi_tag_is_a_variable_of_the_program_with_that_type() -> None:
    rows = sheets(data("hall_hmi_tags.xlsx"))["Hmi Tags"]
    assert max(Counter(row["Name"].casefold() for row in rows).values()) == 1
    for row in rows:
        assert type_of(row["PLC tag"]) == row["DataType"].upper(), row["PLC tag"]


@pytest.mark.parametrize("dialect", DIALECTS[1:])
def test_other_dialects_have_the_same_alarms_and_tags_as_plain_tables(dialect: str) -> None:
    alarms = table(data("hall_alarms.csv", dialect=dialect))
    book = sheets(data("hall_alarms.xlsx"))["DiscreteAlarms"]
    assert [(row["Name"], row["Bit"]) for row in alarms] == [
        (row["Name"], row["Trigger bit"]) for row in book
    ]
    plain = table(data("hall_hmi_tags.csv", dialect=dialect))
    tags = {row["Variable"]: row["Type"] for row in plain}
    assert {row["Variable"] for row in alarms} <= set(tags)
    assert tags == {
        row["PLC tag"]: row["DataType"] for row in sheets(data("hall_hmi_tags.xlsx"))["Hmi Tags"]
    }


def test_an_absolute_address_of_step7_is_where_the_variable_lies() -> None:
    """An overlay of the classic layout, calculated by hand for one drive."""
    rows = {row["Variable"]: row for row in table(data("hall_hmi_tags.csv", dialect="step7"))}
    symbols = data("hall.sdf", dialect="step7").decode("ascii")
    number = re.search(r'"TOS_Plant +","DB +(\d+)', symbols)
    assert number
    block = f"DB{number[1]}"
    assert rows["TOS_Plant.north.line.emergencyStop"]["Address"] == f"{block}.DBX0.0"
    assert rows["TOS_Plant.north.line.online"]["Address"] == f"{block}.DBX0.2"
    assert rows["TOS_Plant.north.line.unreached"]["Address"] == f"{block}.DBW2"
    assert rows["TOS_Plant.north.line.alarms"]["Address"] == f"{block}.DBW10"
    assert rows["TOS_Plant.north.infeed.control.enable"]["Address"] == f"{block}.DBX12.0"
    assert rows["TOS_Plant.north.infeed.control.frequency"]["Address"] == f"{block}.DBD14"


def test_the_watch_table_names_variables_that_are_there() -> None:
    for gateway, drives in (("north", 1), ("south", 2)):
        root = fromstring(data(f"hall_watch_{gateway}.xml"))
        assert root.tag == "Document"
        (table_of_gateway,) = root.findall("SW.WatchAndForceTables.PlcWatchTable")
        names = [element.text or "" for element in table_of_gateway.iter("Name")]
        assert names[0] == f"hall_watch_{gateway}"
        assert len(names) == 1 + 8 + 19 * drives
        for name in names[1:]:
            assert type_of(name.replace('"', ""))
        numbers = [element.get("ID") for element in table_of_gateway.iter() if element.get("ID")]
        assert len(set(numbers)) == len(numbers)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_the_watch_list_names_variables_as_the_tool_spells_them(dialect: str) -> None:
    rows = table(data("hall_watch.csv", dialect=dialect))
    assert len(rows) == 2 * 8 + 3 * 19
    for row in rows:
        quoted = row["Watch"].startswith('"TOS_Plant".')
        assert quoted is (dialect in ("tia", "step7"))
        assert type_of(row["Watch"].replace('"', ""), dialect)
        assert bool(row["Address"]) is (dialect == "step7")


def test_plc_tags_are_as_tia_portal_exports_them_and_lie_where_the_plant_says() -> None:
    book = sheets(data("hall_plc_tags.xlsx"))
    assert list(book) == ["PLC Tags", "TagTable Properties"]
    rows = book["PLC Tags"]
    assert list(rows[0]) == [
        "Name", "Path", "Data Type", "Logical Address", "Comment",
        "Hmi Visible", "Hmi Accessible", "Hmi Writeable", "Typeobject ID", "Version ID",
    ]  # fmt: skip
    assert {row["Path"] for row in rows} == {book["TagTable Properties"][0]["Path"]}
    places = {row["Name"]: (row["Data Type"], row["Logical Address"]) for row in rows}
    assert len(places) == len(rows) == 2 * (5 + 6)
    assert places["north_in_status"] == ("Word", "%IW0")
    assert places["north_out_trigger"] == ("Byte", "%QB6")
    assert places["north_out_data"] == ("Word", "%QW12")
    assert places["south_out_data"] == ("Word", "%QW27")
    assert places["south_in_data"] == ("Word", "%IW26")


def test_located_variables_of_iec_text_are_explained_byte_by_byte() -> None:
    rows = {row["Name"]: row for row in table(data("hall_io.csv", dialect="twincat"))}
    declared = data("TOS_Globals.TcGVL", dialect="twincat").decode("utf-8")
    located = dict(re.findall(r"(\w+) AT (%[IQ]B\d+) : BYTE", declared))
    assert {name: row["Address"] for name, row in rows.items()} == located
    assert rows["IB0"]["Comment"] == "north: Status word, high byte"
    assert rows["QB13"]["Comment"] == "north: Data, low byte"


def test_symbols_for_step7_say_whether_they_lie_past_the_process_image() -> None:
    rows = {row["Name"]: row["Address"] for row in table(data("hall_io.csv", dialect="step7"))}
    assert (rows["north_in_status"], rows["south_out_trigger"]) == ("IW0", "QB22")


@pytest.mark.parametrize("dialect", DIALECTS)
def test_the_same_plant_gives_the_same_bytes(dialect: str) -> None:
    first, second = generated(dialect=dialect), generated_anew(TWO_GATEWAYS, dialect)
    assert first is not second
    assert first.contents == second.contents
