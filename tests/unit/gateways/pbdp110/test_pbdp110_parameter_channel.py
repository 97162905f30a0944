"""The parameter channel: the whole procedure, requests, responses and errors (manual 10)."""

import pytest

from fbgen.wire.toshiba import ErrorCode
from harness.gateways.pbdp110 import DriveFacts

READ, WRITE_EEPROM, WRITE_RAM = 1, 2, 3
ACC = 0x0009


@pytest.mark.fact("pb.access")
def test_idle_loops_number_and_data_back(bench):
    bench.drive("a")
    bench.start()
    bench.send(40, a_action=0, a_number=0x1234, a_data=0x5678)
    assert bench.response("a") == (0, 0x1234, 0x5678)


@pytest.mark.fact("pb.access")
@pytest.mark.parametrize("channel", ["a", "b"])
def test_a_read_gives_the_number_and_the_value(bench, channel):
    bench.script("a")
    drive = bench.script(channel) if channel == "b" else None
    bench.lines["a"].ports[-1].node.cells = {ACC: 100}
    if drive is not None:
        drive.cells = {ACC: 100}
    bench.start()
    bench.request(channel, READ, ACC, 0xAAAA)
    assert bench.response(channel) == (1, ACC, 100)


@pytest.mark.fact("pb.access")
@pytest.mark.parametrize(("code", "cycles"), [(WRITE_RAM, 0), (WRITE_EEPROM, 1)])
def test_a_write_is_told_alike_wherever_it_is_kept(bench, code, cycles):
    drive = bench.drive("a")
    bench.start()
    before = drive.registers.write_cycles[ACC]
    bench.request("a", code, ACC, 250)
    assert bench.response("a") == (2, ACC, 250)
    assert drive.read_word(ACC) == 250
    assert drive.registers.write_cycles[ACC] - before == cycles


@pytest.mark.fact("pb.access")
def test_until_idle_was_sent_again_everything_else_is_ignored(bench):
    drive = bench.drive("a")
    bench.start()
    bench.request("a", READ, ACC)
    first = bench.response("a")
    bench.send(200, a_number=0x0010, a_data=77, a_action=WRITE_RAM << 12)
    assert bench.response("a") == first
    assert drive.read_word(0x0010) != 77
    bench.send(40, a_action=0)
    assert bench.response("a") == (0, 0x0010, 77)
    bench.send(200, a_action=WRITE_RAM << 12)
    assert bench.response("a") == (2, 0x0010, 77)


@pytest.mark.fact("pb.access")
def test_a_request_that_stands_there_from_the_beginning_is_not_taken(bench):
    drive = bench.drive("a")
    bench.device.supply("a", True)
    bench.parametrise()
    bench.send(500, a_number=ACC, a_data=77, a_action=WRITE_RAM << 12)
    assert bench.response("a") == (0, 0, 0)
    assert drive.read_word(ACC) != 77


@pytest.mark.fact("pb.access")
def test_a_request_that_is_given_up_before_its_answer_gets_none(bench):
    bench.drive("a")
    bench.start()
    bench.request("a", READ, ACC, ms=1)
    assert bench.response("a")[0] == 0
    bench.send(300, a_action=0, a_number=0x4444)
    assert bench.response("a") == (0, 0x4444, 0)


@pytest.mark.fact("pb.time")
def test_the_answer_takes_several_to_several_tens_of_milliseconds(bench):
    bench.drive("a")
    bench.start()
    bench.request("a", READ, ACC, ms=0)
    times = [ms for ms in range(1, 91) if bench.run_ms(1) or bench.response("a")[0]]
    assert 3 <= times[0] <= 60


@pytest.mark.fact("pb.errors")
@pytest.mark.parametrize(
    ("refusal", "meaning"),
    [
        (ErrorCode.CANNOT_EXECUTE, "cannot execute"),
        (ErrorCode.DATA, "data error (written data value outside of valid range)"),
        (ErrorCode.COM_NO, "invalid parameter number"),
        (ErrorCode.CHECKSUM, "other / unclassified error"),
    ],
)
def test_what_a_drive_refuses_is_told_by_its_error_code(bench, vectors, refusal, meaning):
    codes = {row["meaning"]: int(row["code"], 16) for row in vectors["pbdp.error_codes"]["codes"]}
    drive = bench.script("a")
    drive.cells = dict.fromkeys((0xFE01, 0xFD00, 0xFE03, 0xFE05), 0)
    drive.refusal = refusal
    bench.start()
    bench.request("a", WRITE_RAM, ACC, 1)
    assert bench.response("a") == (3, ACC, codes[meaning])


@pytest.mark.fact("pb.errors")
@pytest.mark.parametrize("code", [WRITE_RAM, WRITE_EEPROM])
def test_writing_what_can_only_be_read_is_an_error_without_a_telegram(bench, code):
    drive = bench.script("a")
    bench.start()
    drive.written.clear()
    bench.request("a", code, 0xFD00, 1)
    assert bench.response("a") == (3, 0xFD00, 0x0064)
    assert drive.written == []


@pytest.mark.fact("pb.errors")
def test_reading_what_can_only_be_written_is_an_error(make_bench):
    bench = make_bench(2, facts={"a": DriveFacts(write_only=frozenset({0xFA26}))})
    bench.script("a")
    bench.start()
    bench.request("a", READ, 0xFA26)
    assert bench.response("a") == (3, 0xFA26, 0x0065)


@pytest.mark.fact("pb.errors")
def test_a_drive_itself_refuses_a_value_out_of_range_and_an_unknown_number(bench):
    drive = bench.drive("a")
    bench.start()
    bench.request("a", WRITE_RAM, 0x0011, 0xFFFF)
    assert bench.response("a") == (3, 0x0011, 0x0001)
    bench.request("a", READ, 0x7777)
    assert bench.response("a") == (3, 0x7777, 0x0002)
    drive.registers.locked = True
    bench.request("a", WRITE_RAM, ACC, 100)
    assert bench.response("a") == (3, ACC, 0x0000)


@pytest.mark.fact("pb.local")
@pytest.mark.parametrize("channel", ["a", "b"])
def test_the_firmware_is_read_at_either_channel_and_cannot_be_written(make_bench, channel):
    bench = make_bench(2, {"firmware": 0x0203})
    bench.drive("a")
    bench.drive("b")
    bench.start()
    bench.request(channel, READ, 0xFC82)
    assert bench.response(channel) == (1, 0xFC82, 0x0203)
    bench.request(channel, WRITE_RAM, 0xFC82, 1)
    assert bench.response(channel) == (3, 0xFC82, 0x0064)


@pytest.mark.fact("pb.access")
def test_the_cyclic_data_go_on_while_parameters_are_accessed(bench):
    drive = bench.drive("a")
    bench.start()
    bench.send(0, a_command=0xC400, a_frequency=2000)
    bench.request("a", READ, ACC)
    bench.run_ms(300)
    assert drive.running
    assert bench.word("a_frequency") == 2000
