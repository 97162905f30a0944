"""The MODBUS codec against the frames that were copied from the manuals by hand."""

import pytest

from fbgen.wire import modbus_rtu
from fbgen.wire.modbus import BadRequest, ExceptionCode, ExceptionReply, IdentifyReply, ReadReply
from fbgen.wire.modbus_lengths import expected_reply_length, reply_length, request_length
from tests.vectors.reading import entries

Entry = dict[str, str]
ENTRIES: list[Entry] = [
    entry
    for entry in entries("toshiba_frames").values()
    if entry["kind"] == "frame" and entry["mode"] == "modbus_rtu"
]
BY_ID = {entry["id"]: entry for entry in ENTRIES}
REFUSED = "modbus.block.bad_count"


def _frame(name: str) -> bytes:
    return bytes.fromhex(BY_ID[name]["bytes"])


def _of(direction: str) -> pytest.MarkDecorator:
    names = [entry["id"] for entry in ENTRIES if entry["direction"] == direction]
    assert names
    return pytest.mark.parametrize("name", names)


@_of("request")
def test_request_of_the_manuals_is_understood_and_written_the_same(name: str) -> None:
    frame = _frame(name)
    request = modbus_rtu.parse_request(frame)
    if name == REFUSED:
        assert request == BadRequest(1, 0x10, ExceptionCode.VALUE)
        return
    assert request is not None
    assert not isinstance(request, BadRequest)
    assert modbus_rtu.encode_request(request) == frame
    assert request_length(frame[:7]) == len(frame)


@_of("reply")
def test_reply_of_the_manuals_is_understood_and_written_the_same(name: str) -> None:
    frame = _frame(name)
    reply = modbus_rtu.parse_reply(frame)
    assert reply is not None
    assert modbus_rtu.encode_reply(reply) == frame
    assert reply_length(frame) == len(frame)


@_of("reply")
def test_reply_of_the_manuals_is_as_long_as_its_request_promises(name: str) -> None:
    request = modbus_rtu.parse_request(_frame(BY_ID[name]["reply_to"]))
    reply = modbus_rtu.parse_reply(_frame(name))
    if isinstance(request, BadRequest) or isinstance(reply, ExceptionReply):
        assert reply == ExceptionReply(1, reply.function, int(BY_ID[name]["meaning"][-2:]))
        return
    expected = expected_reply_length(request) if request is not None else None
    assert expected in (None, len(_frame(name)))


def test_identification_and_words_are_those_that_the_manual_names() -> None:
    reply = modbus_rtu.parse_reply(_frame("modbus.identify.reply"))
    assert isinstance(reply, IdentifyReply)
    assert [text.decode() for _, text in reply.objects] == ["TOSHIBA", "VFS15-2037PM", "0100"]
    assert modbus_rtu.parse_reply(_frame("modbus.read.reply")) == ReadReply(1, (0x1770,))
