"""Control and status word, counter of faulty telegrams (TOSPBDP001 manual, 8 A; HMS manuals)."""

import pytest

from fbgen.catalog import load_catalog
from fbgen.catalog.options import Option
from fbgen.wire.toshiba import seal
from harness.gateways.tospbdp001 import (
    ErrorCode,
    ErrorCounter,
    OfflineInputs,
    OfflineOutputs,
    StartupLock,
    StatusToggle,
    SubnetErrorLed,
    tospbdp001_settings,
)
from harness.kernel import NS_PER_MS

FAULTY = [
    pytest.param("2F0B47FE0312345D", id="wrong checksum"),
    pytest.param("2F0B4E000189", id="error reply, 6 bytes"),
    pytest.param("2F6E0002 9F", id="error reply without number, 5 bytes"),
    pytest.param("2F0B47FE03", id="too short"),
    pytest.param("2F0B47FE0312340000", id="too long"),
    pytest.param("2830305230303030290D", id="foreign ASCII"),
    pytest.param("00", id="a byte of noise"),
]


@pytest.mark.fact("tos.sw.poweron")
@pytest.mark.fact("C2-3")
def test_status_is_9f00_after_power_on(bench):
    assert bench.status == 0x9F00


@pytest.mark.fact("tos.sw.b14")
@pytest.mark.fact("C2-8")
def test_bit_14_follows_the_control_word_after_the_processing_time(bench):
    bench.control(0x4000)
    bench.run_ms(2)
    assert bench.status == 0x9F00
    bench.run_ms(7)
    assert bench.status == 0xDF00
    bench.control(0x0000)
    bench.run_ms(9)
    assert bench.status == 0x9F00


def test_a_control_word_that_never_stands_still_is_confirmed_all_the_same(bench):
    seen = set()
    for _ in range(10):
        for control in (0x4000, 0x4001):
            bench.control(control)
            bench.run_ms(4)  # less than the gateway's processing time
            seen.add(bench.status)
    assert 0xDF00 in seen


@pytest.mark.fact("C2-8")
@pytest.mark.parametrize("code", [0x0000, 0x1F00, 0x11AB])
def test_bit_14_is_confirmed_whatever_control_code_stands_beside_it(bench, code):
    bench.control(0x4000 | code)
    bench.run_ms(10)
    assert bench.status == 0xDF00


@pytest.mark.fact("tos.sw.b15")
def test_bit_15_is_toggled_for_new_status_information(bench):
    bench.control(0x8000)
    bench.run_ms(10)
    assert bench.status == 0x9F00
    bench.noise(b"\x00")
    assert bench.status == 0x0001


@pytest.mark.fact("tos.sw.b13")
def test_bit_13_of_the_status_is_always_0(bench):
    seen: set[int] = set()
    bench.master.taps.append(lambda transfer: seen.add(transfer.inputs[0] >> 5 & 1))
    for control in (0x2000, 0xE000, 0xFFFF, 0x0000):
        bench.control(control)
        bench.noise(b"\x00")
        bench.valid_reply()
    assert seen == {0}


@pytest.mark.fact("tos.sw.ok")
def test_without_faults_the_status_has_four_values(bench):
    words = []
    for control in (0x4000, 0x0000):
        bench.control(control)
        bench.run_ms(20)
        words.append(bench.status)
    bench.noise(b"\x00")
    bench.control(0x8000)
    bench.run_ms(20)
    for control in (0x8000, 0xC000):
        bench.control(control)
        bench.valid_reply()
        words.append(bench.status)
    assert words == [0xDF00, 0x9F00, 0x1F00, 0x5F00]


@pytest.mark.fact("tos.sw.count")
@pytest.mark.fact("C2-5")
@pytest.mark.fact("C2-6")
@pytest.mark.parametrize("frame", FAULTY)
def test_faulty_telegrams_are_counted_with_code_00_and_a_valid_one_clears(bench, frame):
    bench.noise(bytes.fromhex(frame))
    assert bench.status & 0x1FFF == 0x0001
    bench.noise(bytes.fromhex(frame))
    assert bench.status & 0x1FFF == 0x0002
    bench.valid_reply()
    assert bench.status & 0x1FFF == 0x1F00


@pytest.mark.fact("C2-6")
def test_the_words_after_power_on_without_handshake_are_8001_8002_and_9f00(bench):
    words = []
    for frame in (b"\x00", b"\x00", seal(bytes.fromhex("0B47FE031234"))):
        bench.noise(frame)
        words.append(bench.status)
    assert words == [0x8001, 0x8002, 0x9F00]


@pytest.mark.fact("C2-6")
def test_as_an_option_the_code_stays_1f_while_byte_2_counts(bench_of):
    bench = bench_of(error_code=ErrorCode.UNCHANGED)
    bench.noise(b"\x00")
    assert bench.status == 0x9F01


@pytest.mark.fact("C2-5")
@pytest.mark.parametrize(("counter", "count"), [("RESTART", 1), ("CONTINUE", 3)])
def test_the_counter_restarts_or_goes_on_after_a_valid_telegram(bench_of, counter, count):
    bench = bench_of(error_counter=ErrorCounter[counter])
    bench.noise(b"\x00")
    bench.noise(b"\x00")
    bench.valid_reply()
    assert bench.status & 0xFF == 0
    bench.noise(b"\x00")
    assert bench.status & 0xFF == count


@pytest.mark.fact("C2-5")
def test_the_counter_wraps_at_8_bits(bench):
    for _ in range(256):
        bench.noise(b"\x00")
    assert bench.status & 0xFF == 0
    bench.noise(b"\x00")
    assert bench.status & 0xFF == 1


def test_a_valid_telegram_after_a_full_turn_of_the_counter_still_shows_no_error(bench):
    for _ in range(256):
        bench.noise(b"\x00")
    bench.valid_reply()
    assert bench.status & 0x1FFF == 0x1F00


@pytest.mark.fact("C2-5")
def test_a_parity_error_makes_a_telegram_faulty(bench, disturb):
    disturb(bench.line.slave_pair)
    bench.valid_reply()
    assert bench.status & 0x1FFF == 0x0001
    assert bench.reply == bytes(6)


@pytest.mark.fact("C2-7")
def test_bit_15_waits_until_the_plc_has_taken_the_previous_status(bench):
    bench.noise(b"\x00")
    assert bench.status == 0x8001  # code and data are new, bit 15 still says what it said
    bench.control(0x8000)
    bench.run_ms(10)
    assert bench.status == 0x0001  # taken, so the news are announced


@pytest.mark.fact("C2-7")
def test_as_an_option_bit_15_is_toggled_with_every_change(bench_of):
    bench = bench_of(status_toggle=StatusToggle.ALWAYS)
    words = []
    for _ in range(3):
        bench.noise(b"\x00")
        words.append(bench.status)
    assert words == [0x0001, 0x8002, 0x0003]


@pytest.mark.fact("C2-7")
def test_as_an_option_the_whole_status_waits_until_the_previous_one_is_taken(bench_of):
    bench = bench_of(status_toggle=StatusToggle.POST_WHEN_TAKEN)
    bench.noise(b"\x00")
    bench.noise(b"\x00")
    assert bench.status == 0x9F00
    bench.control(0x8000)
    bench.run_ms(10)
    assert bench.status == 0x0002


@pytest.mark.fact("C2-9")
def test_a_missing_reply_changes_nothing_by_default(bench):
    bench.inverter.answer = lambda frame: b""
    before = bytes(bench.station.inputs)
    bench.send(0, 1, "FF50FA002000")
    bench.run_ms(5_000)
    assert bytes(bench.station.inputs) == before


@pytest.mark.fact("C2-9")
@pytest.mark.parametrize("behaviour", OfflineInputs)
def test_as_an_option_silence_is_reported_with_code_02(bench_of, behaviour):
    bench = bench_of(offline_timeout_ns=100 * NS_PER_MS, offline_inputs=behaviour)
    bench.valid_reply()
    reply = bench.reply
    bench.run_ms(70)
    assert bench.status & 0x1F00 == 0x1F00
    bench.run_ms(50)
    assert bench.status & 0x1FFF == 0x0201
    assert bench.reply == (reply if behaviour is OfflineInputs.FREEZE else bytes(6))
    bench.valid_reply()
    assert bench.status & 0x1FFF == 0x1F00


@pytest.mark.fact("C2-2")
def test_as_an_option_nothing_is_sent_until_the_plc_says_data_valid(bench_of):
    bench = bench_of(startup_lock=StartupLock.DATA_VALID)
    bench.send(0x0000, 1, "0B50FA00C400")
    bench.run_ms(60)
    assert bench.inverter.frames == []
    bench.send(0x2000, 2, "0B50FA00C400")
    bench.run_ms(60)
    assert len(bench.inverter.frames) == 1


def test_two_replies_that_collide_count_once(bench, scripted):
    other = scripted(bench, 0x0C)
    bench.inverter.say(seal(bytes.fromhex("0B47FE031234")))
    other.say(seal(bytes.fromhex("0C47FE031234")), 2 * NS_PER_MS)
    bench.run_ms(30)
    assert bench.status & 0xFF == 1


@pytest.mark.parametrize(
    ("option", "value", "setting", "chosen"),
    [
        ("offline_outputs", "freeze", "offline_outputs", OfflineOutputs.FREEZE),
        ("offline_inputs", "clear", "offline_inputs", OfflineInputs.CLEAR),
        ("startup_lock", "data_valid", "startup_lock", StartupLock.DATA_VALID),
        ("subnet_error_led", "subnet_status", "subnet_error_led", SubnetErrorLed.SUBNET_STATUS),
    ],
)
def test_a_catalogue_that_knows_a_choice_sets_it(option, value, setting, chosen):
    entry = load_catalog().gateway("tospbdp001")
    known = Option(
        id=option,
        title="a choice",
        type="choice",
        default=value,
        choices={value: "chosen"},
        applies_to="device",
        status="unverified",
    )
    others = tuple(item for item in entry.options if item.id != option)
    changed = entry.model_copy(update={"options": (*others, known)})
    settings = tospbdp001_settings(changed, changed.layout("gsd10"), {})
    assert getattr(settings, setting) is chosen
