"""DeviceNet on the wire: identifiers, messages, fragments and paths against the tables at hand.

Identifiers for MAC m: the table that devicenet-py 0.0.1 cites from IEC 62026-3.
"""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fbgen.wire.devicenet import MAX_MAC, BodyFormat, Frame, Service, Status
from fbgen.wire.devicenet_fragments import (
    EXPLICIT_BYTES,
    IO_BYTES,
    ONLY,
    Fragment,
    Kind,
    Reassembly,
    cut,
    parse_fragment,
)
from fbgen.wire.devicenet_ids import (
    Group2,
    Identifier,
    SlaveMessage,
    group_2,
    parse_identifier,
    slave_message,
)
from fbgen.wire.devicenet_messages import (
    DuplicateCheck,
    ErrorResponse,
    Header,
    MessageError,
    Request,
    Response,
    encode_request,
    encode_response,
    parse_duplicate_check,
    parse_header,
    parse_request,
    parse_response,
    status_name,
)
from fbgen.wire.devicenet_paths import Logical, Segment, assembly_path, encode_path, parse_path
from tests.vectors.reading import entries

MACS = st.integers(0, MAX_MAC)


@pytest.mark.fact("dn.ids")
@pytest.mark.parametrize("mac", [0, 5, 63])
def test_identifiers_are_those_of_the_table(mac: int) -> None:
    assert group_2(Group2.DUPLICATE_MAC_CHECK, mac) == 0x400 + 8 * mac + 7
    assert group_2(Group2.EXPLICIT_REQUEST, mac) == 0x400 + 8 * mac + 4
    assert group_2(Group2.UNCONNECTED_REQUEST, mac) == 0x400 + 8 * mac + 6
    assert group_2(Group2.EXPLICIT_RESPONSE, mac) == 0x400 + 8 * mac + 3
    assert group_2(Group2.POLL, mac) == 0x400 + 8 * mac + 5
    assert group_2(Group2.COS_ACKNOWLEDGE, mac) == 0x400 + 8 * mac + 2
    assert group_2(Group2.BIT_STROBE, mac) == 0x400 + 8 * mac
    assert slave_message(SlaveMessage.POLL_RESPONSE, mac) == 0x3C0 + mac
    assert slave_message(SlaveMessage.COS, mac) == 0x340 + mac
    assert slave_message(SlaveMessage.BIT_STROBE_RESPONSE, mac) == 0x380 + mac


def test_every_identifier_of_can_is_one_of_a_group_or_none() -> None:
    found = [parse_identifier(number) for number in range(0x800)]
    assert all(item is None or item.number == at for at, item in enumerate(found))
    groups = [0 if item is None else item.group for item in found]
    assert [groups.count(group) for group in (1, 2, 3, 4, 0)] == [1024, 512, 448, 48, 16]
    with pytest.raises(ValueError, match="no identifier of 11 bits"):
        parse_identifier(0x800)


@pytest.mark.parametrize(
    ("group", "message", "mac"), [(5, 0, 0), (3, 7, 0), (2, 0, 64), (1, 0, None), (4, 0, 1)]
)
def test_identifiers_that_cannot_be_are_refused(group: int, message: int, mac: int | None) -> None:
    with pytest.raises(ValueError, match=r"group|MAC ID"):
        Identifier(group, message, mac)


def test_a_frame_is_one_that_can_can_carry() -> None:
    assert str(Frame(0x42F, bytes(3))) == "42F 00 00 00"
    with pytest.raises(ValueError, match="8 bytes at most"):
        Frame(0, bytes(9))
    with pytest.raises(ValueError, match="no identifier"):
        Frame(0x800, b"")


@pytest.mark.fact("dn.explicit")
def test_a_header_is_fragment_transaction_and_mac() -> None:
    assert Header(5, xid=True, fragment=True).byte == 0xC5
    assert parse_header(0x41) == Header(1, xid=True)
    with pytest.raises(ValueError, match="no MAC ID"):
        Header(64)


@pytest.mark.fact("dn.explicit")
@pytest.mark.parametrize(
    ("form", "written"),
    [
        (BodyFormat.C8_I8, "0E 64 03 03"),
        (BodyFormat.C8_I16, "0E 64 03 40 03"),
        (BodyFormat.C16_I16, "0E 64 00 03 40 03"),
        (BodyFormat.C16_I8, "0E 64 00 03 03"),
    ],
)
def test_a_request_is_written_in_every_form(form: BodyFormat, written: str) -> None:
    instance = 0x4003 if form.instance_bytes == 2 else 3
    request = Request(Service.GET_ATTRIBUTE_SINGLE, 0x64, instance, b"\x03")
    assert encode_request(request, form) == bytes.fromhex(written)
    assert parse_request(bytes.fromhex(written), form) == request


def test_numbers_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="does not fit"):
        encode_request(Request(0x0E, 0x64, 0x4003), BodyFormat.C8_I8)
    with pytest.raises(ValueError, match="no service"):
        encode_request(Request(0x8E, 1, 1), BodyFormat.C8_I8)


@pytest.mark.fact("dn.allocate")
def test_allocate_and_its_answers() -> None:
    body = encode_request(Request(Service.ALLOCATE, 3, 1, b"\x03\x00"), BodyFormat.C8_I8)
    assert body == bytes.fromhex("4B 03 01 03 00")
    assert parse_response(b"\xcb\x01") == Response(Service.ALLOCATE, b"\x01")
    error = ErrorResponse(Status.RESOURCE_UNAVAILABLE, 0x02)
    assert encode_response(error) == bytes.fromhex("94 02 02")
    assert parse_response(bytes.fromhex("94 02 02")) == error
    assert encode_response(Response(Service.RELEASE)) == b"\xcc"


@pytest.mark.parametrize("body", ["", "0E", "0E 64 03", "8E 64 03 40"])
def test_what_is_no_request_is_said(body: str) -> None:
    with pytest.raises(MessageError):
        parse_request(bytes.fromhex(body), BodyFormat.C8_I16)


@pytest.mark.parametrize("body", ["", "0E", "94", "94 02", "94 02 FF 00"])
def test_what_is_no_response_is_said(body: str) -> None:
    with pytest.raises(MessageError):
        parse_response(bytes.fromhex(body))


def test_status_codes_have_names() -> None:
    assert status_name(0x16) == "object does not exist"
    assert status_name(0xD0) == "status d0"


def test_the_duplicate_mac_check_says_vendor_and_serial_number() -> None:
    check = DuplicateCheck(response=False, vendor=377, serial=0x01020304)
    assert check.encode() == bytes.fromhex("00 79 01 04 03 02 01")
    assert parse_duplicate_check(check.encode()) == check
    assert parse_duplicate_check(bytes.fromhex("80 79 01 04 03 02 01")).response
    with pytest.raises(MessageError, match="7 bytes"):
        parse_duplicate_check(bytes(6))


@pytest.mark.fact("dn.fragments")
@given(st.binary(max_size=300), st.sampled_from([IO_BYTES, EXPLICIT_BYTES]))
def test_what_is_cut_is_put_together_again(data: bytes, size: int) -> None:
    reassembly = Reassembly(300)
    found = [reassembly.add(fragment) for fragment in cut(data, size)]
    assert found[-1] == data
    assert found[:-1] == [None] * (len(found) - 1)
    assert not reassembly.expecting


@pytest.mark.fact("dn.fragments")
def test_eighteen_bytes_of_io_are_three_fragments() -> None:
    written = [fragment.encode() for fragment in cut(bytes(range(18)), IO_BYTES)]
    assert [item[0] for item in written] == [0x00, 0x41, 0x82]
    assert [len(item) for item in written] == [8, 8, 5]
    assert next(cut(b"\x01", IO_BYTES)).encode() == bytes([ONLY, 1])
    assert parse_fragment(b"\x82\x07") == Fragment(Kind.LAST, 2, b"\x07")
    assert parse_fragment(b"") is None


@pytest.mark.parametrize(
    "numbers",
    [
        [Fragment(Kind.MIDDLE, 1)],
        [Fragment(Kind.FIRST, 0), Fragment(Kind.MIDDLE, 2), Fragment(Kind.LAST, 3)],
        [Fragment(Kind.FIRST, 0), Fragment(Kind.LAST, 2)],
        [Fragment(Kind.FIRST, 1), Fragment(Kind.LAST, 2)],
        [Fragment(Kind.FIRST, 0), Fragment(Kind.ACKNOWLEDGE, 0), Fragment(Kind.LAST, 1)],
        [Fragment(Kind.FIRST, 0, bytes(6)), Fragment(Kind.LAST, 1, bytes(6))],
    ],
)
def test_fragments_out_of_their_row_are_no_message(numbers: list[Fragment]) -> None:
    reassembly = Reassembly(10)
    assert [reassembly.add(fragment) for fragment in numbers] == [None] * len(numbers)
    assert not reassembly.expecting


@given(st.lists(st.binary(max_size=8), max_size=30))
def test_any_fragments_never_make_more_than_the_limit(pieces: list[bytes]) -> None:
    reassembly = Reassembly(18)
    for piece in pieces:
        fragment = parse_fragment(piece)
        if fragment is not None:
            message = reassembly.add(fragment)
            assert message is None or len(message) <= 18


@pytest.mark.fact("dev.conn")
def test_the_path_of_the_manual_is_instance_70() -> None:
    entry = entries("dev003z_words")["dev.connection_path"]
    path = bytes.fromhex(entry["bytes"])
    assert assembly_path(entry["instance"]) == path
    assert [(item.kind, item.number) for item in parse_path(path)] == [
        (Segment.CLASS, 4), (Segment.INSTANCE, 70), (Segment.ATTRIBUTE, 3),
    ]  # fmt: skip


@given(
    st.lists(st.builds(Logical, st.sampled_from(Segment), st.integers(0, 0xFFFF), st.booleans()))
)
def test_paths_are_read_as_they_were_written(segments: list[Logical]) -> None:
    path = encode_path(segments)
    found = parse_path(path)
    assert [(item.kind, item.number) for item in found] == [
        (item.kind, item.number) for item in segments
    ]
    assert encode_path(found) == path


@given(st.binary(max_size=20))
def test_any_bytes_are_a_path_or_a_value_error(path: bytes) -> None:
    try:
        found = parse_path(path)
    except ValueError:
        return
    assert encode_path(found) == path


@pytest.mark.parametrize("path", ["00", "20", "25 46", "22 00 00", "3C 01", "40 00"])
def test_what_is_no_path_is_said(path: str) -> None:
    with pytest.raises(ValueError, match=r"segment"):
        parse_path(bytes.fromhex(path))
