"""The simulated devices on a real port, in real time: the one place that reads the wall clock."""

from harness.serial.asking import Asking, Heard
from harness.serial.bridge import LineBridge
from harness.serial.can_interfaces import CanInterface, can_interface
from harness.serial.can_log import CanLog
from harness.serial.commands import Commands
from harness.serial.control import ControlSocket
from harness.serial.drive_server import DriveServer
from harness.serial.drive_states import DriveState, drive_states
from harness.serial.drives import (
    DriveToServe,
    LineSetting,
    ServedDrives,
    line_setting,
    protocol_of,
    serial_port_of,
    serve_drives,
)
from harness.serial.fault_switches import FaultSwitches
from harness.serial.gateways import ServedGateways, gateways_to_serve
from harness.serial.line_log import HeardFrame, LineLog
from harness.serial.options import OptionServer
from harness.serial.pace import Pace
from harness.serial.ports import Port, SerialPort, has_speed, profibus_port, serial_port
from harness.serial.pseudo_terminal import PseudoTerminal
from harness.serial.real_drives import RealDrives, RealTime
from harness.serial.recording import Recording
from harness.serial.replaying import DriveReplay, Exchange, MasterReplay
from harness.serial.serving import Server
from harness.serial.traffic import Traffic, read_traffic, write_frame, write_head

__all__ = [
    "Asking",
    "CanInterface",
    "CanLog",
    "Commands",
    "ControlSocket",
    "DriveReplay",
    "DriveServer",
    "DriveState",
    "DriveToServe",
    "Exchange",
    "FaultSwitches",
    "Heard",
    "HeardFrame",
    "LineBridge",
    "LineLog",
    "LineSetting",
    "MasterReplay",
    "OptionServer",
    "Pace",
    "Port",
    "PseudoTerminal",
    "RealDrives",
    "RealTime",
    "Recording",
    "SerialPort",
    "ServedDrives",
    "ServedGateways",
    "Server",
    "Traffic",
    "can_interface",
    "drive_states",
    "gateways_to_serve",
    "has_speed",
    "line_setting",
    "profibus_port",
    "protocol_of",
    "read_traffic",
    "serial_port",
    "serial_port_of",
    "serve_drives",
    "write_frame",
    "write_head",
]
