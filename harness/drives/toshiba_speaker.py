"""What an inverter makes of a Toshiba telegram: who is meant, what is done, what is answered.

Facts: VF-S11 communications manual E6581222, pp. 9-13, 22; VF-AS1 RS485 manual E6581315, pp. 17-20;
VF-S15 RS485 manual E6581913, p. 13. The answer to a group carries the inverter's own number
(E6581222, 4.1: `(*2R0000)` is answered with `(02R0000....)`); that to `**` or FF repeats it.

Inferred: a block that cannot be written is refused with the code of its first word that cannot, and
nothing of it is read; a word for nothing is dropped, one of nothing reads as 0.
"""

from dataclasses import replace
from typing import TYPE_CHECKING

from fbgen.catalog import ToshibaService
from fbgen.wire import toshiba_ascii, toshiba_binary, toshiba_block
from fbgen.wire.toshiba import (
    BINARY_START,
    BROADCAST,
    TRIPPED_BIT,
    Address,
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Form,
    Group,
    Reply,
    Request,
)
from fbgen.wire.toshiba_block import BlockReply, BlockRequest
from harness.drives.blocks import BlockTransfer
from harness.drives.device import Device

if TYPE_CHECKING:
    from harness.drives.communication import Communication

_BINARY = Form.BINARY
_READS = (Command.R, Command.G)
_WRITE_RAM, _WRITE_EEPROM = Command.P, Command.W
_COMMANDS = {
    "read": Command.R,
    "read_padded": Command.G,
    "write_ram": Command.P,
    "write_eeprom": Command.W,
    "setpoint": Command.S,
    "setpoint_from_tripped": Command.S_TRIPPED,
}
"""The commands by their names in the catalogue; X is the business of the ear."""


class ToshibaSpeaker:
    """Obeys and answers Toshiba telegrams at one port."""

    __slots__ = (
        "_blocks",
        "_broadcast_reads",
        "_device",
        "_forms",
        "_groups",
        "_port",
        "_restricted",
        "_unknown",
    )

    def __init__(
        self,
        port: "Communication",
        device: Device,
        service: ToshibaService,
        blocks: BlockTransfer | None,
        broadcast_reads: bool,
    ) -> None:
        self._port = port
        self._device = device
        self._blocks = blocks
        self._broadcast_reads = broadcast_reads
        self._groups = service.groups
        self._forms = frozenset(Form[form.upper()] for form in service.forms)
        names = set(service.commands)
        self._unknown = frozenset(
            command for name, command in _COMMANDS.items() if name not in names
        )
        self._restricted = bool(self._unknown) or len(self._forms) < len(Form)

    def concerns(self, begin: bytes) -> bool:
        """Whether a telegram that begins so can be for this inverter."""
        if begin[0] == BINARY_START:
            number = begin[1:2]
            single = number and toshiba_binary.is_number(number[0]) and number[0] != BROADCAST
            return not single or number[0] == self._port.inv_no
        digits = begin[1:3]
        return not (len(digits) == 2 and digits.isdigit()) or int(digits) == self._port.inv_no

    def take(self, message: Request | BadRequest | BlockRequest, heard_ns: int) -> None:
        """Obey and answer a telegram that was over at `heard_ns`."""
        address, inv_no = message.address, self._port.inv_no
        several = False
        answers = address == inv_no or address is None
        if not answers:
            if isinstance(address, Group):
                if not (self._groups and address.includes(inv_no)):
                    return
                answers = address.lowest == inv_no
            elif address == BROADCAST:
                answers = inv_no == 0
            else:
                return
            several = True
        if isinstance(message, BlockRequest):
            if not several:
                self._carry_out_block(message, heard_ns)
            return
        if self._restricted and message.form not in self._forms:
            return
        if isinstance(message, BadRequest):
            if answers:
                self._refuse(message, message.error, heard_ns)
            return
        command = message.command
        if self._restricted and command in self._unknown:
            if answers and message.form is not _BINARY:
                self._refuse(message, ErrorCode.COMMAND, heard_ns)
            return
        reads = command in _READS
        if reads and several and not self._broadcast_reads:
            return
        self._port.carried_out(reads)
        self._carry_out(message, answers, heard_ns)

    def _carry_out(self, request: Request, answers: bool, heard_ns: int) -> None:
        command, number, device = request.command, request.com_no, self._device
        value: int | None = request.data
        error: ErrorCode | None = None
        if command in _READS:
            value = device.read(number)
        elif command is _WRITE_RAM:
            error = device.write_ram(number, request.data)
        elif command is _WRITE_EEPROM:
            error = device.write_eeprom(number, request.data)
        else:
            device.follow(self._port.facts, number, request.data, command is Command.S_TRIPPED)
            return
        port = self._port
        if not answers or port.deaf_until_ns > port.kernel.now_ns:
            return
        if error is not None:
            self._refuse(request, error, heard_ns)
        elif value is None:
            self._refuse(request, ErrorCode.COM_NO, heard_ns)
        else:
            if port.reply_number is not None or request.address.__class__ is Group:
                request = replace(request, address=self._from(request.address))
            port.answer(_answer(request, value, device.tripped), heard_ns)

    def _carry_out_block(self, request: BlockRequest, heard_ns: int) -> None:
        blocks, device, port = self._blocks, self._device, self._port
        if blocks is None or _BINARY not in self._forms:
            return
        port.carried_out(not request.words)
        for number, word in zip(blocks.written(len(request.words)), request.words, strict=True):
            error = None if number is None else device.write_ram(number, word)
            if port.mute:
                return
            if error is not None:
                self._refuse(BadRequest(request.address, error), error, heard_ns)
                return
        words = [
            0 if number is None else device.read(number) or 0
            for number in blocks.read(request.reads)
        ]
        reply = BlockReply(self._from(request.address), tuple(words), 0, device.tripped)
        port.answer(toshiba_block.encode_reply(reply), heard_ns)

    def _refuse(self, message: Request | BadRequest, error: ErrorCode, heard_ns: int) -> None:
        form, checked = message.form, message.checked
        reply = ErrorReply(self._from(message.address), error, self._device.tripped, form, checked)
        protocol = toshiba_binary if form is _BINARY else toshiba_ascii
        self._port.answer(protocol.encode_reply(reply), heard_ns)

    def _from(self, address: Address) -> Address:
        """The number that an answer carries."""
        if self._port.reply_number is not None:
            return self._port.reply_number
        return self._port.inv_no if isinstance(address, Group) else address


def _answer(request: Request, value: int, tripped: bool) -> bytes:
    """The frame that says a value read or written."""
    address, command, com_no = request.address, request.command, request.com_no
    if request.form is _BINARY:
        cmd = command | TRIPPED_BIT if tripped else command
        return toshiba_binary.reply_frame(address, cmd, com_no, value)
    reply = Reply(address, command, com_no, value, tripped, request.form, request.checked)
    return toshiba_ascii.encode_reply(reply)
