"""When a scan reads, runs and writes."""

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.kernel import NS_PER_MS, NS_PER_US
from harness.plc import CpuMode, CpuSettings


def test_a_scan_begins_every_minimum_cycle_time(rig):
    rig.start()
    rig.run_ms(25)
    starts = [time for time, _ in rig.engine.runs]
    assert starts == [10.0, 20.0, 30.0, 40.0]


def test_a_program_longer_than_the_cycle_begins_again_at_once(make_rig):
    rig = make_rig(execution_ns=13 * NS_PER_MS).start()
    rig.run_ms(40)
    assert [time for time, _ in rig.engine.runs] == [10.0, 23.0, 36.0, 49.0]


def test_inputs_are_those_of_the_start_of_the_scan(rig):
    seen: list[int] = []
    rig.body(lambda: seen.append(rig.cpu.inputs[256]))
    rig.start()
    rig.run_ms(5)
    rig.slave.set_inputs(b"\x01" + bytes(7))
    rig.run_ms(5.5)
    rig.slave.set_inputs(b"\x02" + bytes(7))
    rig.run_ms(10)
    assert seen == [0, 0, 1, 2]


def test_outputs_are_written_when_the_execution_time_is_over(make_rig):
    rig = make_rig(execution_ns=3 * NS_PER_MS)
    rig.start()
    rig.body(lambda: rig.cpu.outputs.__setitem__(256, 7))
    rig.run_ms(12.9)
    assert rig.station.outputs[0] == 0
    rig.run_ms(0.2)
    assert rig.station.outputs[0] == 7
    rig.run_ms(2)
    assert rig.received == [(34.0, "07" + "00" * 9)]


def test_execution_jitter_comes_from_the_seed(make_rig):
    def arrivals(seed: int) -> list[float]:
        rig = make_rig(seed=seed, execution_jitter_ns=8 * NS_PER_MS)
        rig.body(lambda: rig.cpu.outputs.__setitem__(256, rig.cpu.outputs[256] + 1))
        rig.start()
        rig.run_ms(100)
        return [time for time, _ in rig.received]

    assert arrivals(1) == arrivals(1)
    assert arrivals(1) != arrivals(2)


def test_events_up_to_the_instant_of_an_access_happen_before_it(make_rig):
    rig = make_rig(process_image=False, peripheral_ns=800 * NS_PER_US)
    seen: list[int] = []
    rig.start()
    rig.kernel.at(31 * NS_PER_MS, lambda: rig.slave.set_inputs(b"\x09" + bytes(7)))
    rig.body(lambda: seen.extend(rig.cpu.read_peripheral(256, 1) for _ in range(4)))
    rig.run_ms(20)
    assert seen[:4] == [0, 0, 9, 9]  # the cycle at 32 ms falls between the second and the third


def test_a_scan_lasts_as_long_as_its_accesses(make_rig):
    rig = make_rig(process_image=False, peripheral_ns=4 * NS_PER_MS)
    rig.body(lambda: [rig.cpu.read_peripheral(256, 1) for _ in range(3)])
    rig.start()
    rig.run_ms(30)
    assert [time for time, _ in rig.engine.runs][:3] == [10.0, 22.0, 34.0]


def test_now_stands_still_during_a_scan(make_rig):
    rig = make_rig(process_image=False, peripheral_ns=NS_PER_MS)
    seen: set[int] = set()

    def body() -> None:
        rig.cpu.read_peripheral(256, 1)
        seen.add(rig.cpu.now_ns)

    rig.start()
    rig.body(body)
    rig.run_ms(11)
    assert seen == {30 * NS_PER_MS}


def test_a_scan_longer_than_the_cycle_watchdog_stops_the_cpu(make_rig):
    rig = make_rig(process_image=False, peripheral_ns=60 * NS_PER_MS)
    rig.start()
    rig.body(lambda: [rig.cpu.read_peripheral(256, 1) for _ in range(3)])
    rig.run_ms(300)
    assert rig.cpu.mode is CpuMode.STOP
    assert [found.code for found in rig.cpu.diagnostics] == ["FB7409"]


def test_scans_are_counted_and_observed(rig):
    seen: list[int] = []
    rig.cpu.after_scan.append(lambda: seen.append(rig.cpu.scans))
    rig.start()
    rig.run_ms(21)
    assert seen == [1, 2, 3, 4]


def test_the_same_seed_gives_the_same_run(make_rig):
    def run() -> list[tuple[float, str]]:
        rig = make_rig(seed=7, tear_probability=0.5, execution_jitter_ns=3 * NS_PER_MS)
        rig.body(lambda: rig.cpu.outputs.__setitem__(slice(256, 266), bytes([rig.cpu.scans]) * 10))
        rig.start()
        rig.run_ms(300)
        return rig.received

    assert run() == run()


@pytest.mark.parametrize(
    "wrong", [{"cycle_ns": 0}, {"execution_ns": -1}, {"execution_jitter_ns": -1}]
)
def test_impossible_times_are_refused(wrong):
    with pytest.raises(DiagnosticError) as caught:
        CpuSettings(**wrong)
    assert caught.value.diagnostics[0].code == "FB7401"
