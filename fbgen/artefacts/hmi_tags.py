"""Tags for an HMI: what an operator sees and sets, and the words that raise alarms.

The columns of the workbook are those of an export of HMI tags of WinCC Comfort and Advanced, V14
and later (published exports, and programs that write what these import). The connection is called
as TIA Portal calls the first one. Sequences are left out: they are for the program of the plant.
"""

from collections.abc import Iterator

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
_LIMITS = ("None", _NOTHING) * 4
_UNSCALED = ("False", "10", "0", "100", "0", "False", "None", "False")


def hmi_tags(lists: PlantLists) -> list[Artefact]:
    """The lists of the plant's dialect."""
    if lists.plant.dialect != "tia":
        return [Artefact(lists.file_name("hmi_tags.csv"), csv_table(_plain_rows(lists)))]
    book = workbook([Sheet("Hmi Tags", wincc_rows(lists))])
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


def wincc_rows(lists: PlantLists) -> list[list[str]]:
    """The rows of the sheet "Hmi Tags", the names of the columns first."""
    culture = _CULTURES[lists.language]
    texts = (f"Display name [{culture}]", f"Comment [{culture}]")
    table = lists.name("TOS_").rstrip("_") or lists.plant.name
    rows = [[*_COLUMNS_IN_FRONT, *texts, *_COLUMNS_BEHIND]]
    for variable in for_an_operator(lists):
        is_alarm = variable.path[-1] == "alarms"
        rows.append(
            [
                lists.tag_names[variable],
                table,
                CONNECTION,
                variable.name,
                variable.type_name,
                str(variable.size),
                "Binary",
                "Symbolic access",
                *(_NOTHING, "False", _NOTHING, _NOTHING, "0", _NOTHING),
                variable.comment or _NOTHING,
                "Cyclic continuous" if is_alarm else "Cyclic in operation",
                "1 s",
                *_LIMITS,
                *_UNSCALED,
            ]
        )
    return rows


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
