"""Telegrams about a single word in a form that is the same for all protocols: what is asked, and
what is said. One ComNo is read or written, in either form of the Toshiba protocol, or by functions
03 and 06 of MODBUS.
"""

from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple

from fbgen.wire import modbus, modbus_rtu, toshiba_stream
from fbgen.wire.toshiba import BROADCAST, Command, Reply, Request

Family = Literal["toshiba", "modbus"]
"""The protocols, both forms of the first in one."""
_READS, _WRITES = (Command.R, Command.G), (Command.W, Command.P)


class Wanted(NamedTuple):
    """What a drive is asked for; `data` is 0 for a read. INV-NO FF are all drives."""

    inv_no: int
    writes: bool
    com_no: int
    data: int

    def __str__(self) -> str:
        who = "all drives" if self.inv_no == BROADCAST else f"drive {self.inv_no}"
        if self.writes:
            return f"write {self.com_no:04X} = {self.data:04X} to {who}"
        return f"read {self.com_no:04X} of {who}"


class Said(NamedTuple):
    """What a drive says; without a ComNo where the protocol does not repeat it."""

    inv_no: int
    com_no: int | None
    data: int

    def answers(self, wanted: Wanted, data: int) -> bool:
        """Whether it gives this value to what was asked. A broadcast is answered by drive 00."""
        numbers = (0, BROADCAST) if wanted.inv_no == BROADCAST else (wanted.inv_no,)
        about = self.com_no is None or self.com_no == wanted.com_no
        return self.inv_no in numbers and about and self.data == data


def _toshiba_wanted(frame: bytes) -> Wanted | None:
    request = toshiba_stream.parse_request(frame)
    if not isinstance(request, Request):
        return None
    inv_no = request.address if isinstance(request.address, int) else BROADCAST
    if request.command in _READS:
        return Wanted(inv_no, False, request.com_no, 0)
    if request.command in _WRITES:
        return Wanted(inv_no, True, request.com_no, request.data)
    return None


def _toshiba_said(frame: bytes) -> Said | None:
    reply = toshiba_stream.parse_reply(frame)
    if not isinstance(reply, Reply):
        return None
    inv_no = reply.address if isinstance(reply.address, int) else BROADCAST
    return Said(inv_no, reply.com_no, reply.data)


def _modbus_wanted(frame: bytes) -> Wanted | None:
    match modbus_rtu.parse_request(frame):
        case modbus.ReadRequest(address, start, 1):
            return Wanted(address or BROADCAST, False, start, 0)
        case modbus.WriteRequest(address, start, word):
            return Wanted(address or BROADCAST, True, start, word)
    return None


def _modbus_said(frame: bytes) -> Said | None:
    match modbus_rtu.parse_reply(frame):
        case modbus.ReadReply(address, (word,)):
            return Said(address, None, word)
        case modbus.WriteReply(address, start, word):
            return Said(address, start, word)
    return None


_WANTED: Mapping[Family, Callable[[bytes], Wanted | None]] = {
    "toshiba": _toshiba_wanted,
    "modbus": _modbus_wanted,
}
_SAID: Mapping[Family, Callable[[bytes], Said | None]] = {
    "toshiba": _toshiba_said,
    "modbus": _modbus_said,
}


def wanted_in(family: Family, frame: bytes) -> Wanted | None:
    """What a frame of the PLC asks for; None for what is none of these telegrams."""
    return _WANTED[family](frame)


def said_in(family: Family, frame: bytes) -> Said | None:
    """What a frame of a drive says; None for refusals and what is no frame."""
    return _SAID[family](frame)
