"""Whether a MODBUS reply answers a request, and which ComNos its words are of."""

from fbgen.cli.frames.frame_reading import no_frame, shown
from fbgen.diagnostics import DiagnosticError, error
from fbgen.wire import modbus, modbus_rtu

Message = modbus.Request | modbus.BadRequest | modbus.Reply


def first_word(asked: bytes, reply: Message) -> int | None:
    """The ComNo of the first word in a reply; None if it has no words.

    Raises DiagnosticError FB9041 if `asked` is no request, FB9045 if the reply is none to it.
    """
    request = modbus_rtu.parse_request(asked)
    if request is None:
        raise no_frame(
            "request of MODBUS-RTU",
            f"{shown(asked)} behind --request",
            "give the request with its right CRC: fbgen decode modbus.request says what is wrong",
        )
    if request.address != reply.address:
        raise _other(f"it is from device {reply.address}, and {request.address} was asked")
    match request, reply:
        case (_, modbus.ExceptionReply(function=function)) if function == asked[1]:
            return None
        case (modbus.ReadRequest(start=start, count=count), modbus.ReadReply(words=words)):
            if len(words) == count:
                return start
        case (
            modbus.ReadWriteRequest(read_start=start, read_count=count),
            modbus.ReadWriteReply(words=words),
        ):
            if len(words) == count:
                return start
        case (modbus.WriteRequest(start=start, word=word), modbus.WriteReply()):
            if (start, word) == (reply.start, reply.word):
                return None
        case (modbus.WriteSeveralRequest(start=start, words=words), modbus.WriteSeveralReply()):
            if (start, len(words)) == (reply.start, reply.count):
                return None
        case (modbus.IdentifyRequest(), modbus.IdentifyReply()):
            return None
    raise _other("function, ComNo or number of words differ")


def _other(reason: str) -> DiagnosticError:
    return error(
        "FB9045", f"this is no reply to that request: {reason}", help="give the two as they came"
    )
