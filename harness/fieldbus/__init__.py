"""The simulated PROFIBUS DP: the master with its cycle, and slaves."""

from harness.fieldbus.cycle import CycleGrid, CycleTimes
from harness.fieldbus.master import DpMaster, MasterMode
from harness.fieldbus.parameters import Parameters, SlaveType, watchdog_factors
from harness.fieldbus.slave import ControlCommand, DpDevice, DpSlave, SlaveState
from harness.fieldbus.station import Station, StationSettings, StationState, Transfer

__all__ = [
    "ControlCommand",
    "CycleGrid",
    "CycleTimes",
    "DpDevice",
    "DpMaster",
    "DpSlave",
    "MasterMode",
    "Parameters",
    "SlaveState",
    "SlaveType",
    "Station",
    "StationSettings",
    "StationState",
    "Transfer",
    "watchdog_factors",
]
