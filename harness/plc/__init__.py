"""The simulated PLC: CPU, process image, access to the DP master, operating modes."""

from harness.plc.consistent_data import ConsistentData, RetVal
from harness.plc.cpu import Cpu, CpuMode, Restart
from harness.plc.error_events import ImageErrors
from harness.plc.link import MasterLink
from harness.plc.modules import ModuleTable, Mounting
from harness.plc.settings import CpuFamily, CpuSettings, DpInterface

__all__ = [
    "ConsistentData",
    "Cpu",
    "CpuFamily",
    "CpuMode",
    "CpuSettings",
    "DpInterface",
    "ImageErrors",
    "MasterLink",
    "ModuleTable",
    "Mounting",
    "Restart",
    "RetVal",
]
