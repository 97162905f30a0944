"""What ends the faults of which a DeviceNet option does not recover by itself."""

from harness.fieldbus.devicenet import Network
from harness.gateways.dev003z import Dev003z
from harness.installation.holds import Hold, switched


def reset_when_over(option: Dev003z) -> Hold[bool]:
    """When the last of these faults is over, somebody resets an option that is off the network."""

    def end() -> None:
        if option.node.network is Network.FAULT:
            option.node.restart()

    return switched(option, "off the network", lambda: None, end)
