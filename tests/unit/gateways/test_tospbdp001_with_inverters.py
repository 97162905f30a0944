"""The gateway with simulated VF-S11 on its line: what the manual says about both together."""

from collections.abc import Callable

import pytest

from fbgen.catalog import load_catalog
from harness.drives import Inverter, InverterSettings, ReplyTime
from harness.kernel import NS_PER_MS

RUN_50_HZ = ("FF50FA00C400", "FF50FA011388")


@pytest.fixture
def add_inverter() -> Callable[..., Inverter]:
    """A VF-S11 set as the manual says in section 6: add_inverter(bench, 3)."""

    def add(bench, inv_no: int, timeout_s: int = 1) -> Inverter:
        parameters = {
            "baud_rate": 4,
            "parity": 1,
            "inverter_number": inv_no,
            "communication_timeout": timeout_s,
        }
        settings = InverterSettings(
            f"drive{inv_no}", parameters, reply_time=ReplyTime(20 * NS_PER_MS, 20 * NS_PER_MS)
        )
        return Inverter(bench.kernel, bench.line, load_catalog().drive("vf-s11"), settings)

    return add


@pytest.mark.fact("tos.inv")
def test_a_telegram_reaches_the_drive_with_its_number_only(bench, add_inverter):
    first, second = add_inverter(bench, 1), add_inverter(bench, 2)
    bench.send(0, 1, "0250FA00C400")
    bench.run_ms(60)
    assert (first.running, second.running) == (False, True)
    assert bench.reply.hex() == "0250fa00c400"


@pytest.mark.fact("tos.inv")
@pytest.mark.parametrize(("numbers", "answer"), [((0, 1, 2), "ff50fa00c400"), ((1, 2), "00" * 6)])
def test_a_broadcast_moves_all_drives_and_number_0_alone_answers(
    bench, add_inverter, numbers, answer
):
    drives = [add_inverter(bench, number) for number in numbers]
    bench.send(0, 1, RUN_50_HZ[0])
    bench.run_ms(60)
    assert all(drive.running for drive in drives)
    assert bench.reply.hex() == answer
    assert bench.status == 0x9F00


@pytest.mark.fact("tos.cmd.52")
def test_command_52_is_answered_with_a_checksum_error_which_the_gateway_counts(bench, add_inverter):
    add_inverter(bench, 1)
    bench.send(0, 1, "0152FE030000")
    bench.run_ms(60)
    sent, answer = (item.data for item in bench.on_line)
    assert len(sent) == 8  # the drive expects six, and takes the first data byte for the sum
    assert answer[:5] == bytes.fromhex("2F 01 4E 00 04")
    assert bench.reply == bytes(6)
    assert bench.status & 0x1FFF == 0x0001


@pytest.mark.fact("tos.hb")
@pytest.mark.fact("tos.f803")
def test_the_heartbeat_alone_keeps_a_drive_with_f803_running(bench, add_inverter):
    drive = add_inverter(bench, 1)
    for trigger, telegram in enumerate(RUN_50_HZ, start=1):
        bench.send(0, trigger, telegram)
        bench.run_ms(60)
    bench.run_ms(30_000)
    assert (drive.running, drive.tripped) == (True, False)


@pytest.mark.fact("tos.f803")
@pytest.mark.fact("tos.hb.busfault")
@pytest.mark.parametrize(("timeout_s", "trip"), [(1, "Err5"), (0, "")])
def test_after_a_bus_fault_a_drive_with_f803_trips_err5(bench, add_inverter, timeout_s, trip):
    drive = add_inverter(bench, 1, timeout_s)
    for trigger, telegram in enumerate(RUN_50_HZ, start=1):
        bench.send(0, trigger, telegram)
        bench.run_ms(60)
    bench.master.connected = False
    bench.run_ms(5_000)
    assert drive.tripped is bool(trip)
    assert (drive.trip_display or "") == trip


@pytest.mark.fact("tos.hb.claim")
def test_a_drive_trips_later_than_one_second_after_the_bus_fault(bench, add_inverter):
    drive = add_inverter(bench, 1)
    for trigger, telegram in enumerate(RUN_50_HZ, start=1):
        bench.send(0, trigger, telegram)
        bench.run_ms(60)
    bench.kernel.run_until(970 * NS_PER_MS)  # heartbeats begin at 510 ms, 1010 ms and so on
    bench.master.connected = False
    bench.run_ms(1_040)
    assert drive.running  # the gateway noticed only after the DP watchdog time of 100 ms
    bench.run_ms(20)
    assert drive.trip_display == "Err5"


@pytest.mark.fact("tos.hb")
def test_the_answer_of_drive_0_to_the_heartbeat_never_reaches_the_plc(bench, add_inverter):
    add_inverter(bench, 0)
    bench.run_ms(5_000)
    answers = [item for item in bench.on_line if item.sender is not bench.gateway.port]
    assert len(answers) == 9
    assert (bench.status, bench.reply) == (0x9F00, bytes(6))


@pytest.mark.fact("C2-12")
def test_in_clear_the_drives_keep_running(bench, add_inverter):
    drive = add_inverter(bench, 1)
    for trigger, telegram in enumerate(RUN_50_HZ, start=1):
        bench.send(0, trigger, telegram)
        bench.run_ms(60)
    bench.master.clear()
    bench.run_ms(30_000)
    assert bytes.fromhex("2F 00 00 00 00 00 00 2F") in [item.data for item in bench.on_line]
    assert (drive.running, drive.tripped) == (True, False)


@pytest.mark.fact("tos.t.reply")
@pytest.mark.fact("tos.t.total")
def test_a_drive_that_takes_20_ms_answers_within_40_ms(bench, add_inverter):
    add_inverter(bench, 1)
    bench.send(0, 1, "0147FC900000")
    bench.run_ms(2 + 39.5)
    assert bench.gateway.slave.inputs[2:] == bytes(6)
    bench.run_ms(0.5)
    assert bench.gateway.slave.inputs[2:] == bytes.fromhex("0147FC900000")
