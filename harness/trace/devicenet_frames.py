"""CAN frames of a DeviceNet network: who sent them, what they are, what they say.

What an identifier stands for: `fbgen.wire.devicenet_ids`. I/O of more than eight bytes and long
explicit messages come in fragments; the last one says what all of them say.
"""

from collections.abc import Mapping

from fbgen.catalog import Assembly, AssemblyPair, DeviceNetGateway, Drive
from fbgen.dataclass import dataclass
from fbgen.wire import devicenet
from fbgen.wire.devicenet import FRAME_BYTES
from fbgen.wire.devicenet_fragments import Kind, Reassembly, parse_fragment
from fbgen.wire.devicenet_ids import Group2, SlaveMessage, group_2, slave_message
from fbgen.wire.devicenet_messages import MessageError, parse_duplicate_check, parse_header
from harness.fieldbus.devicenet import CanBus, CanPort
from harness.trace.assembly_meaning import assembly_meaning
from harness.trace.explicit_meanings import ExplicitMeanings
from harness.trace.model import Frame, FrameKind

_Said = tuple[FrameKind, str]
_LONGEST = 512


@dataclass(frozen=True, slots=True)
class ScannedDrive:
    """A drive on the network, as the plant file has it."""

    name: str
    mac: int
    gateway: DeviceNetGateway
    series: Drive
    pair: AssemblyPair


class CanFrameWatch:
    """Notes each frame of one network when it is over, the oldest first."""

    def __init__(
        self,
        bus: CanBus,
        name: str,
        senders: Mapping[CanPort, str],
        drives: tuple[ScannedDrive, ...],
        scanner: int,
    ) -> None:
        """`senders` are the scanner, by the network's `name`, and the drives; `scanner` its MAC."""
        self.frames: list[Frame] = []
        self._bus = bus
        self._name = name
        self._senders = senders
        self._of_scanner = {port for port, sender in senders.items() if sender == name}
        self._messages = {
            identifier: messages
            for messages in map(_Messages, drives)
            for identifier in messages.identifiers
        }
        checks = {drive.mac: drive.name for drive in drives} | {scanner: name}
        self._checks = {group_2(Group2.DUPLICATE_MAC_CHECK, mac): mac for mac in checks}
        bus.taps.append(self._heard)

    def drive_of(self, identifier: int) -> tuple[str | None, bool]:
        """Whose messages have this identifier, None for none's, and whether they carry I/O data."""
        messages = self._messages.get(identifier)
        if messages is None:
            return None, False
        return messages.drive.name, identifier in messages.io

    def _heard(self, end_ns: int, frame: devicenet.Frame, port: CanPort) -> None:
        kind, meaning = self._said(frame)
        self.frames.append(
            Frame(
                end_ns - self._bus.duration_ns(frame),
                end_ns,
                self._name,
                self._senders.get(port),
                port in self._of_scanner,
                kind,
                frame.data,
                meaning=meaning,
                identifier=frame.identifier,
            )
        )

    def _said(self, frame: devicenet.Frame) -> _Said:
        messages = self._messages.get(frame.identifier)
        if messages is not None:
            return messages.said(frame)
        mac = self._checks.get(frame.identifier)
        return ("unknown", "") if mac is None else _check(mac, frame.data)


def _check(mac: int, data: bytes) -> _Said:
    try:
        check = parse_duplicate_check(data)
    except MessageError:
        return "unknown", ""
    who = f"vendor {check.vendor:04X}, serial number {check.serial:08X}"
    says = "it is taken" if check.response else "does somebody have it?"
    return "check", f"MAC ID {mac}: {says} ({who})"


class _Messages:
    """What goes to and from one drive. The same I/O data are looked at only once."""

    def __init__(self, drive: ScannedDrive) -> None:
        mac = drive.mac
        self.drive = drive
        self._explicit = ExplicitMeanings(drive.name, drive.gateway, drive.series)
        self._poll = group_2(Group2.POLL, mac)
        self._answer = slave_message(SlaveMessage.POLL_RESPONSE, mac)
        self._cos = slave_message(SlaveMessage.COS, mac)
        self._acknowledge = group_2(Group2.COS_ACKNOWLEDGE, mac)
        self._request = group_2(Group2.EXPLICIT_REQUEST, mac)
        self._unconnected = group_2(Group2.UNCONNECTED_REQUEST, mac)
        self._response = group_2(Group2.EXPLICIT_RESPONSE, mac)
        self.io = (self._poll, self._answer, self._cos, self._acknowledge)
        self.identifiers = (*self.io, self._request, self._unconnected, self._response)
        self._parts = {identifier: Reassembly(_LONGEST) for identifier in self.identifiers}
        self._known: dict[tuple[int, bytes], _Said] = {}

    def said(self, frame: devicenet.Frame) -> _Said:
        """What a frame is and says."""
        identifier, data = frame.identifier, frame.data
        pair, name = self.drive.pair, self.drive.name
        if identifier == self._poll:
            return self._io(identifier, data, "output", pair.output, f"{name}: ")
        if identifier == self._answer:
            return self._io(identifier, data, "input", pair.input, f"{name}: ")
        if identifier == self._cos:
            return self._io(identifier, data, "input", pair.input, f"{name}, by itself: ")
        if identifier == self._acknowledge:
            return "acknowledge", f"{name}: its data have come"
        return self._message(identifier, data)

    def _io(
        self, identifier: int, data: bytes, kind: FrameKind, assembly: Assembly, front: str
    ) -> _Said:
        if assembly.length > FRAME_BYTES and data:
            fragment = parse_fragment(data)
            assert fragment is not None, "there is a byte"
            whole = self._parts[identifier].add(fragment)
            if whole is None:
                return "fragment", f"{front}fragment {fragment.number}"
            data = whole
        found = self._known.get((identifier, data))
        if found is None:
            text = "no data" if not data else data.hex(" ").upper()
            if len(data) == assembly.length:
                text = assembly_meaning(self.drive.gateway, assembly, data)
            elif data:
                text += f", which are {len(data)} bytes instead of {assembly.length}"
            found = self._known[identifier, data] = kind, f"{front}{text}"
        return found

    def _message(self, identifier: int, data: bytes) -> _Said:
        if not data:
            return "unknown", ""
        body = data[1:]
        if parse_header(data[0]).fragment:
            fragment = parse_fragment(body)
            if fragment is None:
                return "unknown", ""
            if fragment.kind is Kind.ACKNOWLEDGE:
                return "acknowledge", f"{self.drive.name}: fragment {fragment.number} has come"
            whole = self._parts[identifier].add(fragment)
            if whole is None:
                return "fragment", f"{self.drive.name}: fragment {fragment.number}"
            body = whole
        if identifier == self._response:
            return self._explicit.response(body)
        return self._explicit.request(body, unconnected=identifier == self._unconnected)
