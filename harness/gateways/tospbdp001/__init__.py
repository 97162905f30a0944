"""The simulated TOSPBDP001, a PROFIBUS DP gateway for Toshiba inverters."""

from harness.gateways.tospbdp001.from_catalog import tospbdp001_settings
from harness.gateways.tospbdp001.gateway import Tospbdp001
from harness.gateways.tospbdp001.leds import Fault, Leds, Light
from harness.gateways.tospbdp001.memory import Memory
from harness.gateways.tospbdp001.settings import (
    CyclicLayout,
    ErrorCode,
    ErrorCounter,
    OfflineInputs,
    OfflineOutputs,
    StartupLock,
    StatusToggle,
    SubnetErrorLed,
    TosSettings,
)
from harness.gateways.tospbdp001.status import StatusWord

__all__ = [
    "CyclicLayout",
    "ErrorCode",
    "ErrorCounter",
    "Fault",
    "Leds",
    "Light",
    "Memory",
    "OfflineInputs",
    "OfflineOutputs",
    "StartupLock",
    "StatusToggle",
    "StatusWord",
    "SubnetErrorLed",
    "TosSettings",
    "Tospbdp001",
    "tospbdp001_settings",
]
