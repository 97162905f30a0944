"""`fbgen decode` and `fbgen encode` of frames: Toshiba protocol and MODBUS-RTU."""

import json

import pytest

from tests.frames import ASCII_CHECKED, MODBUS, TOSHIBA_BINARY
from tests.unit.cli.running import Fbgen


def _rows(text: str) -> dict[str, str]:
    """Field -> meaning, from the table of a frame."""
    lines = text.splitlines()
    head = next(line for line in lines if line.startswith("bytes "))
    at, meaning = head.index("field"), head.index("meaning")
    body = lines[lines.index(head) + 2 :]
    return {line[at:meaning].strip(): line[meaning:] for line in body[: (*body, "").index("")]}


def test_decode_names_everything_in_a_request_with_its_reply(fbgen: Fbgen) -> None:
    run = fbgen("decode", "toshiba", "2F 0B 50 FA 00 C4 00 48", "--series", "vf-s11")
    assert (run.status, run.err) == (0, "")
    assert run.out.splitlines()[:2] == [
        "2F 0B 50 FA 00 C4 00 48",
        "Toshiba protocol, binary, request",
    ]
    assert _rows(run.out) == {
        "start": "binary",
        "INV-NO": "inverter 11",
        "CMD": "P, write to RAM",
        "ComNo": "FA00, command_word: Command word",
        "DATA": "C400 = network_command, network_frequency, run",
        "SUM": "right",
    }
    assert "Reply: 2F 0B 50 FA 00 C4 00 48, or if tripped 2F 0B 70 FA 00 C4 00 68" in run.out
    assert "As a reply the same bytes say: inverter 11 has taken FA00 command_word" in run.out


@pytest.mark.parametrize(
    ("word", "frame", "field", "meaning"),
    [
        ("toshiba", "2F 0B 50 FA 01 13 88 20", "DATA", "1388 = 50.00 Hz"),
        ("toshiba.reply", "2F 0B 67 FC 90 00 18 45", "DATA", "0018 = Err5, "),
        ("toshiba.reply", "2F 0B 67 FC 90 00 18 45", "CMD", "g, read, with data that mean noth"),
        ("toshiba.reply", "2F 0B 67 FC 90 00 18 45", "CMD", "; the inverter has tripped"),
        ("toshiba.reply", "2F 4E 00 04 81", "code", "0004: the checksum is wrong"),
        ("toshiba", "2F 0B 47 FE 03 00 00 82", "DATA", "means nothing"),
        ("toshiba", "2F FF 73 FA 01 27 10 D3", "DATA", "2710 = 100.00 % of the maximum freq"),
        ("toshiba", "2F FF 50 FA 00 20 00 98", "INV-NO", "all inverters"),
        ("toshiba", "2F 0B 50 12 34 C4 00 94", "ComNo", "1234, which the catalogue does not know"),
        ("toshiba", "2F 58 02 05 C4 00 17 70 D9", "W2", "1770, for the ComNo chosen by F871"),
        ("toshiba", "2F 58 00 09 90", "nR", "9 to read, which is too many: none"),
        ("toshiba", "2F 59 01 00 17 70 10", "R1", "1770, of the ComNo chosen by F875"),
        ("toshiba", "2F 59 00 07 8F", "STATUS", "meaning unknown"),
        ("toshiba", "(*2PFA00C400)", "INV-NO", "*2, all inverters with the units digit 2"),
        ("toshiba", "(1*PFA00C400)\\r", "INV-NO", "1*, all inverters with the tens digit 1"),
        ("toshiba", "(RFE03)", "ComNo", "FE03, "),
        ("toshiba", "(R0000&61) CR", "SUM", "wrong: 60 is right"),
        ("toshiba", "(QFA00C400)", "CMD", "Q, which is no command"),
        ("toshiba", "2F0B50FA00C40049", "SUM", "wrong: 48 is right"),
        ("modbus", "01 06 FA 01 13 88 E5 84", "word", "1388 = 50.00 Hz"),
        ("modbus", "01 03 FD 00 00 01 B5 A6", "start", "FD00, "),
        ("modbus", "01 03 FD 00 00 01 B5 A7", "CRC", "wrong: B5 A6 is right"),
        ("modbus", "01 03 02 17 70 B6 50", "word 1", "1770"),
        ("modbus", "01 10 FA 01 00 01 60 D1", "count", "1 written"),
        ("modbus", "01 10 FA 01 00 01 02 17 70 F3 9A", "word 1", "FA01 frequency_setpoint: 1770 "),
        ("modbus", "01 90 04 4D C3", "code", "04: it cannot be executed"),
        ("modbus", "01 90 04 4D C3", "function", "write words: refused"),
        ("modbus", "01 90 05 8C 03", "code", "05: not known of inverters"),
        ("modbus", "01 2B 0E 01 00 70 77", "object", "0, maker"),
    ],
)
def test_decode_says_what_a_field_means(
    fbgen: Fbgen, word: str, frame: str, field: str, meaning: str
) -> None:
    run = fbgen("decode", word, frame, "--series", "vf-s11")
    assert (run.status, run.err) == (0, "")
    assert meaning in _rows(run.out)[field]


@pytest.mark.parametrize(
    ("frame", "remark"),
    [
        ("2F 58 02 05 C4 00 17 70 D8", "Reply: 2F 4E 00 04 81, refused with 0004: the checksum"),
        ("2F 58 02 05 C4 00 17 70 D9", "Reply: 2F .. 59 05 00, the words and the sum"),
        ("2F FF 50 FA 01 13 88 14", "Only inverter 0 answers, if there is one."),
        ("(1*PFA01C400)", "Only inverter 10 answers, if there is one."),
        ("2F FF 52 FC 90 0C", "Nobody answers: only writing to several inverters is valid."),
        ("2F 0B 50 FA 00 20 00 A4", "Nobody answers: the inverter resets."),
        ("2F 0B 53 FA 01 27 10 BF", "Nobody answers."),
        ("2F 0B 52 FC 90 18", "Reply: R, or if tripped r, the same ComNo and the value"),
        ("(11PFA01C400)", "Reply: (11PFA01C400) CR, or if tripped (11pFA01C400) CR"),
        ("(QFA00C400)", "Reply: (N0003) CR, refused with 0003: there is no such command"),
        ("2F 0B 67 FC 90 00 18 46", "The checksum is wrong: a master drops it."),
    ],
)
def test_decode_says_what_comes_back_in_the_toshiba_protocol(
    fbgen: Fbgen, frame: str, remark: str
) -> None:
    assert remark in fbgen("decode", "toshiba", frame, "--series", "vf-s11").out


@pytest.mark.parametrize(
    ("frame", "remark"),
    [
        ("01 03 FD 00 00 01 B5 A6", "Reply: 01 03 02, the words and the CRC, 7 bytes"),
        ("01 06 FA 01 13 88 E5 84", "Reply: 01 06 FA 01 13 88 E5 84\nAs a reply the same bytes"),
        ("01 10 18 70 00 02 04 C4 00 17 70 6D AF", "Reply: 01 10 18 70 00 02 46 B3"),
        (
            "01 10 18 70 00 03 04 C4 00 17 70 6C 7E",
            "Refused with 03, the data or their number are outside of the range: 01 90 03 0C 01",
        ),
        ("00 06 FA 00 C4 00 EA 03", "Nobody answers what is for all."),
        ("01 06 FA 00 20 00 A0 D2", "Nobody answers: the inverter resets."),
        ("01 2B 0E 01 00 70 77", "Reply: maker, product and version"),
        ("01 03 FD 00 00 01 B5 A7", "The CRC is wrong: nobody takes notice of it."),
    ],
)
def test_decode_says_what_comes_back_in_modbus(fbgen: Fbgen, frame: str, remark: str) -> None:
    assert remark in fbgen("decode", "modbus", frame, "--series", "vf-s11").out


@pytest.mark.parametrize("name", [*TOSHIBA_BINARY, *ASCII_CHECKED])
def test_every_kind_of_toshiba_frame_is_shown_byte_by_byte(fbgen: Fbgen, name: str) -> None:
    frame = {**TOSHIBA_BINARY, **ASCII_CHECKED}[name]
    data = json.loads(fbgen("decode", "toshiba", frame.hex(" "), "--json").out)
    assert data["checksum_right"]
    assert bytes.fromhex("".join(field["bytes"] for field in data["fields"])) == frame


@pytest.mark.parametrize("name", MODBUS)
def test_every_kind_of_modbus_frame_is_shown_byte_by_byte(fbgen: Fbgen, name: str) -> None:
    data = json.loads(fbgen("decode", "modbus", MODBUS[name].hex(), "--json").out)
    assert data["frame"] == data["right_frame"]
    assert bytes.fromhex("".join(field["bytes"] for field in data["fields"])) == MODBUS[name]


def test_json_of_a_frame_with_a_wrong_sum_has_the_right_one(fbgen: Fbgen) -> None:
    data = json.loads(fbgen("decode", "toshiba", "2F0B50FA00C40049", "--json").out)
    assert (data["direction"], data["checksum_right"]) == ("request", False)
    assert data["right_frame"] == "2F 0B 50 FA 00 C4 00 48"


@pytest.mark.parametrize(
    ("arguments", "frame"),
    [
        ("toshiba command=P inv_no=11 com_no=FA00 data=C400", "2F 0B 50 FA 00 C4 00 48"),
        ("toshiba command=p inv_no=11 com_no=FA00 data=C400", "2F 0B 50 FA 00 C4 00 48"),
        ("toshiba command=G inv_no=11 com_no=output_current_held", "2F 0B 47 FE 03 00 00 82"),
        ("toshiba command=R com_no=FC90", "2F 52 FC 90 0D"),
        ("toshiba command=P inv_no=all com_no=FA01 value=50", "2F FF 50 FA 01 13 88 14"),
        ("toshiba command=s inv_no=FF com_no=FA01 data=2710", "2F FF 73 FA 01 27 10 D3"),
        ("toshiba command=X write=C400,1770 read=5", "2F 58 02 05 C4 00 17 70 D9"),
        ("toshiba command=X read=3 inv_no=11", "2F 0B 58 00 03 95"),
        ("toshiba command=P form=ascii inv_no=*2 com_no=FA00 data=C400", "(*2PFA00C400&B8) CR"),
        ("toshiba command=W form=ascii sum=no com_no=0010 data=0064", "(W00100064) CR"),
        ("toshiba command=P form=ascii inv_no=1* com_no=FA00 data=C400", "(1*PFA00C400&B7) CR"),
        ("toshiba.reply command=G inv_no=11 com_no=FC90 data=18 tripped=yes", "2F 0B 67 FC 90 00"),
        ("toshiba.reply command=N error=4", "2F 4E 00 04 81"),
        ("toshiba.reply command=N error=3 form=ascii sum=no", "(N0003) CR"),
        ("toshiba.reply command=Y words=1770", "2F 59 01 00 17 70 10"),
        ("toshiba.reply command=R form=ascii com_no=FE03 data=077B sum=no", "(RFE03077B) CR"),
        ("modbus function=03 com_no=FD00", "01 03 FD 00 00 01 B5 A6"),
        ("modbus function=06 com_no=frequency_setpoint value=50", "01 06 FA 01 13 88 E5 84"),
        ("modbus function=06 com_no=FA00 data=C400 address=0", "00 06 FA 00 C4 00 EA 03"),
        ("modbus function=10 com_no=1870 words=C400,1770", "01 10 18 70 00 02 04 C4 00 17 70 6D"),
        (
            "modbus function=17 com_no=1870 words=C400,1770 read_com_no=1875 count=5",
            "01 17 18 75 00 05 18 70 00 02 04 C4 00 17 70 84 31",
        ),
        ("modbus function=2B", "01 2B 0E 01 00 70 77"),
        ("modbus.reply function=03 words=1770", "01 03 02 17 70 B6 50"),
        ("modbus.reply function=06 com_no=FA01 data=1388", "01 06 FA 01 13 88 E5 84"),
        ("modbus.reply function=10 com_no=1870 count=2", "01 10 18 70 00 02 46 B3"),
        ("modbus.reply function=17 words=6400,1770", "01 17 04 64 00 17 70"),
        ("modbus.reply function=10 exception=4", "01 90 04 4D C3"),
        (
            "modbus.reply function=2B maker=TOSHIBA product=VFS15-2037PM version=0100",
            "01 2B 0E 01 01 00 00 03 00 07 54 4F 53 48 49 42 41",
        ),
    ],
)
def test_encode_makes_a_frame_of_its_fields(fbgen: Fbgen, arguments: str, frame: str) -> None:
    run = fbgen("encode", *arguments.split(), "--series", "vf-s11")
    assert (run.status, run.err) == (0, "")
    assert run.out.startswith(frame)


@pytest.mark.parametrize(
    ("request_", "reply"),
    [
        ("01 03 FD 00 00 01 B5 A6", "01 03 02 17 70 B6 50"),
        ("01 17 FD 00 00 01 18 70 00 02 04 C4 00 17 70 FA F3", "01 17 02 17 70 B3 A0"),
    ],
)
def test_words_of_a_reply_have_the_names_that_its_request_gives(
    fbgen: Fbgen, request_: str, reply: str
) -> None:
    run = fbgen("decode", "modbus", reply, "--request", request_, "--series", "vf-s11")
    assert _rows(run.out)["word 1"] == "FD00 output_frequency: 1770 = 60.00 Hz"


@pytest.mark.parametrize(
    ("request_", "reply"),
    [
        ("modbus.read", "modbus.read.reply"),
        ("modbus.read_two", "modbus.read_two.reply"),
        ("modbus.block", "modbus.block.reply"),
        ("modbus.block.bad_count", "modbus.block.bad_count.reply"),
        ("modbus.identify", "modbus.identify.reply"),
        ("write", "write"),
    ],
)
def test_reply_of_the_manuals_is_one_to_its_request(
    fbgen: Fbgen, request_: str, reply: str
) -> None:
    run = fbgen("decode", "modbus", MODBUS[reply].hex(), "--request", MODBUS[request_].hex())
    assert (run.status, run.err) == (0, "")
    assert "MODBUS-RTU, reply" in run.out


@pytest.mark.parametrize(
    ("word", "reply", "request_", "message"),
    [
        ("modbus", "01 90 04 4D C3", "01 03 FD 00 00 01 B5 A6", "FB9045: ... function, ComNo or"),
        ("modbus", "01 10 18 70 00 02 46 B3", "010318700002C370", "FB9045: ... function, ComNo or"),
        (
            "modbus",
            "01 03 02 17 70 B6 50",
            "0103FD000002F5A7",
            "FB9045: ... number of words differ",
        ),
        ("modbus", "01 06 FA 00 C4 00 EB D2", "0106FA002000A0D2", "FB9045: ... ComNo or number of"),
        ("modbus", "02 83 03 F1 31", "01 03 FD 00 00 01 B5 A6", "FB9045: ... from device 2, and 1"),
        (
            "modbus",
            "01 03 02 17 70 B6 50",
            "01 03 FD 00 00 01 B5 A7",
            "FB9041: ... behind --request",
        ),
        ("toshiba", "2F 4E 00 04 81", "2F 52 FC 90 0D", "FB9045: ... names its ComNo"),
    ],
)
def test_request_that_does_not_belong_to_a_reply_is_a_diagnostic(
    fbgen: Fbgen, word: str, reply: str, request_: str, message: str
) -> None:
    run = fbgen("decode", word, reply, "--request", request_)
    assert (run.status, run.out) == (1, "")
    code, _, text = message.partition(": ... ")
    assert f"error[{code}]: " in run.err
    assert text in run.err


def test_encode_as_json_is_what_decode_gives(fbgen: Fbgen) -> None:
    made = fbgen("encode", "modbus", "function=03", "com_no=FD00", "--json").out
    assert made == fbgen("decode", "modbus.request", "01 03 FD 00 00 01 B5 A6", "--json").out


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        ("decode toshiba.answer 2F4E000481", "FB9044", "there are no frames 'toshiba.answer'"),
        ("encode modbus.x function=03", "FB9044", "there are no frames 'modbus.x'"),
        ("decode toshiba 2F0B5", "FB9040", "'2F0B5' are no bytes"),
        ("decode toshiba 2G", "FB9040", "'2G' are no bytes"),
        ("decode modbus (R0000)", "FB9040", "'(R0000)' are no bytes"),
        ("decode toshiba (R00\N{LATIN SMALL LETTER A WITH DIAERESIS})", "FB9040", "not ASCII"),
        ("decode toshiba 2F", "FB9041", "1 byte are too few"),
        ("decode toshiba 300B50FA00C40048", "FB9041", "it begins with 30, not with 2F or ("),
        ("decode toshiba 2F0B50FA00C400", "FB9041", "has 7 bytes, and with this CMD 8 bytes"),
        ("decode toshiba 2F0B51FA00C40048", "FB9041", "51 is no CMD here"),
        ("decode toshiba 2F0B4E00097D", "FB9041", "its code is none that a drive refuses with"),
        ("decode toshiba 2F0B58", "FB9041", "3 bytes are too few"),
        ("decode toshiba (1R0000)", "FB9041", "its form is none"),
        ("decode toshiba (", "FB9041", "its form is none"),
        ("decode modbus 01", "FB9041", "1 byte are too few"),
        ("decode modbus F803FD000001B5A6", "FB9041", "no device has the address 248"),
        ("decode modbus.reply 0104020000", "FB9041", "no inverter has the function 04"),
        ("decode modbus.request 0103FD0000B5A6", "FB9041", "it has 7 bytes, and with this funct"),
        ("decode modbus.reply 010301FFFFFF", "FB9041", "its fields do not fit together"),
        ("decode modbus.request 01101870", "FB9041", "4 bytes are too few"),
        ("decode toshiba 2F52FC900D --series vf-s12", "FB1205", "no drive series 'vf-s12'"),
        ("encode toshiba command=P com_no=FA00", "FB9042", "'data' is missing"),
        ("encode toshiba command", "FB9042", "'command' says no value"),
        ("encode toshiba command=R command=G com_no=0", "FB9042", "'command' is given twice"),
        ("encode toshiba command=R com_no=0 data=1", "FB9042", "this frame has no 'data'"),
        ("encode toshiba command=P com_no=FA01 data=1 value=1", "FB9042", "'data' and 'value'"),
        ("encode toshiba command=Q com_no=0", "FB9043", "'Q' of 'command' is none of these"),
        ("encode toshiba command=P com_no=FA000 data=0", "FB9043", "'FA000' of 'com_no' is no"),
        ("encode toshiba command=P com_no=FA00 data=C40000", "FB9043", "of 'data' is no word"),
        ("encode toshiba command=P com_no=FA01 value=50", "FB9043", "has no unit without"),
        ("encode toshiba command=P com_no=0 data=0 inv_no=64", "FB9043", "'64' of 'inv_no'"),
        ("encode toshiba command=R com_no=0 inv_no=*2", "FB9043", "'*2' of 'inv_no' is no INV-NO"),
        ("encode toshiba command=G com_no=0 form=ascii", "FB9043", "is none in ASCII"),
        ("encode toshiba command=X write=1,2,3", "FB9043", "'1,2,3' of 'write' has 3 words"),
        ("encode toshiba command=X read=6", "FB9043", "'6' of 'read' does not fit"),
        ("encode toshiba.reply command=N error=5", "FB9043", "'5' of 'error' does not fit"),
        ("encode modbus function=04 com_no=0", "FB9043", "'04' of 'function' is none of these"),
        ("encode modbus function=03 com_no=0 address=248", "FB9043", "'248' of 'address'"),
        ("encode modbus function=03 com_no=0 count=x", "FB9043", "'x' of 'count' does not fit"),
        ("encode modbus.reply function=03 words=1 address=0", "FB9043", "'0' of 'address'"),
        ("encode modbus.reply function=03 words=", "FB9042", "'words=' says no value"),
    ],
)
def test_a_wrong_frame_or_field_is_a_diagnostic(
    fbgen: Fbgen, arguments: str, code: str, message: str
) -> None:
    run = fbgen(*arguments.split())
    assert (run.status, run.out) == (1, "")
    assert f"error[{code}]: " in run.err
    assert message in run.err
    assert "= help: " in run.err


def test_names_of_an_identification_have_to_fit_and_to_be_ascii(fbgen: Fbgen) -> None:
    names = [f"maker={'T' * 250}", "product=VF", "version=\N{DEGREE SIGN}"]
    run = fbgen("encode", "modbus.reply", "function=2B", *names)
    assert "does not fit into the frame" in run.err
    assert "has characters that are not ASCII" in run.err


def test_value_has_to_be_one_of_its_comno(fbgen: Fbgen) -> None:
    fields = ["command=P", "com_no=FA01", "value=1000"]
    run = fbgen("encode", "toshiba", *fields, "--series", "vf-s11")
    assert "error[FB9043]: '1000' of 'value' is no value of FA01 frequency_setpoint" in run.err
    assert "= help: use 0 to 655.35 Hz" in run.err


def test_all_wrong_fields_are_reported_together(fbgen: Fbgen) -> None:
    run = fbgen("encode", "toshiba", "command=P", "inv_no=99", "data=x", "colour=red")
    assert run.err.count("error[FB9042]") == 2
    assert run.err.count("error[FB9043]") == 2
