"""Tags for an HMI: what an operator sees and sets, and the words that raise alarms.

The columns of the workbook are those of an export of HMI tags of WinCC Comfort and Advanced, V14
and later (published exports, and programs that write what these import). The connection is called
as TIA Portal calls the first one. Sequences are left out: they are for the program of the plant.
"""

from collections.abc import Iterator, Sequence

from fbgen.artefacts.spreadsheet import Sheet, workbook
from fbgen.artefacts.text_table import csv_table
from fbgen.artefacts.variables import PlcVariable
from fbgen.artefacts.view import PlantLists
from fbgen.emit.generated import Artefact

CONNECTION = "HMI_Connection_1"
_NOTHING = "<No Value>"
_CULTURES = {"en": "en-US", "de": "de-DE"}
_POLLED = ("valid", "lost", "tripped", "tripCode", "statusWord", "frequency", "current")
_COLUMNS_IN_FRONT = (
    "Name",
    "Path",
    "Connection",
    "PLC tag",
    "DataType",
    "Length",
    "Coding",
    "Access Method",
    "Address",
    "Indirect addressing",
    "Index tag",
    "Start value",
    "ID tag",
)
_COLUMNS_BEHIND = (
    "Acquisition mode",
    "Acquisition cycle",
    "Limit Upper 2 Type",
    "Limit Upper 2",
    "Limit Upper 1 Type",
    "Limit Upper 1",
    "Limit Lower 2 Type",
    "Limit Lower 2",
    "Limit Lower 1 Type",
    "Limit Lower 1",
    "Linear scaling",
    "End value PLC",
    "Start value PLC",
    "End value HMI",
    "Start value HMI",
    "Gmp relevant",
    "Confirmation Type",
    "Mandatory Commenting",
)
_LIMITS = ("Upper 2", "Upper 1", "Lower 2", "Lower 1")
_SAME = {
    "Connection": CONNECTION,
    "Coding": "Binary",
    "Access Method": "Symbolic access",
    "Address": _NOTHING,
    "Indirect addressing": "False",
    "Index tag": _NOTHING,
    "Start value": _NOTHING,
    "ID tag": "0",
    "Acquisition cycle": "1 s",
    **{f"Limit {which} Type": "None" for which in _LIMITS},
    **{f"Limit {which}": _NOTHING for which in _LIMITS},
    "Linear scaling": "False",
    "End value PLC": "10",
    "Start value PLC": "0",
    "End value HMI": "100",
    "Start value HMI": "0",
    "Gmp relevant": "False",
    "Confirmation Type": "None",
    "Mandatory Commenting": "False",
}
"""What stands in a column whatever the tag."""


def hmi_tags(lists: PlantLists) -> list[Artefact]:
    """The lists of the plant's dialect."""
    if lists.plant.dialect != "tia":
        return [Artefact(lists.file_name("hmi_tags.csv"), csv_table(_plain_rows(lists)))]
    book = workbook([_wincc_sheet(lists)])
    return [Artefact(lists.file_name("hmi_tags.xlsx"), book)]


def for_an_operator(lists: PlantLists) -> Iterator[PlcVariable]:
    """Everything of the lines; of the drives commands, states, polled values and alarm words."""
    for variable in lists.variables:
        owner, part = (*variable.path[1:3], "", "")[:2]
        if owner == "line":
            is_shown = part != "restart"
        elif part == "polled":
            is_shown = variable.path[3] in _POLLED
        else:
            is_shown = part in ("control", "state", "alarms")
        if is_shown:
            yield variable


def _wincc_sheet(lists: PlantLists) -> Sheet:
    """The sheet "Hmi Tags"."""
    culture = _CULTURES[lists.language]
    texts = (f"Display name [{culture}]", f"Comment [{culture}]")
    columns = (*_COLUMNS_IN_FRONT, *texts, *_COLUMNS_BEHIND)
    table = lists.name("TOS_").rstrip("_") or lists.plant.name
    same = _SAME | {"Path": table, texts[0]: _NOTHING}
    rows: list[Sequence[str]] = [columns]
    names = lists.tag_names
    for variable in for_an_operator(lists):
        is_alarm = variable.path[-1] == "alarms"
        rows.append(
            (
                names[variable],
                variable.name,
                variable.type_name,
                str(variable.size),
                variable.comment or _NOTHING,
                "Cyclic continuous" if is_alarm else "Cyclic in operation",
            )
        )
    return Sheet("Hmi Tags", rows, {columns.index(name): text for name, text in same.items()})


def _plain_rows(lists: PlantLists) -> list[list[str]]:
    rows = [["Name", "Variable", "Address", "Type", "Length", "Comment"]]
    for variable in for_an_operator(lists):
        rows.append(
            [
                lists.tag_names[variable],
                variable.name,
                lists.address(variable),
                variable.type_name,
                str(variable.size),
                variable.comment,
            ]
        )
    return rows
