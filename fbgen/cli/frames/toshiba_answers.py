"""What comes back to a frame of the Toshiba protocol, and from whom: for `fbgen decode`.

VF-S11 communications manual E6581222, pp. 9-13, 22; VF-AS1 RS485 manual E6581315, pp. 19-20, 45;
VF-S15 RS485 manual E6581913, pp. 12-13.
"""

from collections.abc import Iterator

from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_reading import shown
from fbgen.wire import toshiba_ascii, toshiba_binary
from fbgen.wire.toshiba import (
    BROADCAST,
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
from fbgen.wire.toshiba_inter_drive import set_point_of

Message = Request | BadRequest | BlockRequest | Reply | ErrorReply | BlockReply

ERRORS = {
    ErrorCode.CANNOT_EXECUTE: "it cannot be executed",
    ErrorCode.DATA: "the data are outside of the range",
    ErrorCode.COM_NO: "there is no such ComNo",
    ErrorCode.COMMAND: "there is no such command",
    ErrorCode.CHECKSUM: "the checksum is wrong",
}
READS = (Command.R, Command.G)


def address_text(address: Address) -> str:
    """Who is meant, or who answers."""
    match address:
        case None:
            return "the one inverter on the line"
        case Group(tens, units):
            ending = f"tens digit {tens}" if units is None else f"units digit {units}"
            return f"all inverters with the {ending}"
        case _:
            return "all inverters" if address == BROADCAST else f"inverter {address}"


def remarks(
    message: Message, frame: bytes, right: bytes, direction: str | None, cells: CellTexts
) -> Iterator[str]:
    """What comes back to a message, from whom, and what else its bytes may say."""
    if isinstance(message, Reply | ErrorReply | BlockReply):
        if frame != right:
            yield "The checksum is wrong: a master drops it."
        return
    if frame != right:
        yield from _answer(message, _refusal(message, ErrorCode.CHECKSUM))
    elif isinstance(message, BadRequest):
        yield from _answer(message, _refusal(message, message.error))
    elif isinstance(message, BlockRequest):
        yield from _answer(message, f"2F .. 59 {message.reads:02X} 00, the words and the sum")
    elif set_point_of(message) is not None:
        yield "Nobody answers."
    else:
        yield from _answers(message, cells)
        if direction is None and message.command not in READS:
            value = cells.value(message.com_no, message.data)
            name = cells.short(message.com_no)
            who = address_text(message.address)
            yield f"As a reply the same bytes say: {who} has taken {name} = {value}."


def _answers(request: Request, cells: CellTexts) -> Iterator[str]:
    if request.command in READS and _several(request.address):
        yield "Nobody answers: only writing to several inverters is valid."
        return
    if cells.resets(request.com_no, request.data):
        yield "Nobody answers: the inverter resets."
        return
    reply = Reply(
        *(request.address, request.command, request.com_no, request.data, False),
        *(request.form, request.checked),
    )
    tripped = reply._replace(tripped=True)
    if request.command not in READS:
        yield from _answer(request, f"{_encoded(reply)}, or if tripped {_encoded(tripped)}")
        return
    letter = request.command.name
    yield from _answer(
        request, f"{letter}, or if tripped {letter.lower()}, the same ComNo and the value"
    )


def _answer(request: Request | BadRequest | BlockRequest, text: str) -> Iterator[str]:
    """What comes back, and from whom."""
    address = request.address
    if _several(address):
        lowest = address.lowest if isinstance(address, Group) else 0
        yield f"Only inverter {lowest} answers, if there is one."
    else:
        yield f"Reply: {text}"


def _several(address: Address) -> bool:
    return address == BROADCAST or isinstance(address, Group)


def _refusal(request: Request | BadRequest | BlockRequest, code: ErrorCode) -> str:
    refused = ErrorReply(request.address, code)
    if not isinstance(request, BlockRequest):
        refused = refused._replace(form=request.form, checked=request.checked)
    if _several(request.address):
        return ""
    return f"{_encoded(refused)}, refused with {code:04X}: {ERRORS[code]}"


def _encoded(reply: Reply | ErrorReply) -> str:
    if reply.form is Form.ASCII:
        return toshiba_ascii.encode_reply(reply).decode("ascii").removesuffix("\r") + " CR"
    return shown(toshiba_binary.encode_reply(reply))
