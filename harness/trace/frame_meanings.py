"""What frames on the line are and say, in words, from the catalogue."""

from collections.abc import Mapping

from fbgen.catalog import Catalog, Drive
from fbgen.wire import toshiba_ascii, toshiba_binary
from fbgen.wire.toshiba import (
    ASCII_START,
    BROADCAST,
    Address,
    ErrorCode,
    ErrorReply,
    Group,
    Reply,
    Request,
)
from harness.trace.meaning import cell_name, word_meaning
from harness.trace.model import FrameKind

_REFUSALS = {
    ErrorCode.CANNOT_EXECUTE: "it cannot be done now",
    ErrorCode.DATA: "the value lies outside the range",
    ErrorCode.COM_NO: "there is no such ComNo",
    ErrorCode.COMMAND: "there is no such command",
    ErrorCode.CHECKSUM: "the checksum is wrong",
}


class FrameMeanings:
    """Kind and meaning of the frames of one line; the same bytes are looked at only once."""

    def __init__(
        self,
        series: Mapping[int, Drive],
        catalog: Catalog,
        ascii_kinds: tuple[FrameKind, FrameKind] = ("heartbeat", "answer"),
    ) -> None:
        """`series` are the drives of the line by INV-NO; `ascii_kinds` what frames in ASCII are:
        of gateways the heartbeat, and what is said to it."""
        self._ascii_kinds = ascii_kinds
        self._series = series
        self._first = next(iter(series.values()))
        self._writes = {
            command.code: command.writes
            for command in catalog.toshiba_protocol(self._first.protocol).commands
        }
        self._known: dict[tuple[bytes, bool], tuple[FrameKind, str]] = {}

    def of(self, data: bytes, to_drives: bool) -> tuple[FrameKind, str]:
        """What a frame is and says; no meaning for bytes that are no frame of the protocol."""
        key = data, to_drives
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = self._read(data, to_drives)
        return found

    def _read(self, data: bytes, to_drives: bool) -> tuple[FrameKind, str]:
        is_ascii = data[:1] == bytes((ASCII_START,))
        form = toshiba_ascii if is_ascii else toshiba_binary
        if to_drives:
            request = form.parse_request(data)
            if not isinstance(request, Request):
                return "unknown", ""
            return self._ascii_kinds[0] if is_ascii else "request", self._request(request)
        reply = form.parse_reply(data)
        if isinstance(reply, Reply):
            return self._ascii_kinds[1] if is_ascii else "reply", self._reply(reply)
        if isinstance(reply, ErrorReply):
            return "refusal", f"{_who(reply.address)} refuses: {_REFUSALS[reply.error]}"
        return "unknown", ""

    def _drive(self, address: Address) -> Drive:
        return self._series.get(address, self._first) if isinstance(address, int) else self._first

    def _request(self, request: Request) -> str:
        drive, com_no = self._drive(request.address), request.com_no
        text = f"{_who(request.address)}: "
        if not self._writes.get(request.command):
            return f"{text}read {cell_name(drive, com_no)}"
        value = word_meaning(drive, com_no, request.data)
        return f"{text}write {cell_name(drive, com_no)} = {value}"

    def _reply(self, reply: Reply) -> str:
        drive, com_no = self._drive(reply.address), reply.com_no
        value = word_meaning(drive, com_no, reply.data)
        tripped = ", tripped" if reply.tripped else ""
        return f"{_who(reply.address)}: {cell_name(drive, com_no)} is {value}{tripped}"


def _who(address: Address) -> str:
    if address == BROADCAST:
        return "all drives"
    if isinstance(address, Group):
        return f"drives {address.tens}x" if address.tens is not None else f"drives x{address.units}"
    return "the drive" if address is None else f"drive {address}"
