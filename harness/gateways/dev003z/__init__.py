"""The DEV003Z: a DeviceNet option inside an inverter."""

from harness.gateways.dev003z.adapter import Dev003z
from harness.gateways.dev003z.control_supervisor import (
    Event,
    RunType,
    State,
    Trigger,
    next_state,
    run_stop,
)
from harness.gateways.dev003z.host import Host
from harness.gateways.dev003z.leds import Light
from harness.gateways.dev003z.settings import Dev003zSettings

__all__ = [
    "Dev003z",
    "Dev003zSettings",
    "Event",
    "Host",
    "Light",
    "RunType",
    "State",
    "Trigger",
    "next_state",
    "run_stop",
]
