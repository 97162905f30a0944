"""The simulated RS-485 line between a gateway or PLC and its inverters."""

from harness.line.disturbance import Disturbance, Interference, Rate
from harness.line.medium import Line, Node, Pair, Port, Role, Topology
from harness.line.serial_format import (
    DRIVE_FORMAT,
    FRAMING_ERROR,
    GATEWAY_FORMAT,
    PARITY_ERROR,
    Parity,
    SerialFormat,
)
from harness.line.spacing import Spacing, TooClose
from harness.line.transmission import Reception, Transmission

__all__ = [
    "DRIVE_FORMAT",
    "Disturbance",
    "FRAMING_ERROR",
    "GATEWAY_FORMAT",
    "Interference",
    "Line",
    "Node",
    "PARITY_ERROR",
    "Pair",
    "Parity",
    "Port",
    "Rate",
    "Reception",
    "Role",
    "SerialFormat",
    "Spacing",
    "TooClose",
    "Topology",
    "Transmission",
]
