"""From the trigger byte to the frame on the line and back (TOSPBDP001 manual, 8 B to 9)."""

import pytest

from fbgen.wire.toshiba import seal
from harness.gateways.tospbdp001 import Memory
from harness.kernel import NS_PER_MS
from harness.line import Parity

START = "0B50FA00C400"
FREQUENCY = "0B50FA011388"


@pytest.mark.fact("tos.what")
def test_header_and_checksum_are_added_towards_the_drive_and_removed_towards_the_plc(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(60)
    assert bench.inverter.frames == [bytes.fromhex("2F 0B 50 FA 00 C4 00 48")]
    assert bench.reply == bytes.fromhex(START)


def test_a_gateway_that_kept_its_supply_knows_the_trigger_and_the_reply(bench):
    bench.gateway.power_off()
    bench.send(0xE000, 1, START)
    bench.gateway.power_on(Memory(trigger=1, status=0x9F00, reply=bytes.fromhex(FREQUENCY)))
    bench.run_ms(40)
    assert bench.station.inputs[2:] == bytes.fromhex(FREQUENCY)
    assert bench.inverter.frames == []
    bench.send(0xE000, 2, START)
    bench.run_ms(30)
    assert bench.inverter.frames == [bytes.fromhex("2F 0B 50 FA 00 C4 00 48")]


@pytest.mark.fact("tos.io")
@pytest.mark.parametrize(("layout", "outputs"), [("gsd10", 10), ("doc9", 9), ("whole10", 10)])
def test_each_layout_carries_the_same_telegram(bench_of, layout, outputs):
    bench = bench_of(layout)
    assert (len(bench.station.outputs), len(bench.station.inputs)) == (outputs, 8)
    bench.send(0xE000, 1, FREQUENCY)
    bench.run_ms(60)
    assert bench.inverter.frames == [bytes.fromhex("2F 0B 50 FA 01 13 88 20")]


def test_the_undocumented_byte_of_the_gsd_layout_goes_nowhere(bench):
    bench.send(0xE000, 1, START)
    bench.station.write(7, b"\xaa")
    bench.run_ms(60)
    assert bench.inverter.frames == [bytes.fromhex("2F 0B 50 FA 00 C4 00 48")]


@pytest.mark.fact("tos.sub.serial")
def test_the_line_runs_at_19200_baud_8e1(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(30)
    sent = bench.on_line[0]
    assert (sent.format.baud, sent.format.parity, sent.format.stop_bits) == (19200, Parity.EVEN, 1)


@pytest.mark.fact("tos.t.wire")
def test_eight_bytes_take_about_five_milliseconds_each_way(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(60)
    there, back = bench.on_line
    assert there.end_ns - there.start_ns == 4_583_333
    assert back.end_ns - back.start_ns == 5_000_000


@pytest.mark.fact("tos.trig")
def test_only_a_change_of_the_trigger_sends(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(60)
    bench.send(0xE000, 1, FREQUENCY)
    bench.run_ms(60)
    assert len(bench.inverter.frames) == 1
    bench.send(0xE000, 2, FREQUENCY)
    bench.run_ms(60)
    assert bench.inverter.frames[1:] == [seal(bytes.fromhex(FREQUENCY))]


@pytest.mark.fact("tos.trig")
def test_the_trigger_is_00_after_power_on(bench):
    bench.send(0xE000, 0, START)
    bench.run_ms(60)
    assert bench.inverter.frames == []


@pytest.mark.fact("tos.trig")
def test_a_changed_trigger_repeats_the_same_telegram(bench):
    for trigger in (1, 2, 3):
        bench.send(0xE000, trigger, START)
        bench.run_ms(60)
    assert bench.inverter.frames == [seal(bytes.fromhex(START))] * 3


@pytest.mark.fact("tos.trig.overwrite")
def test_a_telegram_that_still_waits_is_overwritten(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(3)
    bench.send(0xE000, 2, FREQUENCY)
    bench.run_ms(60)
    assert bench.inverter.frames == [seal(bytes.fromhex(FREQUENCY))]
    assert bench.gateway.overwritten == 1


@pytest.mark.fact("tos.trig.overwrite")
def test_a_plc_that_triggers_all_the_time_is_served_at_the_pace_of_the_gateway(bench):
    for trigger in range(1, 21):
        bench.send(0xE000, trigger, START)
        bench.run_ms(4)  # less than the gateway's processing time
    bench.run_ms(60)
    assert len(bench.inverter.frames) > 5
    assert bench.gateway.overwritten + bench.gateway.telegrams == 20


@pytest.mark.fact("tos.trig.overwrite")
def test_a_telegram_that_is_being_sent_is_not_overwritten(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(8)
    bench.send(0xE000, 2, FREQUENCY)
    bench.run_ms(60)
    assert bench.inverter.frames == [seal(bytes.fromhex(START)), seal(bytes.fromhex(FREQUENCY))]
    assert bench.gateway.overwritten == 0


@pytest.mark.fact("tos.trig.overwrite")
def test_a_telegram_behind_a_heartbeat_waits_in_the_same_buffer(bench_of):
    bench = bench_of(heartbeat_ns=30 * NS_PER_MS)
    bench.run_ms(14)  # the bus came up at 10 ms: the first heartbeat takes 40 to 48 ms
    bench.send(0xE000, 1, START)  # there at 36 ms, ready at 41 ms
    bench.run_ms(10)
    bench.send(0xE000, 2, FREQUENCY)  # there at 46 ms
    bench.run_ms(15)
    assert bench.inverter.frames == [seal(bytes.fromhex(FREQUENCY))]


def test_a_telegram_follows_the_heartbeat_without_touching_it(bench_of):
    bench = bench_of(heartbeat_ns=30 * NS_PER_MS)
    bench.run_ms(15)
    bench.send(0xE000, 1, START)
    bench.run_ms(20)
    assert all(not sent.collided for sent in bench.on_line)
    assert bench.on_line[1].start_ns == bench.on_line[0].end_ns


@pytest.mark.fact("tos.t.gw")
def test_the_gateway_takes_five_milliseconds_each_way(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(60)
    delivered_ns = 22 * NS_PER_MS
    there, back = bench.on_line
    assert there.start_ns == delivered_ns + 5 * NS_PER_MS
    bench_inputs_ns = back.end_ns + 5 * NS_PER_MS
    assert bench_inputs_ns == delivered_ns + 39_583_333


@pytest.mark.fact("tos.t.total")
@pytest.mark.fact("tos.t.reply")
@pytest.mark.parametrize("reply_ms", [11, 20])
def test_an_answer_takes_30_to_40_milliseconds_from_profibus_to_profibus(bench, reply_ms):
    answered: list[int] = []
    bench.master.taps.append(
        lambda transfer: answered.append(transfer.time_ns) if transfer.inputs[2] else None
    )
    bench.inverter.reply_ns = reply_ms * NS_PER_MS
    bench.send(0xE000, 1, START)
    sent_ns = bench.kernel.now_ns + 2 * NS_PER_MS
    bench.run_ms(60)
    assert 30 * NS_PER_MS <= answered[0] - sent_ns <= 40 * NS_PER_MS


@pytest.mark.fact("tos.cmd.47")
@pytest.mark.fact("tos.cmd.50")
@pytest.mark.fact("tos.cmd.57")
@pytest.mark.parametrize("cmd", ["47", "50", "57"])
def test_every_command_goes_through_unchanged(bench, cmd):
    bench.send(0, 1, f"0B{cmd}FE031234")
    bench.run_ms(60)
    assert bench.inverter.frames == [seal(bytes.fromhex(f"0B{cmd}FE031234"))]
    assert bench.reply == bytes.fromhex(f"0B{cmd}FE031234")


@pytest.mark.fact("tos.cmd.53")
@pytest.mark.parametrize("cmd", ["53", "73"])
def test_a_command_without_acknowledgement_leaves_the_inputs_as_they_are(bench, cmd):
    bench.inverter.answer = lambda frame: b""
    before = bytes(bench.station.inputs)
    bench.send(0, 1, f"0B{cmd}FA012710")
    bench.run_ms(200)
    assert bench.inverter.frames == [seal(bytes.fromhex(f"0B{cmd}FA012710"))]
    assert bytes(bench.station.inputs) == before


@pytest.mark.fact("tos.t.gap")
def test_telegrams_too_close_to_each_other_make_two_drives_answer_at_once(bench, scripted):
    other = scripted(bench, 0x0C)
    bench.send(0, 1, "0B47FE030000")
    bench.run_ms(8)
    bench.send(0, 2, "0C47FE030000")
    bench.run_ms(60)
    assert len(other.frames) == len(bench.inverter.frames) == 2
    answers = [sent for sent in bench.on_line if sent.sender is not bench.gateway.port]
    assert not any(answer.collided for answer in answers)
    bench.send(0, 3, "0B47FE030000")
    bench.run_ms(8)
    other.reply_ns = 13 * NS_PER_MS
    bench.send(0, 4, "0C47FE030000")
    bench.run_ms(60)
    answers = [sent for sent in bench.on_line if sent.sender is not bench.gateway.port]
    assert [answer.collided for answer in answers] == [False, False, True, True]
    assert bench.status & 0xFF == 1


@pytest.mark.fact("C2-11")
def test_with_the_trigger_poll_the_trigger_is_seen_on_a_10_ms_grid(bench_of):
    bench = bench_of(trigger_poll_ns=10 * NS_PER_MS)
    bench.run_ms(1)
    bench.send(0, 1, START)
    bench.run_ms(60)
    assert bench.on_line[0].start_ns == (30 + 5) * NS_PER_MS


@pytest.mark.fact("C2-11")
def test_with_the_trigger_poll_a_change_to_and_fro_between_two_looks_is_missed(bench_of):
    bench = bench_of(trigger_poll_ns=10 * NS_PER_MS)
    bench.run_ms(1)
    bench.send(0, 1, START)
    bench.run_ms(4)
    bench.send(0, 0, START)
    bench.run_ms(60)
    assert bench.inverter.frames == []


@pytest.mark.fact("C2-11")
def test_without_the_trigger_poll_the_trigger_is_seen_at_once(bench):
    bench.run_ms(1)
    bench.send(0, 1, START)
    bench.run_ms(60)
    assert bench.on_line[0].start_ns == (22 + 5) * NS_PER_MS


@pytest.mark.fact("C2-1")
def test_replies_are_unsolicited_for_the_gateway(bench):
    bench.noise(seal(bytes.fromhex("0247FC900000")))
    assert bench.reply == bytes.fromhex("0247FC900000")


@pytest.mark.fact("C2-1")
def test_the_gateway_does_not_wait_for_a_reply_before_it_sends_again(bench):
    bench.send(0, 1, START)
    bench.run_ms(12)
    bench.send(0, 2, FREQUENCY)
    bench.run_ms(8)
    assert len(bench.inverter.frames) == 1
    bench.run_ms(8)
    assert len(bench.inverter.frames) == 2
    assert bench.reply == bytes(6)


@pytest.mark.fact("C2-2")
@pytest.mark.fact("tos.cw.optional")
@pytest.mark.parametrize("control", [0x0000, 0x2000, 0xFFFF])
def test_telegrams_go_out_whatever_the_control_word_holds(bench, control):
    bench.send(control, 1, START)
    bench.run_ms(60)
    assert bench.inverter.frames == [seal(bytes.fromhex(START))]


@pytest.mark.fact("C2-10")
def test_two_equal_replies_look_like_one_to_the_plc(bench):
    transfers: list[bytes] = []
    bench.send(0, 1, START)
    bench.run_ms(60)
    bench.master.taps.append(lambda transfer: transfers.append(transfer.inputs))
    bench.send(0, 2, START)
    bench.run_ms(60)
    assert len(bench.inverter.frames) == 2
    assert set(transfers) == {bytes(bench.station.inputs)}


@pytest.mark.fact("C2-10")
def test_inputs_change_only_by_a_valid_frame(bench):
    bench.valid_reply()
    reply = bench.reply
    for wrong in ("2F0B47FE03123400", "2F0B4E000189", "2F0B47FE031234", "286162290D"):
        bench.noise(bytes.fromhex(wrong))
        assert bench.reply == reply
