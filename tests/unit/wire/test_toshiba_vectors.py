"""The codecs against the frames that were copied from the manuals by hand."""

import pytest

from fbgen.catalog import load_catalog
from fbgen.wire import toshiba_ascii, toshiba_binary, toshiba_block
from fbgen.wire.toshiba import (
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Reply,
    Request,
    is_sealed,
    seal,
)
from fbgen.wire.toshiba_block import BlockReply, BlockRequest
from tests.vectors.reading import entries

_BLOCK_COMMANDS = ("58", "59")

Entry = dict[str, str]


def _frames(mode: str) -> list[Entry]:
    found = entries("toshiba_frames").values()
    return [entry for entry in found if entry["kind"] == "frame" and entry["mode"] == mode]


def _is_block(entry: Entry) -> bool:
    return entry["bytes"].split()[1] in _BLOCK_COMMANDS


BINARY = [entry for entry in _frames("binary") if "xx" not in entry["bytes"]]
TELEGRAMS = [entry for entry in BINARY if not _is_block(entry)]
BLOCKS = [entry for entry in BINARY if _is_block(entry)]
ASCII = _frames("ascii")


def _name(entry: Entry) -> str:
    return entry["id"]


@pytest.mark.parametrize("entry", TELEGRAMS, ids=_name)
def test_binary_frame_of_the_manuals_is_understood_and_written_the_same(entry: Entry) -> None:
    frame = bytes.fromhex(entry["bytes"])
    if entry["direction"] == "request":
        request = toshiba_binary.parse_request(frame)
        assert isinstance(request, Request)
        assert toshiba_binary.encode_request(request) == frame
    else:
        reply = toshiba_binary.parse_reply(frame)
        assert isinstance(reply, Reply | ErrorReply)
        assert toshiba_binary.encode_reply(reply) == frame


@pytest.mark.parametrize("entry", BLOCKS, ids=_name)
def test_block_frame_of_the_manuals_has_the_checksum_that_it_should(entry: Entry) -> None:
    frame = bytes.fromhex(entry["bytes"])
    assert is_sealed(frame) is entry.get("checksum_ok", True)
    assert (seal(frame[1:-1]) == frame) is is_sealed(frame)


@pytest.mark.parametrize("entry", BLOCKS, ids=_name)
def test_block_frame_of_the_manuals_is_understood_and_written_the_same(entry: Entry) -> None:
    frame = bytes.fromhex(entry["bytes"])
    if entry["direction"] == "reply":
        reply = toshiba_block.parse_reply(frame)
        assert isinstance(reply, BlockReply)
        assert [f"{word:04X}" for word in reply.words] == list(entry["words"])
        assert toshiba_block.encode_reply(reply) == frame
        return
    request = toshiba_block.parse_request(frame)
    if is_sealed(frame):
        assert isinstance(request, BlockRequest)
        assert toshiba_block.encode_request(request) == frame
    else:
        assert request == BadRequest(None, ErrorCode.CHECKSUM)


@pytest.mark.parametrize("entry", ASCII, ids=_name)
def test_ascii_frame_of_the_manuals_is_understood_and_written_the_same(entry: Entry) -> None:
    frame = entry["text"].encode("ascii").replace(b"\\r", b"\r")
    if entry["direction"] == "request":
        request = toshiba_ascii.parse_request(frame)
        assert isinstance(request, Request)
        assert toshiba_ascii.encode_request(request) == frame
    else:
        reply = toshiba_ascii.parse_reply(frame)
        assert isinstance(reply, Reply | ErrorReply)
        assert toshiba_ascii.encode_reply(reply) == frame


def test_codec_and_catalogue_agree_on_commands_and_errors() -> None:
    protocol = load_catalog().toshiba_protocol("toshiba")
    known = {command.code for command in protocol.commands if command.name != "block"}
    assert known == {int(code) for code in Command}, "X and Y have frames of their own"
    assert {error.code for error in protocol.errors} == {int(code) for code in ErrorCode}


def test_open_data_of_a_read_may_be_anything() -> None:
    # the manual leaves the data of row 3 of its example open: xx xx
    for data in (0x0000, 0x1234, 0xFFFF):
        frame = toshiba_binary.encode_request(Request(0x0B, Command.G, 0xFE03, data))
        assert not isinstance(toshiba_binary.parse_request(frame), BadRequest)
        assert frame[-1] == (0x82 + (data >> 8) + (data & 0xFF)) & 0xFF
