"""How the line at a serial port is set, for the commands that open one."""

from collections.abc import Sequence
from enum import Enum
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from fbgen.catalog import Drive
    from harness.serial import LineSetting

PortOption = Annotated[
    str, typer.Option("--port", metavar="P", help="COM3, /dev/ttyUSB0, or an address of pyserial.")
]


PortIfAnyOption = Annotated[
    str | None,
    typer.Option("--port", metavar="P", help="COM3, /dev/ttyUSB0, or an address of pyserial."),
]
PtyOption = Annotated[
    bool, typer.Option("--pty", help="Make a pseudo terminal and print its name (Linux).")
]


class ProtocolName(Enum):
    """The protocols of a line."""

    TOSHIBA = "toshiba"
    MODBUS = "modbus"


class ParityName(Enum):
    """The parities of a line."""

    NONE = "none"
    EVEN = "even"
    ODD = "odd"


ProtocolOption = Annotated[
    ProtocolName | None,
    typer.Option("--protocol", help="Language of the line; else that of the series."),
]
BaudOption = Annotated[
    int | None,
    typer.Option("--baud", metavar="N", help="Speed in bit/s; else that of a new inverter."),
]
ParityOption = Annotated[
    ParityName | None, typer.Option("--parity", help="Parity; else that of a new inverter.")
]


def asked_setting(
    drives: "Sequence[Drive]",
    protocol: ProtocolName | None,
    baud: int | None,
    parity: ParityName | None,
    wired: str | None = None,
) -> "LineSetting":
    """The setting that these options ask for. Raises DiagnosticError FB9035."""
    from harness.line import Parity
    from harness.serial import line_setting

    return line_setting(
        drives,
        None if protocol is None else protocol.value,
        baud,
        None if parity is None else Parity[parity.name],
        wired,
    )
