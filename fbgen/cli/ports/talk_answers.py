"""What came back to a question: the value with its name and unit, or why there is none."""

from typing import TYPE_CHECKING, NamedTuple

from fbgen.catalog import ComNo
from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_lines import frame_bytes
from fbgen.cli.frames.modbus_reading import EXCEPTIONS
from fbgen.cli.frames.toshiba_answers import ERRORS
from fbgen.cli.ports.talk_requests import Question, Talking
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note
from fbgen.wire import modbus_rtu, toshiba_stream
from fbgen.wire.line_protocols import LINE_PROTOCOLS
from fbgen.wire.modbus import ExceptionReply, ReadReply, WriteReply
from fbgen.wire.toshiba import ErrorReply, Reply

if TYPE_CHECKING:
    from harness.serial import Heard


class Answer(NamedTuple):
    """The word that came back; None where nobody answers. `tripped` only Toshiba frames tell."""

    question: Question
    word: int | None
    tripped: bool
    reply: bytes
    took_ms: float


def answer_of(question: Question, heard: "Heard", talking: Talking) -> Answer:
    """The answer in what was heard.

    Raises DiagnosticError FB9051 if there is no right reply, FB9052 if the inverter refuses.
    """
    took_ms = round(heard.took_ns / 1e6, 3)
    if not question.answered:
        return Answer(question, None, False, b"", took_ms)
    if heard.reply is None:
        raise DiagnosticError([_none(question, heard, talking)])
    if talking.protocol == "modbus":
        return _modbus(question, heard.reply, took_ms)
    reply = toshiba_stream.parse_reply(heard.reply)
    if isinstance(reply, ErrorReply):
        raise _refused(question, f"{reply.error:04X}", ERRORS[reply.error], heard.reply)
    assert isinstance(reply, Reply), "it answers the question"
    return Answer(question, reply.data, reply.tripped, heard.reply, took_ms)


def _modbus(question: Question, frame: bytes, took_ms: float) -> Answer:
    reply = modbus_rtu.parse_reply(frame)
    if isinstance(reply, ExceptionReply):
        known = {int(code): text for code, text in EXCEPTIONS.items()}
        text = known.get(reply.code, "an exception that inverters do not have")
        raise _refused(question, f"{reply.code:02X}", text, frame)
    assert isinstance(reply, ReadReply | WriteReply), "it answers the question"
    word = reply.words[0] if isinstance(reply, ReadReply) else reply.word
    return Answer(question, word, False, frame, took_ms)


def _refused(question: Question, code: str, text: str, frame: bytes) -> DiagnosticError:
    what = "to be read" if question.word is None else f"{question.word:04X}"
    known = "" if question.word is None or question.comno is None else _range(question.comno)
    help_ = known or "fbgen catalog show lists the ComNos of a series with their ranges"
    if question.comno is not None and question.comno.requires_stop:
        help_ = "it can be written while the inverter stands"
    message = f"inverter {question.inv_no} refuses {question.com_no:04X} {what}: {text} ({code})"
    return DiagnosticError(
        [Diagnostic("FB9052", message, None, help_, (Note(f"it said {frame_bytes(frame)}"),))]
    )


def _range(comno: ComNo) -> str:
    """What a ComNo takes by the catalogue; nothing where that says nothing."""
    if comno.access == "r":
        return f"{comno.name} can only be read"
    if comno.minimum is None and comno.maximum is None:
        return ""
    low, high = comno.to_value(comno.minimum_word), comno.to_value(comno.maximum_word)
    limit = f", and not more than {comno.limited_by}" if comno.limited_by else ""
    return f"{comno.name} takes {low:g} to {high:g} {comno.unit}".rstrip() + limit


def _none(question: Question, heard: "Heard", talking: Talking) -> Diagnostic:
    who = f"inverter {question.inv_no}"
    sent = Note(f"sent: {frame_bytes(question.frame)}")
    came = Note(f"came: {frame_bytes(b''.join(heard.others) + heard.rest)}")
    if heard.others:
        message = f"{who} does not answer, something else does"
        help_ = "another inverter or a late reply: give each its own number, or a longer --timeout"
    elif _wrong_sum(heard.rest, talking):
        message = f"the reply of {who} has a wrong check sum"
        help_ = "noise, or two with one number: check screen, ends and numbers, and ask again"
    elif heard.rest:
        message = f"what comes back is no frame: {len(heard.rest)} bytes"
        help_ = "is the speed or the parity another? fbgen talk --port P scan tries them"
    else:
        message = f"{who} does not answer"
        help_ = (
            "check number, speed and parity (scan finds them), the protocol, power, "
            "and whether the two wires of a pair are exchanged"
        )
        return Diagnostic("FB9051", message, None, help_, (sent,))
    return Diagnostic("FB9051", message, None, help_, (sent, came))


def _wrong_sum(rest: bytes, talking: Talking) -> bool:
    """Whether these bytes have the length of a reply and begin like one."""
    return bool(rest) and LINE_PROTOCOLS[talking.protocol].length("reply", rest) == len(rest)


def answer_text(answer: Answer, cells: CellTexts) -> str:
    """One line: who, which ComNo, which value."""
    question = answer.question
    who = "all" if question.inv_no is None else str(question.inv_no)
    name = cells.short(question.com_no)
    if answer.word is None:
        assert question.word is not None, "what is read is answered"
        return f"{who}  {name} {cells.value(question.com_no, question.word)}  sent, not answered"
    value = cells.value(question.com_no, answer.word)
    return f"{who}  {name} {value}{'  (tripped)' if answer.tripped else ''}"


def answer_json(answer: Answer, cells: CellTexts) -> dict[str, object]:
    """The same as plain data."""
    question = answer.question
    word = question.word if answer.word is None else answer.word
    data: dict[str, object] = {
        "inv_no": question.inv_no,
        "com_no": f"{question.com_no:04X}",
        "answered": answer.word is not None,
        "sent": question.frame.hex(" ").upper(),
        "received": answer.reply.hex(" ").upper(),
        "took_ms": answer.took_ms,
        "tripped": answer.tripped,
    }
    if word is not None:
        data["word"] = f"{word:04X}"
    if question.comno is not None:
        data["name"] = question.comno.name
        if word is not None and question.comno.word is None:
            data |= {"value": question.comno.to_value(word), "unit": question.comno.unit}
        if word is not None and question.comno.word is not None:
            data["bits"] = cells.value(question.com_no, word).partition(" = ")[2].split(", ")
    return data
