"""The six lamps of the TOSPBDP001 (manual v1.1, section 3)."""

from enum import Enum
from typing import NamedTuple


class Light(Enum):
    """What a lamp shows."""

    OFF = "off"
    GREEN = "green"
    RED = "red"
    GREEN_FLASHING = "green_flashing"
    RED_FLASHING = "red_flashing"
    RED_1HZ = "red_1hz"
    RED_2HZ = "red_2hz"
    RED_4HZ = "red_4hz"
    RED_GREEN_ALTERNATING = "red_green_alternating"


class Fault(Enum):
    """What is broken in the device itself. With any of these it does nothing but show it."""

    NONE = "none"
    INITIALISATION = "fieldbus initialisation error"
    CONFIGURATION = "invalid or missing configuration"
    HARDWARE = "defect, contact the manufacturer"


class Leds(NamedTuple):
    """Lamps 1 to 6."""

    fieldbus_online: Light
    fieldbus_offline: Light
    unused: Light
    fieldbus_diagnosis: Light
    subnet_status: Light
    device_status: Light


DARK = Leds(Light.OFF, Light.OFF, Light.OFF, Light.OFF, Light.OFF, Light.OFF)


def diagnosis_light(fault: Fault, cfg_fault: bool, prm_fault: bool) -> Light:
    """Lamp 4: the gravest of what is wrong on the fieldbus side."""
    if fault is Fault.INITIALISATION:
        return Light.RED_4HZ
    if prm_fault:
        return Light.RED_2HZ
    return Light.RED_1HZ if cfg_fault else Light.OFF


def device_light(fault: Fault, initialising: bool, stopped: bool) -> Light:
    """Lamp 6 of a device with supply."""
    match fault:
        case Fault.HARDWARE:
            return Light.RED_FLASHING
        case Fault.CONFIGURATION:
            return Light.RED_GREEN_ALTERNATING
        case Fault.INITIALISATION:
            return Light.GREEN
        case Fault.NONE:
            if initialising:
                return Light.GREEN
            return Light.RED if stopped else Light.GREEN_FLASHING
