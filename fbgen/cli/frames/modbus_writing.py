"""Frames of MODBUS-RTU from their fields, for `fbgen encode`."""

from fbgen.cli.frames.frame_fields import Fields
from fbgen.wire import modbus, modbus_rtu
from fbgen.wire.modbus_layout import IDENTIFY_CODES

_FUNCTIONS = {f"{function:02X}": function for function in modbus.Function}
_NAMES = ("maker", "product", "version")
_ROOM = modbus.LONGEST_FRAME - 10 - 2 * len(_NAMES)
"""Characters of the three names that fit into a frame, heads and CRC taken off."""


def modbus_frame(direction: str, fields: Fields) -> bytes:
    """The frame. Raises DiagnosticError FB9042 and FB9043 with everything that is wrong."""
    function = _FUNCTIONS[fields.choice("function", _FUNCTIONS)]
    if direction == "request":
        address = fields.number("address", range(modbus.HIGHEST_ADDRESS + 1), 1)
        request = _request(fields, function, address)
        fields.close()
        return modbus_rtu.encode_request(request)
    address = fields.number("address", range(1, modbus.HIGHEST_ADDRESS + 1), 1)
    reply = _reply(fields, function, address)
    fields.close()
    return modbus_rtu.encode_reply(reply)


def _request(fields: Fields, function: modbus.Function, address: int) -> modbus.Request:
    counts = range(1, modbus.MOST_READ + 1)
    match function:
        case modbus.Function.READ:
            return modbus.ReadRequest(address, fields.com_no(), fields.number("count", counts, 1))
        case modbus.Function.WRITE:
            com_no = fields.com_no()
            return modbus.WriteRequest(address, com_no, fields.word("data", com_no))
        case modbus.Function.WRITE_SEVERAL:
            words = fields.words("words", modbus.MOST_WRITTEN)
            return modbus.WriteSeveralRequest(address, fields.com_no(), words)
        case modbus.Function.READ_WRITE:
            words = fields.words("words", modbus.MOST_WRITTEN_BEFORE_READING)
            count = fields.number("count", counts)
            start = fields.com_no()
            return modbus.ReadWriteRequest(
                address, fields.com_no("read_com_no"), count, start, words
            )
        case modbus.Function.IDENTIFY:
            code = fields.number("code", range(IDENTIFY_CODES.start, IDENTIFY_CODES.stop), 1)
            return modbus.IdentifyRequest(address, code, fields.number("object", range(0x100), 0))


def _reply(fields: Fields, function: modbus.Function, address: int) -> modbus.Reply:
    if fields.has("exception"):
        return modbus.ExceptionReply(address, function, fields.number("exception", range(1, 0x100)))
    match function:
        case modbus.Function.READ:
            return modbus.ReadReply(address, fields.words("words", modbus.MOST_READ))
        case modbus.Function.WRITE:
            com_no = fields.com_no()
            return modbus.WriteReply(address, com_no, fields.word("data", com_no))
        case modbus.Function.WRITE_SEVERAL:
            count = fields.number("count", range(1, modbus.MOST_WRITTEN + 1))
            return modbus.WriteSeveralReply(address, fields.com_no(), count)
        case modbus.Function.READ_WRITE:
            return modbus.ReadWriteReply(address, fields.words("words", modbus.MOST_READ))
        case modbus.Function.IDENTIFY:
            return modbus.IdentifyReply(address, 1, 1, _objects(fields))


def _objects(fields: Fields) -> tuple[tuple[int, bytes], ...]:
    objects = []
    room = _ROOM
    for number, name in enumerate(_NAMES):
        text = fields.text(name)
        room -= len(text)
        if not text.isascii():
            fields.wrong(name, "has characters that are not ASCII", "use letters and digits")
        elif room < 0:
            fields.wrong(name, "does not fit into the frame", f"at most {_ROOM} in all")
        else:
            objects.append((number, text.encode("ascii")))
    return tuple(objects)
