"""Modules for serial lines (CM PtP, CM 1241, CP 340, CP 341, CP 440) and their instructions.

The line itself is `harness.line`. Sources: TIA Portal Information System, "Freeport communication"
and "PtP data link CP 341"; S7-1200 System Manual A5E02486680, 13.3 and 13.6.
"""

from harness.plc.serial.conditions import ReceiveConditions
from harness.plc.serial.module import SerialModule
from harness.plc.serial.ports import SerialPorts

__all__ = ["ReceiveConditions", "SerialModule", "SerialPorts"]
