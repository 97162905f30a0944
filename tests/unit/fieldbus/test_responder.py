"""A slave's answers to telegrams (EN 50170 volume 2), byte by byte where bytes matter."""

from dataclasses import replace

import pytest

from fbgen.wire.dp import ControlCommand, SlaveSap
from fbgen.wire.fdl import (
    DataTelegram,
    RequestFunction,
    ShortAcknowledgement,
    Token,
    encode,
    first_request_control,
    request_control,
)
from harness.fieldbus import (
    NO_MASTER,
    Parameters,
    Segment,
    SlaveState,
    SlaveType,
    decode_parameters,
)
from tests.unit.fieldbus.wire_bench import (
    CONFIGURATION,
    GOOD,
    IDENT,
    NEITHER,
    UNLOCK,
    WireBench,
    is_refused,
)

ACKNOWLEDGED = ShortAcknowledgement()


@pytest.fixture
def slave() -> WireBench:
    """A slave that waits for parameters."""
    return WireBench()


@pytest.fixture
def running() -> WireBench:
    """A slave in data exchange with master 1."""
    return WireBench().running()


@pytest.mark.fact("dp.sap")
def test_the_bytes_from_power_on_to_data_exchange(slave):
    talk = {
        "10 07 01 49 51 16": "10 01 07 00 08 16",
        "68 05 05 68 87 81 6D 3C 3E EF 16": ("68 0B 0B 68 81 87 08 3E 3C 02 05 00 FF 12 34 D6 16"),
        "68 0C 0C 68 87 81 5D 3D 3E 88 01 0A 0B 12 34 00 C4 16": "E5",
        "68 08 08 68 87 81 7D 3E 3E A3 91 30 65 16": "E5",
        "68 05 05 68 87 81 5D 3C 3E DF 16": ("68 0B 0B 68 81 87 08 3E 3C 00 0C 00 01 12 34 DD 16"),
        "68 08 08 68 07 01 7D 01 02 03 04 05 94 16": "68 06 06 68 01 07 08 00 00 00 10 16",
    }
    for request, answer in talk.items():
        assert slave.octets(bytes.fromhex(request)) == bytes.fromhex(answer), request
    assert slave.device.told == ["started", "0102030405"]


@pytest.mark.fact("dp.prm")
def test_set_prm_is_decoded_and_encoded():
    data = bytes.fromhex("B8 02 64 0B 12 34 05 AA BB")
    parameters = decode_parameters(data)
    assert parameters == Parameters(0x1234, (2, 100), 0x05, b"\xaa\xbb", min_tsdr=11)
    assert parameters.encode() == data
    assert UNLOCK.encode() == bytes.fromhex("70 01 01 0B 12 34 00")
    assert decode_parameters(UNLOCK.encode()) == UNLOCK
    assert decode_parameters(NEITHER.encode()) == NEITHER
    assert decode_parameters(bytes(6)) is None


@pytest.mark.parametrize(
    "wrong",
    [
        pytest.param(replace(GOOD, ident_number=0x4321).encode(), id="ident"),
        pytest.param(replace(GOOD, user_data=b"\x00").encode(), id="user data"),
        pytest.param(replace(GOOD, watchdog_factors=(0, 5)).encode(), id="watchdog factor 0"),
        pytest.param(GOOD.encode()[:6], id="too short"),
    ],
)
def test_wrong_parameters_are_acknowledged_and_told_by_the_diagnosis(slave, wrong):
    assert slave.ask(SlaveSap.SET_PRM, wrong) == ACKNOWLEDGED
    assert slave.slave.state is SlaveState.WAIT_PRM
    assert slave.diagnosis()[:4] == bytes.fromhex("42 05 00 FF")
    assert is_refused(slave.chk_cfg())


@pytest.mark.parametrize("configuration", ["", "A3 91", "A3 91 30 30", "30 91 A3", "C0 80"])
def test_a_wrong_configuration_is_acknowledged_and_told_by_the_diagnosis(slave, configuration):
    slave.set_prm()
    assert slave.chk_cfg(bytes.fromhex(configuration)) == ACKNOWLEDGED
    assert slave.slave.state is SlaveState.WAIT_PRM
    assert slave.diagnosis()[:4] == bytes.fromhex("06 05 00 FF")


def test_a_wrong_configuration_ends_data_exchange(running):
    assert running.chk_cfg(CONFIGURATION) == ACKNOWLEDGED
    assert running.device.told == []
    assert running.chk_cfg(b"\x30") == ACKNOWLEDGED
    assert running.device.told == ["lost"]
    assert is_refused(running.exchange())


def test_services_that_are_not_there_now_are_refused(slave):
    assert is_refused(slave.chk_cfg())
    assert is_refused(slave.exchange())
    assert is_refused(slave.ask(SlaveSap.RD_INP))
    assert is_refused(slave.ask(SlaveSap.RD_OUTP))
    slave.set_prm()
    assert is_refused(slave.exchange())


def test_inputs_outputs_and_configuration_can_be_read_by_any_master(running):
    running.slave.set_inputs(b"\x01\x02\x03")
    running.exchange(b"\x09\x08\x07\x06\x05")
    for master in (1, 3):
        assert running.ask(SlaveSap.RD_INP, master=master).data == b"\x01\x02\x03"
        assert running.ask(SlaveSap.RD_OUTP, master=master).data == b"\x09\x08\x07\x06\x05"
        assert running.ask(SlaveSap.GET_CFG, master=master).data == CONFIGURATION


@pytest.mark.parametrize("sap", [0, 1, SlaveSap.SET_SLAVE_ADD, SlaveSap.GLOBAL_CONTROL, 63])
def test_access_points_that_are_not_there_are_refused(running, sap):
    assert is_refused(running.ask(sap))


def test_access_points_are_for_requests_of_a_master(running):
    wrong = DataTelegram(7, 1, 0x4D, b"", SlaveSap.SLAVE_DIAG, 61)
    assert is_refused(running.telegram(wrong))
    assert is_refused(running.telegram(replace(wrong, source_sap=None)))
    assert is_refused(running.telegram(replace(wrong, destination_sap=None)))
    assert is_refused(running.ask(SlaveSap.SLAVE_DIAG, b"\x00"))


@pytest.mark.parametrize("function", [0x3, 0x5, 0x7, 0xE, 0xF])
def test_functions_that_a_dp_slave_does_not_offer_are_refused(running, function):
    assert is_refused(running.telegram(DataTelegram(7, 1, 0x40 | function)))


@pytest.mark.parametrize(
    "telegram",
    [
        pytest.param(DataTelegram(8, 1, 0x49), id="for another station"),
        pytest.param(DataTelegram(7, 1, 0x41), id="reserved function"),
        pytest.param(DataTelegram(7, 1, 0x40), id="time event"),
        pytest.param(DataTelegram(7, 1, 0x08, b"\x01"), id="reply"),
        pytest.param(DataTelegram(127, 1, 0x4D, bytes(5)), id="request to all"),
        pytest.param(Token(7, 1), id="token"),
        pytest.param(ACKNOWLEDGED, id="short acknowledgement"),
    ],
)
def test_silence(running, telegram):
    assert running.telegram(telegram) is None
    assert running.device.told == []


def test_a_slave_without_supply_is_silent(running):
    running.slave.power_off()
    assert running.telegram(DataTelegram(7, 1, 0x49)) is None


@pytest.mark.parametrize("sap", [None, 56, 57, 58, 59, 60, 61, 62])
def test_every_bit_that_is_wrong_and_every_byte_that_is_missing_gets_silence(running, sap):
    contents = {None: b"\x01" * 5, 58: b"\x02\x00", 61: UNLOCK.encode(), 62: b"\x30"}
    control = request_control(RequestFunction.SDN_HIGH if sap == 58 else RequestFunction.SRD_HIGH)
    source_sap = None if sap is None else 62
    whole = encode(DataTelegram(7, 1, control, contents.get(sap, b""), sap, source_sap))
    broken = [whole[:length] for length in range(len(whole))]
    for bit in range(len(whole) * 8):
        damaged = bytearray(whole)
        damaged[bit // 8] ^= 1 << bit % 8
        broken.append(bytes(damaged))
    for data in broken:
        assert running.octets(data) + running.segment.silence() == b""
    assert running.device.told == []
    assert running.slave.state is SlaveState.DATA_EXCHANGE


# --- masters ----------------------------------------------------------------------------------


def test_another_master_is_refused_until_the_slave_is_unlocked(running):
    assert is_refused(running.set_prm(master=3))
    assert is_refused(running.chk_cfg(master=3))
    assert is_refused(running.exchange(master=3))
    assert running.diagnosis(master=3)[3] == 1
    assert running.device.told == []
    assert running.set_prm(UNLOCK) == ACKNOWLEDGED
    assert running.device.told == ["lost"]
    assert running.slave.master_address == NO_MASTER
    assert running.set_prm(master=3) == ACKNOWLEDGED
    assert running.slave.master_address == 3


def test_neither_lock_nor_unlock_leaves_everything_as_it_is(slave):
    assert slave.set_prm(NEITHER) == ACKNOWLEDGED
    assert slave.slave.state is SlaveState.WAIT_PRM
    slave.running()
    assert slave.set_prm(NEITHER) == ACKNOWLEDGED
    assert slave.slave.state is SlaveState.DATA_EXCHANGE
    assert slave.device.told == []


def test_unlock_wins_over_lock(running):
    both = bytearray(GOOD.encode())
    both[0] |= 0x40
    running.ask(SlaveSap.SET_PRM, bytes(both))
    assert running.slave.master_address == NO_MASTER


# --- repeated requests --------------------------------------------------------------------------


def counted(bit):
    return request_control(RequestFunction.SRD_HIGH, bit)


def test_a_repeated_request_gets_the_stored_answer(running):
    running.slave.set_inputs(b"\x01\x00\x00")
    first = running.ask(None, b"\x01\x00\x00\x00\x00", control=counted(False))
    running.slave.set_inputs(b"\x02\x00\x00")
    assert running.ask(None, b"\x02\x00\x00\x00\x00", control=counted(False)) == first
    assert running.device.told == ["0100000000"]
    new = running.ask(None, b"\x02\x00\x00\x00\x00", control=counted(True))
    assert new.data == b"\x02\x00\x00"
    assert running.device.told == ["0100000000", "0200000000"]


def test_the_first_request_of_a_master_is_never_taken_for_a_repeated_one(running):
    begin = first_request_control(RequestFunction.SRD_HIGH)
    for outputs in (b"\x01", b"\x02"):
        running.ask(None, outputs + bytes(4), control=begin)
    assert running.device.told == ["0100000000", "0200000000"]
    running.ask(None, b"\x03" + bytes(4), control=counted(True))
    assert len(running.device.told) == 2
    running.ask(None, b"\x03" + bytes(4), control=counted(False))
    assert running.device.told[-1] == "0300000000"


def test_a_request_of_another_station_or_without_count_ends_the_memory(running):
    for disturb in (
        lambda: running.diagnosis(master=3),
        running.diagnosis,
    ):
        running.ask(None, b"\x01" + bytes(4), control=counted(True))
        disturb()
        running.ask(None, b"\x02" + bytes(4), control=counted(True))
        assert running.device.told[-1] == "0200000000"
        running.ask(None, bytes(5), control=counted(False))


def test_a_slave_does_not_remember_what_was_before_power_off(running):
    running.ask(None, bytes(5), control=counted(True))
    running.slave.power_off()
    running.slave.power_on(7)
    assert is_refused(running.ask(None, bytes(5), control=counted(True)))


# --- watchdog -----------------------------------------------------------------------------------


@pytest.mark.fact("dp.wd")
def test_the_watchdog_runs_anew_with_every_request_of_the_slaves_master(running):
    for _ in range(5):
        running.run_ms(90)
        running.diagnosis()
    running.run_ms(90)
    running.diagnosis(master=3)
    assert running.slave.online
    running.run_ms(15)
    assert running.device.told == ["lost"]
    assert running.slave.master_address == NO_MASTER
    assert is_refused(running.exchange())


def test_a_repeated_request_is_a_sign_of_life(running):
    for _ in range(4):
        running.run_ms(90)
        running.ask(None, bytes(5), control=counted(True))
    assert running.slave.online


def test_the_watchdog_expires_exactly_one_watchdog_time_after_the_last_request(running):
    running.run_ms(30)
    running.exchange()
    running.run_ms(99.9)
    assert running.slave.online
    running.run_ms(0.1)
    assert not running.slave.online


def test_a_shorter_watchdog_time_counts_at_once(running):
    running.set_prm(replace(GOOD, watchdog_factors=(1, 1)))
    running.chk_cfg()
    running.exchange()
    running.run_ms(10)
    assert not running.slave.online


@pytest.mark.fact("dp.nowd")
def test_without_watchdog_a_slave_waits_for_ever(slave):
    slave.set_prm(replace(GOOD, watchdog_factors=None))
    slave.chk_cfg()
    slave.exchange(b"\x01" + bytes(4))
    slave.run_ms(600_000)
    assert slave.slave.outputs[0] == 1
    assert isinstance(slave.exchange(), DataTelegram)


# --- Global_Control -----------------------------------------------------------------------------


@pytest.mark.fact("dp.gc")
def test_global_control_counts_from_the_slaves_own_master_only(running):
    running.global_control(ControlCommand.SYNC, master=3)
    assert not running.slave.sync
    running.global_control(ControlCommand.SYNC, groups=0x04)
    assert not running.slave.sync
    running.global_control(ControlCommand.SYNC, groups=0x06)
    assert running.slave.sync
    assert running.diagnosis()[1] & 0x20


def test_sync_and_freeze_that_were_not_asked_for_in_set_prm_do_nothing(slave):
    slave.set_prm(replace(GOOD, sync=False, freeze=False))
    slave.chk_cfg()
    slave.exchange()
    slave.global_control(ControlCommand.SYNC | ControlCommand.FREEZE)
    assert not slave.slave.sync
    assert not slave.slave.freeze


def test_clear_data_puts_out_zeros(running):
    running.exchange(b"\x01\x02\x03\x04\x05")
    running.global_control(ControlCommand.CLEAR_DATA)
    assert running.device.told == ["0102030405", "0000000000"]


def test_inputs_are_not_frozen_any_more_in_the_next_data_exchange(running):
    running.global_control(ControlCommand.FREEZE)
    running.slave.set_inputs(b"\x01\x00\x00")
    assert running.exchange().data == bytes(3)
    running.set_prm()
    running.chk_cfg()
    assert running.exchange().data == b"\x01\x00\x00"


# --- diagnosis of the device --------------------------------------------------------------------


@pytest.mark.fact("dp.ext")
def test_a_diagnosis_is_asked_for_by_answers_of_high_priority_until_the_master_has_it():
    bench = WireBench(SlaveType(IDENT, CONFIGURATION, max_diagnosis_bytes=8)).running()
    assert bench.exchange().control == 0x08
    bench.slave.set_ext_diag(True, b"\x02\x01")
    assert [bench.exchange().control, bench.exchange().control] == [0x0A, 0x0A]
    assert bench.diagnosis(master=3)[6:] == b"\x02\x01"
    assert bench.exchange().control == 0x0A
    assert bench.diagnosis() == bytes.fromhex("08 0C 00 01 12 34 02 01")
    assert bench.exchange().control == 0x08
    bench.slave.set_ext_diag(False, b"\x02\x00")
    assert bench.exchange().control == 0x0A
    assert bench.diagnosis() == bytes.fromhex("00 0C 00 01 12 34 02 00")
    assert bench.exchange().control == 0x08


def test_more_diagnosis_than_fits_sets_the_overflow_bit(running):
    running.slave.set_ext_diag(True, b"\x02\x01")
    assert running.diagnosis() == bytes.fromhex("08 0C 80 01 12 34")


# --- configurations -----------------------------------------------------------------------------


def test_outputs_of_a_wrong_length_end_data_exchange(running):
    assert is_refused(running.exchange(bytes(4)))
    assert running.device.told == ["lost"]
    assert running.diagnosis()[:4] == bytes.fromhex("02 05 00 FF")


def test_special_identifier_formats_say_how_long_the_outputs_are():
    whole = bytes.fromhex("C0 89 87")
    bench = WireBench(SlaveType(IDENT, CONFIGURATION, other_configurations=(whole,)))
    bench.set_prm()
    assert bench.chk_cfg(whole) == ACKNOWLEDGED
    bench.slave.set_inputs(bytes(range(8)))
    assert bench.exchange(bytes(10)).data == bytes(range(8))
    assert bench.ask(SlaveSap.GET_CFG).data == whole


def test_the_master_may_choose_another_module_in_the_middle():
    bench = WireBench(SlaveType(IDENT, CONFIGURATION, other_configurations=(b"\x31",))).running()
    assert bench.chk_cfg(b"\x31") == ACKNOWLEDGED
    assert bench.device.told == ["lost"]
    assert isinstance(bench.exchange(b"\x01\x02"), DataTelegram)
    assert bench.device.told == ["lost", "started", "0102"]


def test_a_device_of_another_type_refuses_what_the_first_one_took(running):
    running.slave.become(SlaveType(IDENT, b"\x31"))
    running.set_prm()
    running.chk_cfg()
    assert running.diagnosis()[0] == 0x06


def test_an_output_module_alone_is_acknowledged_short():
    bench = WireBench(SlaveType(IDENT, b"\x21"))
    bench.set_prm()
    bench.chk_cfg(b"\x21")
    assert bench.exchange(b"\x01\x02") == ACKNOWLEDGED
    bench.slave.set_ext_diag(True)
    assert bench.exchange(b"\x01\x02").control == 0x0A


def test_slaves_on_one_cable_answer_for_themselves(running):
    other = WireBench()
    other.slave.power_off()
    other.slave.power_on(8)
    segment = Segment(running.kernel, [running.slave, other.slave])
    status = [encode(DataTelegram(address, 1, 0x49)) for address in (7, 8, 9)]
    answers = [encode(DataTelegram(1, address, 0)) for address in (7, 8)]
    assert segment.receive(b"".join(status)) == b"".join(answers)
    assert (segment.requests, segment.answers) == (3, 2)
