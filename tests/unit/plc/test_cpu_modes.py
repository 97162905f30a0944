"""RUN, STOP, restarts, and what takes a CPU to STOP."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError, error
from harness.fieldbus import MasterMode
from harness.kernel import NS_PER_MS, Kernel
from harness.plc import Cpu, CpuFamily, CpuMode, CpuSettings, Restart

OB1 = 'ORGANIZATION_BLOCK "Main"\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n'
OB100 = 'ORGANIZATION_BLOCK "Startup"\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n'
TASKS = """
PROGRAM Fast
  VAR n : INT; END_VAR
  n := n + 1;
END_PROGRAM
PROGRAM Slow
  VAR n : INT; END_VAR
  n := n + 1;
END_PROGRAM
CONFIGURATION Plant
  RESOURCE Cpu ON PLC
    TASK Quick (INTERVAL := T#5ms, PRIORITY := 1);
    TASK Lazy (INTERVAL := T#20ms, PRIORITY := 2);
    PROGRAM F WITH Quick : Fast;
    PROGRAM S WITH Lazy : Slow;
  END_RESOURCE
END_CONFIGURATION
"""


def _raise_endless_loop() -> None:
    raise error("FB6004", "the cycle watchdog stopped 'WHILE TRUE DO'")


def test_the_cpu_runs_once_all_stations_exchange_data(rig):
    modes: list[tuple[float, CpuMode]] = []
    rig.cpu.on_mode.append(lambda mode: modes.append((rig.kernel.now_ns / NS_PER_MS, mode)))
    rig.start()
    assert modes == [(0.0, CpuMode.STARTUP), (10.0, CpuMode.RUN)]


def test_a_cpu_that_was_without_supply_waits_for_the_stations_again(rig):
    rig.start()
    rig.slave.set_inputs(b"\xff" * len(rig.slave.inputs))
    rig.run_ms(20)
    rig.cpu.power_off()
    rig.run_ms(100)
    modes: list[tuple[float, CpuMode]] = []
    rig.cpu.on_mode.append(lambda mode: modes.append((rig.kernel.now_ns / NS_PER_MS, mode)))
    begin_ms = rig.kernel.now_ns / NS_PER_MS
    rig.cpu.start()
    assert not any(rig.station.inputs), "what was there before the master was off"
    rig.run_ms(50)
    assert modes == [(begin_ms, CpuMode.STARTUP), (begin_ms + 10, CpuMode.RUN)]


def test_the_cpu_does_not_wait_for_a_station_that_fails(rig):
    rig.cpu.start()
    rig.run_ms(10)
    assert rig.cpu.mode is CpuMode.RUN


@pytest.mark.fact("dp.clear")
def test_stop_is_clear_for_the_master_and_zeros_for_the_slave(rig):
    rig.start()
    rig.body(lambda: rig.cpu.outputs.__setitem__(256, 7))
    rig.run_ms(15)
    rig.cpu.stop()
    rig.run_ms(1_000)
    assert rig.master.mode is MasterMode.CLEAR
    assert [data[:2] for _, data in rig.received] == ["07", "00"]
    assert rig.slave.online


def test_nothing_runs_in_stop(rig):
    rig.start()
    rig.cpu.stop()
    count = len(rig.engine.runs)
    rig.run_ms(100)
    assert len(rig.engine.runs) == count


def test_outputs_of_a_scan_that_was_cut_short_are_not_written(rig):
    rig.start()
    rig.body(lambda: rig.cpu.outputs.__setitem__(256, 7))
    rig.run_ms(10.5)
    rig.cpu.stop()
    rig.run_ms(50)
    assert rig.received == []


def test_after_a_restart_the_process_image_is_empty(rig):
    rig.start()
    rig.body(lambda: rig.cpu.outputs.__setitem__(256, 7))
    rig.run_ms(15)
    rig.cpu.inputs[0] = 0xFF
    rig.cpu.stop()
    rig.body(lambda: None)
    rig.cpu.start()
    rig.run_ms(50)
    assert not any(rig.cpu.inputs)
    assert not any(rig.cpu.outputs)
    assert rig.received[-1][1] == "00" * 10


def test_after_a_restart_the_slave_gets_zeros_until_the_program_writes_again(make_rig):
    rig = make_rig(process_image=False).start()
    rig.body(lambda: rig.cpu.write_peripheral(256, 1, 7))
    rig.run_ms(15)
    rig.cpu.stop()
    rig.run_ms(20)
    assert [data[:2] for _, data in rig.received] == ["07", "00"]
    rig.body(lambda: None)
    rig.cpu.start()
    rig.run_ms(100)
    assert rig.cpu.mode is CpuMode.RUN
    assert [data[:2] for _, data in rig.received] == ["07", "00"]


@pytest.mark.parametrize(("restart", "warm"), [(Restart.WARM, True), (Restart.COLD, False)])
def test_a_restart_gives_the_program_its_initial_values(rig, restart, warm):
    rig.cpu.start(restart)
    assert rig.engine.resets == [warm]


@pytest.mark.parametrize(("restart", "kept"), [(Restart.WARM, [1, 1, 0]), (Restart.COLD, [0] * 3)])
def test_remanent_markers_survive_a_warm_restart(make_rig, restart, kept):
    rig = make_rig(remanent_marker_bytes=2)
    rig.cpu.markers[:3] = b"\1\1\1"
    rig.cpu.start(restart)
    assert list(rig.cpu.markers[:3]) == kept


def test_ob100_runs_once_before_ob1(make_rig):
    rig = make_rig(text=OB1 + OB100).start()
    assert [name for _, name in rig.engine.runs] == ["Startup", "Main", "Main"]


def test_a_fault_in_ob100_keeps_the_cpu_in_stop(make_rig):
    rig = make_rig(text=OB1 + OB100)
    rig.body(_raise_endless_loop, "Startup")
    rig.start()
    assert rig.cpu.mode is CpuMode.STOP
    assert [name for _, name in rig.engine.runs] == ["Startup"]


def test_a_program_that_fails_takes_the_cpu_to_stop_with_its_diagnostic(rig):
    rig.start()
    rig.body(_raise_endless_loop)
    rig.run_ms(100)
    assert rig.cpu.mode is CpuMode.STOP
    assert [found.code for found in rig.cpu.diagnostics] == ["FB6004"]
    assert rig.master.mode is MasterMode.CLEAR


def test_a_new_start_forgets_the_reason_of_the_last_stop(rig):
    rig.start()
    rig.body(_raise_endless_loop)
    rig.run_ms(20)
    rig.body(lambda: None)
    rig.cpu.start()
    rig.run_ms(20)
    assert (rig.cpu.mode, rig.cpu.diagnostics) == (CpuMode.RUN, [])


def test_without_supply_the_master_is_silent_and_the_watchdog_expires(rig):
    rig.start()
    rig.cpu.power_off()
    rig.run_ms(500)
    assert rig.master.mode is MasterMode.STOP
    assert rig.received == [(120.0, "offline")]


def test_the_harness_brings_an_ob1_that_calls_tos_main(make_rig):
    text = 'FUNCTION "TOS_Main" : Void\nBEGIN\n;\nEND_FUNCTION\n'
    rig = make_rig(text=text).start()
    assert {name for _, name in rig.engine.runs} == {"TOS_Main"}


def test_tasks_of_a_configuration_run_at_their_intervals_the_urgent_one_first(make_rig):
    rig = make_rig(text=TASKS, dialect="iec", family=CpuFamily.IEC).start()
    rig.run_ms(12)
    assert rig.engine.runs == [
        (10.0, "Fast"),
        (11.0, "Slow"),
        (15.0, "Fast"),
        (20.0, "Fast"),
        (25.0, "Fast"),
        (30.0, "Fast"),
        (31.0, "Slow"),
    ]


def test_a_task_that_could_not_run_in_time_keeps_its_grid(make_rig):
    rig = make_rig(
        text=TASKS, dialect="iec", family=CpuFamily.IEC, execution_ns=7 * NS_PER_MS
    ).start()
    rig.run_ms(30)
    assert [time for time, name in rig.engine.runs if name == "Fast"][:3] == [10.0, 17.0, 24.0]


def test_programs_without_a_configuration_run_every_cycle(make_rig):
    text = TASKS[: TASKS.index("CONFIGURATION")]
    rig = make_rig(text=text, dialect="iec", family=CpuFamily.IEC).start()
    assert [name for _, name in rig.engine.runs] == ["Fast", "Slow"] * 2


def test_files_in_which_nothing_runs_are_refused(make_rig):
    broken = Path(__file__).parents[1] / "bad" / "FB7404_nothing_runs.scl"
    with pytest.raises(DiagnosticError) as caught:
        make_rig(text=broken.read_text("ascii"))
    (found,) = caught.value.diagnostics
    assert found.code == "FB7404"
    assert (found.span.line, found.span.column) == (1, 1)


def test_a_cpu_without_a_program_cannot_start(rig):
    empty = Cpu(Kernel(), CpuSettings(), rig.master)
    with pytest.raises(DiagnosticError) as caught:
        empty.start()
    assert caught.value.diagnostics[0].code == "FB7405"
