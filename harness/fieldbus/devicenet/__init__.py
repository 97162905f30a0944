"""DeviceNet on the virtual clock: the bus, a slave with predefined connections, a scanner."""

from harness.fieldbus.devicenet.application import Application
from harness.fieldbus.devicenet.bus import CanBus, CanPort
from harness.fieldbus.devicenet.connection import Connection, ConnectionState
from harness.fieldbus.devicenet.scanner import ScanEntry, ScannedSlave, Scanner, SlaveState
from harness.fieldbus.devicenet.settings import Network, NodeSettings
from harness.fieldbus.devicenet.slave import DeviceNetSlave
from harness.fieldbus.devicenet.stranger import NodeWithMac

__all__ = [
    "Application",
    "CanBus",
    "CanPort",
    "Connection",
    "ConnectionState",
    "DeviceNetSlave",
    "Network",
    "NodeSettings",
    "NodeWithMac",
    "ScanEntry",
    "ScannedSlave",
    "Scanner",
    "SlaveState",
]
