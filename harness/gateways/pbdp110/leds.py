"""The lamps of the PBDP-110 (manual #10407-1.100-000, section 2)."""

from enum import Enum
from typing import NamedTuple


class Light(Enum):
    """What a lamp shows; the MMI lamp flashes at 0.5 Hz."""

    OFF = "off"
    GREEN = "green"
    GREEN_FLASHING = "green_flashing"


class Leds(NamedTuple):
    """The four lamps; those of the ports show that the drive there has supply."""

    data_exchange: Light
    mmi: Light
    drive_a: Light
    drive_b: Light


def lit(on: bool, light: Light = Light.GREEN) -> Light:
    """The light of a lamp that is on or off."""
    return light if on else Light.OFF
