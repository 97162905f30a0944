"""The simulated PBDP-110, a PROFIBUS DP interface for two Toshiba drives."""

from harness.gateways.pbdp110.from_catalog import drive_facts, pbdp110_settings
from harness.gateways.pbdp110.gateway import Pbdp110
from harness.gateways.pbdp110.leds import Leds, Light
from harness.gateways.pbdp110.settings import BusLost, DriveFacts, PbdpSettings

__all__ = [
    "BusLost",
    "DriveFacts",
    "Leds",
    "Light",
    "Pbdp110",
    "PbdpSettings",
    "drive_facts",
    "pbdp110_settings",
]
