"""Two MODBUS implementations that are not ours judge the codec: pymodbus and minimalmodbus.

Both are imported when a test asks for them: they take their time to load.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fbgen.wire import modbus
from fbgen.wire.modbus_rtu import encode_reply, encode_request, parse_reply, parse_request
from tests.properties.modbus_messages import replies, requests, words


def _theirs(module: str) -> Any:
    return import_module(f"pymodbus.{module}")


@pytest.fixture(scope="module")
def server() -> Any:
    """The framer of a pymodbus server: it reads requests."""
    return _theirs("framer").FramerRTU(_theirs("pdu").DecodePDU(is_server=True))


@pytest.fixture(scope="module")
def client() -> Any:
    """The framer of a pymodbus client: it reads replies."""
    return _theirs("framer").FramerRTU(_theirs("pdu").DecodePDU(is_server=False))


def _their_request(request: modbus.Request) -> Any:
    register = _theirs("pdu.register_message")
    to = request.address
    match request:
        case modbus.ReadRequest():
            return register.ReadHoldingRegistersRequest(
                dev_id=to, address=request.start, count=request.count
            )
        case modbus.WriteRequest():
            return register.WriteSingleRegisterRequest(
                dev_id=to, address=request.start, registers=[request.word]
            )
        case modbus.WriteSeveralRequest():
            return register.WriteMultipleRegistersRequest(
                dev_id=to, address=request.start, registers=list(request.words)
            )
        case modbus.ReadWriteRequest():
            return register.ReadWriteMultipleRegistersRequest(
                read_address=request.read_start,
                read_count=request.read_count,
                write_address=request.write_start,
                write_registers=list(request.words),
                dev_id=to,
            )
        case modbus.IdentifyRequest():
            return _theirs("pdu.mei_message").ReadDeviceInformationRequest(
                read_code=request.code, object_id=request.object_id, dev_id=to
            )


def _their_reply(reply: modbus.Reply) -> Any:
    register = _theirs("pdu.register_message")
    by = reply.address
    match reply:
        case modbus.ReadReply():
            return register.ReadHoldingRegistersResponse(dev_id=by, registers=list(reply.words))
        case modbus.WriteReply():
            return register.WriteSingleRegisterResponse(
                dev_id=by, address=reply.start, registers=[reply.word]
            )
        case modbus.WriteSeveralReply():
            return register.WriteMultipleRegistersResponse(
                dev_id=by, address=reply.start, count=reply.count
            )
        case modbus.ReadWriteReply():
            return register.ReadWriteMultipleRegistersResponse(
                dev_id=by, registers=list(reply.words)
            )
        case modbus.ExceptionReply():
            return _theirs("pdu").ExceptionResponse(reply.function, reply.code, device_id=by)
        case modbus.IdentifyReply():
            theirs = _theirs("pdu.mei_message").ReadDeviceInformationResponse(
                read_code=reply.code, information=dict(reply.objects), dev_id=by
            )
            theirs.conformity = reply.conformity
            theirs.more_follows = 0xFF if reply.more_follows else 0
            theirs.next_object_id = reply.next_object
            return theirs


def _our_request(theirs: Any) -> modbus.Request:
    match theirs.function_code:
        case 0x03:
            return modbus.ReadRequest(theirs.dev_id, theirs.address, theirs.count)
        case 0x06:
            return modbus.WriteRequest(theirs.dev_id, theirs.address, theirs.registers[0])
        case 0x10:
            assert theirs.byte_count == 2 * theirs.count
            return modbus.WriteSeveralRequest(
                theirs.dev_id, theirs.address, tuple(theirs.registers)
            )
        case 0x17:
            return modbus.ReadWriteRequest(
                theirs.dev_id,
                theirs.read_address,
                theirs.read_count,
                theirs.write_address,
                tuple(theirs.write_registers),
            )
        case _:
            return modbus.IdentifyRequest(theirs.dev_id, theirs.read_code, theirs.object_id)


def _our_reply(theirs: Any) -> modbus.Reply:
    by = theirs.dev_id
    match theirs.function_code:
        case 0x03:
            return modbus.ReadReply(by, tuple(theirs.registers))
        case 0x06:
            return modbus.WriteReply(by, theirs.address, theirs.registers[0])
        case 0x10:
            return modbus.WriteSeveralReply(by, theirs.address, theirs.count)
        case 0x17:
            return modbus.ReadWriteReply(by, tuple(theirs.registers))
        case 0x2B:
            return modbus.IdentifyReply(
                by,
                theirs.read_code,
                theirs.conformity,
                tuple(theirs.information.items()),
                theirs.more_follows != 0,
                theirs.next_object_id,
            )
        case refused:
            return modbus.ExceptionReply(by, refused & 0x7F, theirs.exception_code)


@given(request=requests)
def test_pymodbus_writes_a_request_as_we_do_and_we_read_it(
    server: Any, request: modbus.Request
) -> None:
    frame = server.buildFrame(_their_request(request))
    assert frame == encode_request(request)
    assert parse_request(frame) == request


@given(request=requests)
def test_pymodbus_reads_our_requests(server: Any, request: modbus.Request) -> None:
    frame = encode_request(request)
    used, theirs = server.handleFrame(frame, 0, 0)
    assert used == len(frame)
    assert _our_request(theirs) == request


@given(reply=replies)
def test_pymodbus_writes_a_reply_as_we_do_and_we_read_it(client: Any, reply: modbus.Reply) -> None:
    frame = client.buildFrame(_their_reply(reply))
    assert frame == encode_reply(reply)
    assert parse_reply(frame) == reply


@given(reply=replies)
def test_pymodbus_reads_our_replies(client: Any, reply: modbus.Reply) -> None:
    frame = encode_reply(reply)
    used, theirs = client.handleFrame(frame, 0, 0)
    assert used == len(frame)
    assert _our_reply(theirs) == reply


@given(data=st.binary(max_size=64))
def test_pymodbus_has_the_same_check_sum(server: Any, data: bytes) -> None:
    assert server.compute_CRC(data) == modbus.crc(data)


@dataclass
class Slave:
    """A port at which our codec answers; as much of a serial port as minimalmodbus uses."""

    answer: Callable[[modbus.Request], modbus.Reply]
    asked: list[modbus.Request] = field(default_factory=list)
    pending: bytes = b""
    is_open = True
    port = None
    baudrate = 115_200

    def open(self) -> None:
        """It is open."""

    def close(self) -> None:
        """It stays open."""

    def reset_input_buffer(self) -> None:
        """Forget what was not fetched."""
        self.pending = b""

    def reset_output_buffer(self) -> None:
        """Nothing waits to go out."""

    def write(self, frame: bytes) -> None:
        """A request of the master."""
        request = parse_request(frame)
        assert isinstance(request, modbus.Request)
        self.asked.append(request)
        self.pending = encode_reply(self.answer(request))

    def read(self, size: int) -> bytes:
        """The reply, of which the master expects so many bytes."""
        data, self.pending = self.pending[:size], self.pending[size:]
        return data


def _master(slave: Slave, address: int) -> Any:
    return import_module("minimalmodbus").Instrument(slave, address)


addresses = st.integers(1, 247)


@given(addresses, words, words)
def test_minimalmodbus_reads_a_word(address: int, start: int, word: int) -> None:
    slave = Slave(lambda _: modbus.ReadReply(address, (word,)))
    assert _master(slave, address).read_register(start) == word
    assert slave.asked == [modbus.ReadRequest(address, start, 1)]


@given(addresses, st.integers(0, 0xFF00), st.lists(words, min_size=1, max_size=125))
def test_minimalmodbus_reads_words(address: int, start: int, found: list[int]) -> None:
    slave = Slave(lambda _: modbus.ReadReply(address, tuple(found)))
    assert _master(slave, address).read_registers(start, len(found)) == found
    assert slave.asked == [modbus.ReadRequest(address, start, len(found))]


@given(addresses, words, words)
def test_minimalmodbus_writes_a_word(address: int, start: int, word: int) -> None:
    slave = Slave(lambda _: modbus.WriteReply(address, start, word))
    _master(slave, address).write_register(start, word, functioncode=6)
    assert slave.asked == [modbus.WriteRequest(address, start, word)]


@given(addresses, st.integers(0, 0xFF00), st.lists(words, min_size=1, max_size=123))
def test_minimalmodbus_writes_words(address: int, start: int, given_: list[int]) -> None:
    slave = Slave(lambda _: modbus.WriteSeveralReply(address, start, len(given_)))
    _master(slave, address).write_registers(start, given_)
    assert slave.asked == [modbus.WriteSeveralRequest(address, start, tuple(given_))]


@pytest.mark.parametrize("code", [1, 2, 3, 4])
def test_minimalmodbus_knows_our_refusals(code: int) -> None:
    minimalmodbus = import_module("minimalmodbus")
    slave = Slave(lambda request: modbus.ExceptionReply(request.address, 0x03, code))
    with pytest.raises(minimalmodbus.SlaveReportedException) as refused:
        _master(slave, 1).read_register(0xFD00)
    assert slave.asked == [modbus.ReadRequest(1, 0xFD00)]
    assert isinstance(refused.value, minimalmodbus.IllegalRequestError) is (code < 4)
