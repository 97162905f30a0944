"""How a DeviceNet slave is made, and what it says of itself on the network."""

from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import BodyFormat, Choice
from harness.kernel import NS_PER_MS, NS_PER_S

SUPPORTED = (
    Choice.EXPLICIT
    | Choice.POLLED
    | Choice.CHANGE_OF_STATE
    | Choice.CYCLIC
    | Choice.ACK_SUPPRESSION
)
"""What can be allocated; bit-strobed and multicast connections cannot."""


class Network(Enum):
    """How far the node has got."""

    OFF = "off"
    SELF_TEST = "self test"
    CHECKING = "duplicate MAC check"
    ONLINE = "on line"
    FAULT = "link failure"


@dataclass(frozen=True, slots=True)
class NodeSettings:
    """What differs from slave to slave. Times: see the catalogue of the device."""

    mac: int
    vendor: int
    serial: int
    body_format: BodyFormat = BodyFormat.C8_I16
    explicit_bytes: int = 64
    self_test_ns: int = 100 * NS_PER_MS
    check_ns: int = NS_PER_S
    response_ns: int = NS_PER_MS
    fragment_timeout_ns: int = NS_PER_S
    unused_ns: int = 10 * NS_PER_S
    sample_ns: int = 10 * NS_PER_MS
