"""The serial lines of a plant: communication modules, inverters straight on the line.

The module is set as the generated README says, or left to the program that sets it (MODBUS); the
inverters as the parameter sheets say: rate, parity and protocol of the line, their numbers, a
communication time-out above a round of the poll.
"""

from collections.abc import Mapping

from fbgen.catalog import Drive, SerialPort
from fbgen.plant import Plant, PlantDrive, SerialLine, port_of
from harness.kernel import Kernel
from harness.line import Line, Parity, SerialFormat, Topology
from harness.plc.serial import ReceiveConditions, SerialModule

_PARITIES = {"none": Parity.NONE, "even": Parity.EVEN, "odd": Parity.ODD}
_GAP_BITS = 44


def line_of(kernel: Kernel, entry: SerialLine) -> Line:
    """The wires."""
    return Line(kernel, Topology.FOUR_WIRE if entry.wires == 4 else Topology.TWO_WIRE)


def module_of(kernel: Kernel, plan: Plant, entry: SerialLine, line: Line) -> SerialModule:
    """The module of the PLC at its end of the line; as delivered where the program sets it."""
    if entry.family == "modbus" and plan.modbus_by_instruction:
        return SerialModule(kernel, line, SerialFormat(9600, Parity.NONE, 1), None, entry.name)
    own = SerialFormat(entry.baud, _PARITIES[entry.parity], 1)
    return SerialModule(kernel, line, own, ReceiveConditions(gap_bits=_GAP_BITS), entry.name)


def port_at(entry: SerialLine, series: Drive) -> SerialPort:
    """The port of an inverter that hangs on the line."""
    port = port_of(entry, series)
    assert port is not None, "checked when the plant was read"
    return port


def on_serial_line(
    entry: SerialLine, drive: PlantDrive, series: Drive, port: SerialPort, timeout_s: int
) -> Mapping[str, float]:
    """What is set at an inverter on the line."""
    parameters: dict[str, float] = {
        port.baud_rate: _code(series.baud_rates(port), entry.baud),
        port.parity: _code(series.parities(port), entry.parity),
        port.inv_no: drive.inv_no,
        port.timeout: timeout_s,
    }
    if port.protocol is not None:
        parameters[port.protocol] = _code(dict(port.protocols), entry.family)
    return parameters


def _code(values: Mapping[int, object], wanted: object) -> int:
    return next(code for code, value in values.items() if value == wanted)
