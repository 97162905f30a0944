"""The lamps MS and NS. Facts: DEV003Z-1 manual E6581737, page 8; red as DeviceNet has it."""

from fbgen.dataclass import dataclass
from harness.fieldbus.devicenet import DeviceNetSlave, Network


@dataclass(frozen=True, slots=True)
class Light:
    """A lamp by its name in the catalogue, and the name of its state there."""

    lamp: str
    state: str


def module_status(network: DeviceNetSlave, *, tripped: bool) -> Light:
    """MS: the option itself."""
    if network.network is Network.OFF:
        return Light("module_status", "no_power")
    if network.network is Network.SELF_TEST:
        return Light("module_status", "self_test")
    return Light("module_status", "minor_fault" if tripped else "operational")


def network_status(network: DeviceNetSlave) -> Light:
    """NS: the network."""
    lamp = "network_status"
    if network.network is Network.FAULT:
        return Light(lamp, "link_failure")
    if network.network is not Network.ONLINE:
        return Light(lamp, "not_online")
    if network.io_timed_out:
        return Light(lamp, "timed_out")
    return Light(lamp, "connected" if network.established else "not_connected")
