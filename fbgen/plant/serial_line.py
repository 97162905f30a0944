"""A serial line in the plant file: drives on RS-485 at a communication module of the PLC."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog import Catalog, Located
from fbgen.catalog.scalars import Flag, Text, Whole
from fbgen.diagnostics import Diagnostic
from fbgen.plant import serial_checks
from fbgen.plant.drive import PlantDrive
from fbgen.plant.parameters import LineParameters

SerialModuleKind = Literal["cm_ptp", "cm_1241", "cp_340", "cp_341", "cp_440", "adapter"]
SerialProtocol = Literal["toshiba_binary", "toshiba_ascii", "modbus"]
ModbusFrames = Literal["instruction", "own"]
"""Who builds the frames of MODBUS: Modbus_Master of the CPU, or the blocks themselves."""


class SerialLine(Located):
    """One line with its module and its drives.

    Without `module` it is the usual one of the PLC. `hardware_identifier` is the port of the module
    on S7-1200 and S7-1500, `address` its start address on S7-300 and S7-400; an `adapter` of a PLC
    by IEC 61131-3 or TwinCAT needs neither. `protocol`: that of Toshiba in one of its two forms, or
    MODBUS-RTU. `baud`: bit/s of the line, as F800 of the drives. `parity`: that of the line, as
    F801 of them. `wires`: four where master and drives have a pair each. `status_poll`: read trip
    code and status of every drive in turn. `parameters`: first values of the line's parameters.
    `drives`: who is on the line.
    """

    name: str
    title: Text | None = None
    module: SerialModuleKind | None = None
    hardware_identifier: Annotated[Whole, Field(ge=1, le=65535)] | None = None
    address: Annotated[Whole, Field(ge=0, le=32767)] | None = None
    protocol: SerialProtocol = "toshiba_binary"
    baud: Whole = 19200
    parity: Literal["none", "even", "odd"] = "even"
    wires: Literal[2, 4] = 4
    status_poll: Flag = True
    parameters: LineParameters = Field(default_factory=LineParameters)
    drives: tuple[PlantDrive, ...] = Field(min_length=1)

    @property
    def family(self) -> Literal["toshiba", "modbus"]:
        """The protocol as the catalogue calls it."""
        return "modbus" if self.protocol == "modbus" else "toshiba"

    def problems(self) -> Iterable[Diagnostic]:
        """FB2006: one number for two drives."""
        return serial_checks.numbers_twice(self)

    def problems_against(self, known: object) -> Iterable[Diagnostic]:
        """What the catalogue says about this line."""
        assert isinstance(known, Catalog)
        return serial_checks.line(self, known)
