"""Simulated inverters: state machine, ramps, load, registers, trips and their serial port."""

from harness.drives.inverter import COMMUNICATION_ERROR, EMERGENCY_STOP, Inverter
from harness.drives.load import Load, LoadShape, Motor
from harness.drives.operation import Mode, Panel
from harness.drives.settings import InverterSettings, ReplyTime, set_for_line

__all__ = [
    "COMMUNICATION_ERROR",
    "EMERGENCY_STOP",
    "Inverter",
    "InverterSettings",
    "Load",
    "LoadShape",
    "Mode",
    "Motor",
    "Panel",
    "ReplyTime",
    "set_for_line",
]
