"""A node that is in the way: it has a MAC ID that belongs to another, and says so when asked."""

from fbgen.wire.devicenet import Frame
from fbgen.wire.devicenet_ids import Group2, group_2
from fbgen.wire.devicenet_messages import DuplicateCheck
from harness.fieldbus.devicenet.bus import CanBus

_VENDOR, _SERIAL = 0xFFFF, 0xFFFFFFFF


class NodeWithMac:
    """Answers duplicate MAC checks for its MAC ID while its `port` is plugged, and nothing else."""

    def __init__(self, bus: CanBus, mac: int) -> None:
        self._identifier = group_2(Group2.DUPLICATE_MAC_CHECK, mac)
        self.port = bus.attach(self._receive)
        self.port.plugged = False

    def _receive(self, frame: Frame) -> None:
        if frame.identifier == self._identifier:
            data = DuplicateCheck(True, _VENDOR, _SERIAL).encode()
            self.port.send(Frame(self._identifier, data))
