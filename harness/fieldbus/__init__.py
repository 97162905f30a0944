"""The simulated PROFIBUS DP: its master with the cycle, and slaves, for a real master as well."""

from fbgen.wire.dp import ControlCommand
from harness.fieldbus.cycle import CycleGrid, CycleTimes
from harness.fieldbus.master import DpMaster, MasterMode
from harness.fieldbus.parameters import (
    Lock,
    Parameters,
    SlaveType,
    decode_parameters,
    watchdog_factors,
)
from harness.fieldbus.responder import Responder
from harness.fieldbus.segment import Segment
from harness.fieldbus.slave import NO_MASTER, DpDevice, DpSlave, SlaveState
from harness.fieldbus.station import Station, StationSettings, StationState, Transfer

__all__ = [
    "ControlCommand",
    "CycleGrid",
    "CycleTimes",
    "DpDevice",
    "DpMaster",
    "DpSlave",
    "Lock",
    "MasterMode",
    "NO_MASTER",
    "Parameters",
    "Responder",
    "Segment",
    "SlaveState",
    "SlaveType",
    "Station",
    "StationSettings",
    "StationState",
    "Transfer",
    "decode_parameters",
    "watchdog_factors",
]
