"""A serial line of the PLC as its templates see it."""

from fbgen.blocks.gateways import FirstValue, UnitView
from fbgen.blocks.line_gateways import DriveView, drive_values, drive_view
from fbgen.blocks.literals import SclText, milliseconds, truth
from fbgen.blocks.serial_times import SerialTimes, serial_times
from fbgen.catalog import Catalog, origin
from fbgen.dataclass import dataclass
from fbgen.plant import Plant, SerialLine, buffer_numbers, module_of, place_of

_PORT_KINDS = {
    **{"cm_ptp": "freeport", "cm_1241": "freeport"},
    **{"cp_340": "cp34x", "cp_341": "cp34x", "cp_440": "cp34x", "adapter": "adapter"},
}
"""Module of the plant file -> the template that reaches it."""
_PARITIES = {"none": 0, "odd": 1, "even": 2}
_LINE_MODES = {4: 1, 2: 4}
"""Wires -> MODE of Modbus_Comm_Load: four, point-to-point, and two. Source: S7-1200 System Manual
A5E02486680, table 13-72; TIA Portal Information System, "RS422 mode (S7-1500)": mode 2, multipoint
master, is of the CM PtP of an ET 200SP alone. The module is the only one that sends on its pair."""


_INSTRUCTIONS = {
    "cp_340": ("P_SEND", "P_RCV"),
    "cp_341": ("P_SND_RK", "P_RCV_RK"),
    "cp_440": ("SEND_440", "RECV_440"),
}
"""What sends and receives at modules whose instructions take a data block by number."""


def instructions_of(module: str) -> tuple[str, str]:
    """Those of a module, to send and to receive; empty names where the template knows them."""
    return _INSTRUCTIONS.get(module, ("", ""))


@dataclass(frozen=True, slots=True)
class SerialLineView(UnitView):
    """A line with everything its blocks need; `port_kind` is the template of its module.

    `buffer_number` is that of the data block that a CP 340, CP 341 or CP 440 works with. `baud`,
    `parity` and `line_mode` are what Modbus_Comm_Load takes.
    """

    port_kind: str
    port: SclText
    send_instruction: str
    receive_instruction: str
    buffer_number: SclText
    baud: SclText
    parity: SclText
    line_mode: SclText
    ascii: SclText
    status_poll: bool
    timeout: SclText
    gap: SclText
    silence: SclText
    times: SerialTimes
    drives: tuple[DriveView, ...]
    line_block: str
    poll_block: str
    drive_block: str = "TIP_Drive"
    alarms_block: str = "TIP_Alarms"


def port_kind(plant: Plant, line: SerialLine) -> str:
    """Which template in `templates/ports` reaches the module of a line."""
    if line.family == "modbus" and plant.modbus_by_instruction:
        return "modbus_master"
    return _PORT_KINDS[module_of(line, plant.plc)]


def serial_line_view(plant: Plant, line: SerialLine, catalog: Catalog) -> SerialLineView:
    """What the templates of one line are told."""
    place = origin(f"serial line {line.name}", line)
    times = serial_times(plant, line, catalog)
    timeout = milliseconds(times.timeout_ms, place)
    modbus = line.family == "modbus"
    module = module_of(line, plant.plc)
    return SerialLineView(
        name=line.name,
        block=f"TIP_Serial_{line.name}",
        drives_type=f"typeTipSerial_{line.name}",
        params_type=f"typeTipParam_{line.name}",
        first_values=(
            FirstValue("line.timeout", timeout),
            FirstValue("line.retries", SclText(str(line.parameters.retries), place)),
            *(value for drive in line.drives for value in drive_values(drive)),
        ),
        port_kind=port_kind(plant, line),
        send_instruction=instructions_of(module)[0],
        receive_instruction=instructions_of(module)[1],
        buffer_number=SclText(
            str(buffer_numbers(plant).get(f"TIP_Buffer_{line.name}", 0)),
            origin("block_numbers", plant.block_numbers),
        ),
        baud=SclText(str(line.baud), place),
        parity=SclText(str(_PARITIES[line.parity]), place),
        line_mode=SclText(str(_LINE_MODES[line.wires]), place),
        port=SclText(str(place_of(line, plant) or 0), place),
        ascii=truth(line.protocol == "toshiba_ascii", place),
        status_poll=line.status_poll,
        timeout=timeout,
        gap=milliseconds(times.gap_ms, place),
        silence=milliseconds(times.silence_ms, place),
        times=times,
        drives=tuple(drive_view(item) for item in line.drives),
        line_block="MB_Line" if modbus else "TIP_Line",
        poll_block="MB_StatusPoll" if modbus else "TOS_StatusPoll",
    )
