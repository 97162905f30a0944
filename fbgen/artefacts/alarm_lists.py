"""Alarm lists: for WinCC of TIA Portal as it imports discrete alarms, else a table for any HMI.

The columns of the workbook are those of an export of WinCC Comfort and Advanced, V14 and later
(published exports, and programs that write what these import); `Trigger bit` 0 is the lowest bit of
the word. The trip of a drive stands in its text by a parameter field.
"""

from fbgen.artefacts.spreadsheet import Sheet, workbook
from fbgen.artefacts.text_table import csv_table
from fbgen.artefacts.view import PlacedAlarm, PlantLists
from fbgen.emit.generated import Artefact

_NOTHING = "<No value>"
_CULTURES = {"en": "en-US", "de": "de-DE"}


def alarm_lists(lists: PlantLists) -> list[Artefact]:
    """The lists of the plant's dialect."""
    rows = wincc_rows(lists) if lists.plant.dialect == "tia" else _plain_rows(lists)
    table = Artefact(lists.file_name("alarms.csv"), csv_table(rows))
    if lists.plant.dialect != "tia":
        return [table]
    book = workbook([Sheet("DiscreteAlarms", rows)])
    return [Artefact(lists.file_name("alarms.xlsx"), book), table]


def wincc_rows(lists: PlantLists) -> list[list[str]]:
    """The rows of the sheet DiscreteAlarms, the names of the columns first."""
    culture = _CULTURES[lists.language]
    rows = [
        [
            "ID",
            "Name",
            f"Alarm text [{culture}], Alarm text",
            "FieldInfo [Alarm text]",
            "Class",
            "Trigger tag",
            "Trigger bit",
            "Acknowledgement tag",
            "Acknowledgement bit",
            "PLC acknowledgement tag",
            "PLC acknowledgement bit",
            "Group",
            "Report",
            f"Info text [{culture}], Info text",
        ]
    ]
    for number, placed in enumerate(lists.alarms(), start=1):
        text, field = _text_and_field(placed, lists)
        rows.append(
            [
                str(number),
                placed.name,
                text,
                field,
                placed.alarm.kind,
                lists.tag_names[placed.word],
                str(placed.alarm.bit),
                *(_NOTHING, "0", _NOTHING, "0", _NOTHING, "False"),
                placed.alarm.help(lists.language),
            ]
        )
    return rows


def _text_and_field(placed: PlacedAlarm, lists: PlantLists) -> tuple[str, str]:
    text = placed.text(lists.language)
    if not placed.alarm.shows_trip or placed.drive is None:
        return text, _NOTHING
    trip = lists.variable(placed.gateway.name, placed.drive.name, "state", "trip")
    field = (
        f"<ref id = 0; type = AlarmTag; Tag = {lists.tag_names[trip]}; "
        f"DisplayType = Text; Length = {trip.size};>"
    )
    return f'{text}: <field ref="0" />', field


def _plain_rows(lists: PlantLists) -> list[list[str]]:
    rows = [["ID", "Name", "Alarm text", "Class", "Variable", "Address", "Bit", "Info text"]]
    for number, placed in enumerate(lists.alarms(), start=1):
        rows.append(
            [
                str(number),
                placed.name,
                placed.text(lists.language),
                placed.alarm.kind,
                placed.word.name,
                lists.address(placed.word),
                str(placed.alarm.bit),
                placed.alarm.help(lists.language),
            ]
        )
    return rows
