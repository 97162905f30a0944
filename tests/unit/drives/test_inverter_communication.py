"""How the inverter listens and answers."""

import pytest
from drive_bench import GATEWAY_SETTINGS, SERIES, Bench

from fbgen.wire.toshiba import seal
from harness.drives import InverterSettings, ReplyTime
from harness.kernel import NS_PER_MS
from harness.line import Disturbance, Topology

READY = "FC 90 00 00"


@pytest.mark.fact("tos.t.reply")
def test_reply_begins_within_20_ms_and_differs_from_time_to_time() -> None:
    bench = Bench()
    parameters = GATEWAY_SETTINGS | {"inverter_number": 11}
    bench.add(settings=InverterSettings(parameters=parameters))
    delays = []
    for _ in range(50):
        asked_ns = bench.kernel.now_ns
        bench.ask(f"0B 47 {READY}")
        delays.append(bench.heard[0].start_ns - asked_ns - 4_583_333)
    assert 10 * NS_PER_MS <= min(delays) < 12 * NS_PER_MS
    assert 18 * NS_PER_MS < max(delays) <= 20 * NS_PER_MS


def test_reply_time_can_be_fixed_and_waits_for_f805() -> None:
    bench = Bench()
    parameters = GATEWAY_SETTINGS | {"inverter_number": 11, "send_waiting_time": 0.02}
    fixed = ReplyTime(3 * NS_PER_MS, 3 * NS_PER_MS)
    bench.add(settings=InverterSettings(parameters=parameters, reply_time=fixed))
    bench.ask(f"0B 47 {READY}")
    assert bench.heard[0].start_ns == 4_583_333 + 23 * NS_PER_MS


@pytest.mark.fact("tip.char")
def test_reply_takes_two_stop_bits() -> None:
    bench = Bench()
    bench.add()
    bench.ask(f"0B 47 {READY}")
    assert bench.heard[0].end_ns - bench.heard[0].start_ns == 5 * NS_PER_MS


@pytest.mark.fact("tos.inv")
def test_only_the_addressed_inverter_answers() -> None:
    bench = Bench()
    for number in (1, 2, 3):
        bench.add(number)
    assert bench.ask(f"02 47 {READY}") == f"02 47 {READY}"
    assert bench.ask(f"04 47 {READY}") == ""


@pytest.mark.fact("tos.inv")
@pytest.mark.fact("bc.all.bin")
def test_broadcast_is_carried_out_by_all_and_answered_by_number_0() -> None:
    bench = Bench()
    drives = [bench.add(number) for number in (0, 1, 2)]
    assert bench.ask("FF 50 00 09 00 32") == "FF 50 00 09 00 32"
    assert [drive.read_word("0009") for drive in drives] == [50, 50, 50]


@pytest.mark.fact("bc.noreply")
@pytest.mark.fact("bc.err")
def test_broadcast_without_a_number_0_is_not_answered_refusals_included() -> None:
    bench = Bench()
    drives = [bench.add(number) for number in (1, 2)]
    assert bench.ask("FF 57 00 09 00 32") == ""
    assert [drive.read_word("0009") for drive in drives] == [50, 50]
    assert bench.ask("FF 50 12 34 00 00") == ""
    bench.add(0)
    assert bench.ask("FF 50 12 34 00 00") == "FF 4E 00 02"


@pytest.mark.fact("bc.rule")
def test_broadcast_read_is_dropped_unless_the_option_allows_it() -> None:
    bench = Bench()
    parameters = GATEWAY_SETTINGS | {"inverter_number": 0}
    bench.add(settings=InverterSettings(parameters=parameters))
    assert bench.ask(f"FF 47 {READY}") == ""
    bench = Bench()
    bench.add(
        settings=InverterSettings(parameters=parameters, options=frozenset({"broadcast_reads"}))
    )
    assert bench.ask(f"FF 47 {READY}") == f"FF 47 {READY}"


@pytest.mark.fact("bc.group")
def test_ascii_broadcast_and_groups_reach_those_who_are_meant() -> None:
    bench = Bench()
    drives = {number: bench.add(number) for number in (2, 10, 12, 13)}
    assert bench.send(b"(*2P00090032)\r") == [b"(02P00090032)\r"]
    assert bench.send(b"(1*P00100032)\r") == [b"(10P00100032)\r"]
    assert bench.send(b"(**P88000001)\r") == []
    assert [drive.read_word("0009") for drive in drives.values()] == [50, 100, 50, 100]
    assert [drive.read_word("0010") for drive in drives.values()] == [100, 50, 50, 50]


@pytest.mark.fact("tos.hb")
@pytest.mark.fact("bc.all.ascii")
def test_ascii_heartbeat_to_the_free_notes_is_answered_by_number_0_only() -> None:
    bench = Bench()
    drives = [bench.add(number) for number in (0, 5)]
    assert bench.send(b"(**P08800001)\r") == [b"(**P08800001)\r"]
    assert [drive.read_word("free_notes") for drive in drives] == [1, 1]


@pytest.mark.fact("tip.bin.inv")
def test_inv_no_may_be_left_out_with_one_inverter() -> None:
    bench = Bench()
    bench.add(11)
    assert bench.ask("47 FC 90 00 00") == "47 FC 90 00 00"
    assert bench.send(b"(RFC90)\r") == [b"(RFC900000)\r"]


def test_without_inv_no_all_answer_and_collide() -> None:
    bench = Bench()
    bench.add(1)
    bench.add(2)
    bench.send(seal(bytes.fromhex("47 FC 90 00 00")))
    assert len(bench.heard) == 2
    assert all(reception.marks is not None for reception in bench.heard)


@pytest.mark.fact("tos.cmd.52")
def test_r_reads_with_a_frame_two_bytes_shorter() -> None:
    bench = Bench()
    bench.add()
    assert bench.send(bytes.fromhex("2F 0B 52 FC 90 18")) == [
        bytes.fromhex("2F 0B 52 FC 90 00 00 18")
    ]


@pytest.mark.parametrize(
    ("frame", "reply"),
    [
        (b"(11RFC90)\r", b"(11RFC900000)\r"),
        (b"(11P00090032&55)\r", b"(11N0004&C2)\r"),
        (b"(11XFC90)\r", b"(11N0003)\r"),
        (b"(11P1234)\r", b"(11N0001)\r"),
        (b"(11R1234)\r", b"(11N0002)\r"),
    ],
)
@pytest.mark.fact("tip.err.0001")
@pytest.mark.fact("tip.err.0002")
@pytest.mark.fact("tip.err.0003")
@pytest.mark.fact("tip.err.0004")
def test_ascii_requests_are_answered_in_ascii(frame: bytes, reply: bytes) -> None:
    bench = Bench()
    bench.add()
    assert bench.send(frame) == [reply]


def test_ascii_reply_has_a_checksum_if_the_request_had_one() -> None:
    bench = Bench()
    bench.add()
    # 28+31+31+52+46+43+39+30+26 = 1F4H, and four digits 30H more: 2B4H
    assert bench.send(b"(11RFC90&F4)\r") == [b"(11RFC900000&B4)\r"]


def test_wrong_checksum_is_refused_by_the_addressed_inverter() -> None:
    bench = Bench()
    bench.add(11)
    bench.add(12)
    assert bench.send(bytes.fromhex("2F 0B 47 FC 90 00 00 0E")) == [
        bytes.fromhex("2F 0B 4E 00 04 8C")
    ]


@pytest.mark.fact("tip.mute")
def test_damaged_character_means_silence_and_the_next_telegram_is_heard() -> None:
    bench = Bench()
    bench.add()
    bench.line.master_pair.interference.disturb_next(Disturbance(mark={4: 1}))
    assert bench.ask(f"0B 47 {READY}") == ""
    assert bench.ask(f"0B 47 {READY}") == f"0B 47 {READY}"


def test_frame_of_cleared_outputs_is_met_with_silence_by_every_inverter() -> None:
    bench = Bench()
    bench.add(0)
    bench.add(11)
    assert bench.ask("00 00 00 00 00 00") == ""
    assert bench.ask(f"0B 47 {READY}") == f"0B 47 {READY}"


@pytest.mark.fact("tos.cmd.53")
@pytest.mark.parametrize("command", ["53", "73"])
def test_s_sets_the_scaled_set_point_without_an_answer(command: str) -> None:
    bench = Bench()
    drive = bench.add(
        parameters={
            "point_1_percent": 0,
            "point_1_frequency": 10.0,
            "point_2_percent": 100,
            "point_2_frequency": 60.0,
            "inter_drive_mode": 1,
        }
    )
    assert bench.ask(f"0B {command} FA 01 13 88") == ""
    assert drive.read_parameter("FA01") == 35.0
    assert bench.ask(f"0B {command} FA 01 27 10") == ""
    assert drive.read_parameter("FA01") == 60.0


@pytest.mark.parametrize(("word", "hz"), [("FF FF", 80.0), ("00 00", 0.0)])
def test_s_is_cut_off_at_the_maximum_frequency_and_at_0(word: str, hz: float) -> None:
    bench = Bench()
    drive = bench.add(parameters={"point_1_percent": 50, "point_2_frequency": 50.0})
    bench.ask(f"0B 53 FA 01 {word}")
    assert drive.read_parameter("FA01") == hz


def test_s_with_two_equal_points_gives_the_second_frequency() -> None:
    bench = Bench()
    drive = bench.add(parameters={"point_1_percent": 100, "point_2_frequency": 42.0})
    bench.ask("0B 53 FA 01 10 00")
    assert drive.read_parameter("FA01") == 42.0


def test_s_to_another_cell_writes_it_unscaled_and_drops_what_is_wrong() -> None:
    bench = Bench()
    drive = bench.add()
    assert bench.ask("0B 53 00 09 00 32") == ""
    assert bench.ask("0B 53 12 34 00 32") == ""
    assert drive.read_word("0009") == 50


def test_telegram_that_comes_while_a_reply_is_owed_is_not_heard() -> None:
    bench = Bench()
    drive = bench.add()
    bench.port.transmit(seal(bytes.fromhex("0B 50 00 09 00 32")))
    bench.port.transmit(seal(bytes.fromhex("0B 50 00 09 00 33")))
    bench.kernel.run_for(100 * NS_PER_MS)
    assert len(bench.heard) == 1
    assert drive.read_word("0009") == 0x32


@pytest.mark.fact("tos.t.gap")
def test_requests_to_two_inverters_too_close_let_their_replies_collide() -> None:
    bench = Bench()
    bench.add(1)
    bench.add(2)
    bench.port.transmit(seal(bytes.fromhex(f"01 47 {READY}")))
    bench.port.transmit(seal(bytes.fromhex(f"02 47 {READY}")))
    bench.kernel.run_for(100 * NS_PER_MS)
    assert [reception.marks is None for reception in bench.heard] == [False, False]


def test_on_two_wires_an_inverter_ignores_the_replies_of_the_others() -> None:
    bench = Bench(topology=Topology.TWO_WIRE)
    bench.add(1)
    bench.add(2)
    assert bench.ask(f"01 47 {READY}") == f"01 47 {READY}"
    assert bench.ask(f"02 47 {READY}") == f"02 47 {READY}"


def test_inverter_is_silent_for_a_second_after_power_on() -> None:
    bench = Bench()
    drive = bench.add()
    drive.power_off()
    assert bench.ask(f"0B 47 {READY}") == ""
    drive.power_on()
    bench.wait(0.9)
    assert bench.ask(f"0B 47 {READY}") == ""
    bench.wait(0.1)
    assert bench.ask(f"0B 47 {READY}") == f"0B 47 {READY}"


def test_power_off_breaks_a_reply_off() -> None:
    bench = Bench()
    drive = bench.add()
    bench.port.transmit(seal(bytes.fromhex(f"0B 47 {READY}")))
    bench.kernel.run_for(17 * NS_PER_MS)
    drive.power_off()
    bench.wait(1)
    assert [len(reception.data) for reception in bench.heard] == [3]
    bench.heard.clear()
    drive.power_on()
    bench.wait(2)
    bench.port.transmit(seal(bytes.fromhex(f"0B 47 {READY}")))
    bench.kernel.run_for(10 * NS_PER_MS)
    drive.power_off()
    bench.wait(1)
    assert bench.heard == []


def test_power_on_of_an_inverter_that_is_on_does_nothing() -> None:
    bench = Bench()
    drive = bench.add()
    drive.power_on()
    assert bench.ask(f"0B 47 {READY}") == f"0B 47 {READY}"


def test_an_inverter_told_to_speak_another_protocol_hears_no_telegram_after_the_restart() -> None:
    bench = Bench()
    drive = bench.add()
    assert bench.ask("0B 57 08 29 00 01") == "0B 57 08 29 00 01"
    assert bench.ask("0B 47 FC 90 00 00") == "0B 47 FC 90 00 00", "only a restart changes it"
    drive.power_off()
    drive.power_on()
    bench.wait(2)
    assert bench.ask("0B 47 FC 90 00 00") == ""


def _knowing(**what: tuple[str, ...]) -> Bench:
    """An inverter 11 of a series whose service has less than that of the VF-S11."""
    known = SERIES.communication
    assert known is not None
    assert known.toshiba is not None
    service = known.toshiba.model_copy(update=what)
    changed = known.model_copy(update={"toshiba": service})
    bench = Bench(series=SERIES.model_copy(update={"communication": changed}))
    bench.add(11)
    return bench


@pytest.mark.fact("tip.err.0003")
def test_a_command_that_a_series_lacks_is_refused_in_ascii_and_met_with_silence_in_binary() -> None:
    bench = _knowing(commands=("read", "write_ram"))
    assert bench.send(b"(11WFA010000)\r") == [b"(11N0003)\r"]
    assert bench.ask("0B 57 FA 01 00 00") == ""
    assert bench.ask("0B 50 FA 01 00 00") == "0B 50 FA 01 00 00"


def test_a_form_that_a_series_lacks_is_not_understood() -> None:
    bench = _knowing(forms=("ascii",))
    assert bench.ask("0B 50 FA 01 00 00") == ""
    assert bench.send(b"(11RFA01)\r") == [b"(11RFA010000)\r"]
