"""What to watch while a plant is taken into service: a table for each gateway.

For TIA Portal the table is SimaticML as Openness exports and imports it (`SW.WatchAndForceTables`;
published exports of V18 and V21, which hold no more than a name where the rest is the default). For
all tools there is the same as CSV: the column `Watch` can be pasted into a watch table.
"""

from collections.abc import Iterable, Iterator, Sequence
from html import escape

from fbgen.artefacts.text_table import csv_table
from fbgen.artefacts.variables import PlcVariable
from fbgen.artefacts.view import PlantLists
from fbgen.emit.generated import Artefact
from fbgen.plant import DeviceNetNetwork, PlantUnit, SerialLine

_LINE = ("online", "ioError", "ioRetVal", "gatewayFault", "errorCount", "emergencyStop", "stopped")
_CONTROL = ("enable", "interlock", "run", "reverse", "frequency", "reset")
_STATE = ("ready", "running", "tripped", "inhibited", "status", "command", "trip")
_POLLED = ("valid", "lost", "statusWord", "frequency", "current")
_DRIVE = (
    *(("control", name) for name in _CONTROL),
    *(("state", name) for name in _STATE),
    *(("polled", name) for name in _POLLED),
    ("alarms",),
)
_PBDP_LINE = ("online", "ioError", "ioRetVal", "emergencyStop", "stopped")
_SERIAL_LINE = ("online", "portStatus", "errorCount", "emergencyStop", "stopped")
_PBDP_STATE = (
    *("online", "ready", "running", "tripped", "inhibited", "status", "command"),
    *("frequency", "current", "trip"),
)
_PBDP_DRIVE = (
    *(("control", name) for name in _CONTROL),
    *(("state", name) for name in _PBDP_STATE),
    ("polled", "tripCode"),
    ("alarms",),
)
_DEV_LINE = ("online", "emergencyStop", "stopped")
_DEV_STATE = (
    *("online", "ready", "running", "atSetpoint", "tripped", "warning", "inhibited"),
    *("controlFromNet", "referenceFromNet", "status", "command"),
    *("frequency", "speed", "text", "trip"),
)
_DEV_DRIVE = (
    *(("control", name) for name in (*_CONTROL, "speed")),
    *(("state", name) for name in _DEV_STATE),
    ("polled", "tripCode"),
    ("alarms",),
)
_FORMATS = {"Bool": "Bool", "Real": "Floating-point", "Int": "DEC", "Time": "Time", "String": "-"}


def watch_tables(lists: PlantLists) -> list[Artefact]:
    """The tables of the plant's dialect."""
    tables = {gateway.name: list(watched(lists, gateway)) for gateway in lists.plant.units}
    found = [Artefact(lists.file_name("watch.csv"), csv_table(_rows(lists, tables.values())))]
    if lists.plant.dialect == "tia":
        for gateway, table in tables.items():
            name = lists.file_name(f"watch_{gateway}")
            found.append(Artefact(f"{name}.xml", _simatic_ml(name, table).encode("ascii")))
    return found


def watched(lists: PlantLists, gateway: PlantUnit) -> Iterator[PlcVariable]:
    """The variables of the line and its drives that show what goes on."""
    line: tuple[str, ...] = _LINE
    of_drive: tuple[tuple[str, ...], ...] = _DRIVE
    if isinstance(gateway, SerialLine):
        line = _SERIAL_LINE
    elif isinstance(gateway, DeviceNetNetwork):
        line, of_drive = _DEV_LINE, _DEV_DRIVE
    elif lists.is_process_data(gateway):
        line, of_drive = _PBDP_LINE, _PBDP_DRIVE
    for name in line:
        yield lists.variable(gateway.name, "line", name)
    yield lists.variable(gateway.name, "line", "alarms")
    for drive in gateway.drives:
        for path in of_drive:
            yield lists.variable(gateway.name, drive.name, *path)


def _rows(lists: PlantLists, tables: Iterable[Sequence[PlcVariable]]) -> list[list[str]]:
    quoted = lists.plant.dialect in ("tia", "step7")
    rows = [["Watch", "Address", "Display format", "Comment"]]
    for table in tables:
        for variable in table:
            rows.append(
                [
                    variable.quoted if quoted else variable.name,
                    lists.address(variable),
                    _FORMATS.get(variable.type_name, "HEX"),
                    variable.comment,
                ]
            )
    return rows


def _simatic_ml(name: str, table: Sequence[PlcVariable]) -> str:
    entries = "".join(
        f'      <SW.WatchAndForceTables.PlcWatchTableEntry ID="{number:X}" '
        'CompositionName="Entries">\n'
        "        <AttributeList>\n"
        f"          <Name>{escape(variable.quoted, quote=False)}</Name>\n"
        "        </AttributeList>\n"
        "      </SW.WatchAndForceTables.PlcWatchTableEntry>\n"
        for number, variable in enumerate(table, start=1)
    )
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n'
        "<Document>\n"
        '  <Engineering version="V17" />\n'
        '  <SW.WatchAndForceTables.PlcWatchTable ID="0">\n'
        "    <AttributeList>\n"
        f"      <Name>{name}</Name>\n"
        "    </AttributeList>\n"
        f"    <ObjectList>\n{entries}    </ObjectList>\n"
        "  </SW.WatchAndForceTables.PlcWatchTable>\n"
        "</Document>\n"
    )
