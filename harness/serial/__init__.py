"""The simulated devices on a real port, in real time: the one place that reads the wall clock."""

from harness.serial.gateways import ServedGateways, gateways_to_serve
from harness.serial.ports import Port, SerialPort, profibus_port
from harness.serial.pseudo_terminal import PseudoTerminal
from harness.serial.serving import Server

__all__ = [
    "Port",
    "PseudoTerminal",
    "SerialPort",
    "ServedGateways",
    "Server",
    "gateways_to_serve",
    "profibus_port",
]
