"""Cyclic interrupts and error blocks: when they run, and what they interrupt."""

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import ObSettings, Period
from harness.engine.loading import engine_named
from harness.kernel import NS_PER_MS, NS_PER_US
from harness.plc import CpuFamily, CpuMode, Restart


def ob(*names: str) -> str:
    return "".join(
        f'ORGANIZATION_BLOCK "{name}"\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n' for name in names
    )


def every_ms(**periods: float) -> ObSettings:
    return ObSettings(periods={n: Period(round(p * NS_PER_MS)) for n, p in periods.items()})


def test_a_cyclic_interrupt_keeps_its_own_grid(make_rig):
    rig = make_rig(text=ob("Main", "OB35"), obs=every_ms(OB35=4)).start()
    rig.run_ms(5)
    times = [time for time, name in rig.engine.runs if name == "OB35"]
    assert times == [14.0, 18.0, 22.0]


def test_it_begins_between_two_accesses_of_a_scan(make_rig):
    rig = make_rig(
        text=ob("Main", "OB35"), process_image=False, peripheral_ns=300 * NS_PER_US,
        obs=every_ms(OB35=10.5),
    )  # fmt: skip
    seen: list[str] = []

    def main() -> None:
        seen.append("main begins")
        for _ in range(3):
            rig.cpu.read_peripheral(256, 1)
            seen.append(f"access, scan of {rig.cpu.now_ns / NS_PER_MS:g}")

    rig.body(main)
    rig.body(lambda: seen.append(f"interrupt at {rig.cpu.now_ns / NS_PER_MS:g}"), "OB35")
    rig.start()
    rig.run_ms(0.7)
    del seen[: seen.index("main begins", 1)]
    assert seen == [
        *("main begins", "access, scan of 20", "interrupt at 20.5"),
        *("access, scan of 20", "access, scan of 20"),
    ]


def test_the_time_of_its_accesses_makes_the_scan_longer(make_rig):
    rig = make_rig(
        text=ob("Main", "OB35"), process_image=False, peripheral_ns=2 * NS_PER_MS,
        obs=every_ms(OB35=15),
    )  # fmt: skip
    rig.body(lambda: [rig.cpu.read_peripheral(256, 1) for _ in range(3)])
    rig.body(lambda: [rig.cpu.read_peripheral(256, 1) for _ in range(3)], "OB35")
    rig.start()
    rig.run_ms(20)
    mains = [time for time, name in rig.engine.runs if name == "Main"]
    assert mains[:3] == [10.0, 20.0, 32.0]


def test_a_lower_class_waits_for_a_higher_one_and_a_higher_one_does_not(make_rig):
    rig = make_rig(
        text=ob("Main", "OB35", "OB36", "OB34"), process_image=False,
        peripheral_ns=NS_PER_MS, obs=every_ms(OB35=3, OB36=4, OB34=4),
    )  # fmt: skip
    order: list[str] = []

    def slow() -> None:
        order.append("35 begins")
        rig.cpu.read_peripheral(256, 1)
        rig.cpu.read_peripheral(256, 1)
        order.append("35 ends")

    rig.body(slow, "OB35")
    rig.body(lambda: order.append("36"), "OB36")
    rig.body(lambda: order.append("34"), "OB34")
    rig.slave.power_on(5)
    rig.cpu.start()
    rig.run_ms(15.5)
    assert order == ["35 begins", "36", "35 ends", "34"]


def test_nothing_interrupts_in_stop(make_rig):
    rig = make_rig(text=ob("Main", "OB38")).start()
    rig.cpu.stop()
    count = len(rig.engine.runs)
    rig.run_ms(100)
    assert len(rig.engine.runs) == count


def test_a_fault_in_an_interrupt_ends_the_scan_that_it_interrupts(make_rig):
    rig = make_rig(
        text=ob("Main", "OB35"), process_image=False, peripheral_ns=NS_PER_MS, obs=every_ms(OB35=11)
    )

    def fail() -> None:
        raise DiagnosticError([])

    rig.body(lambda: [rig.cpu.read_peripheral(256, 1) for _ in range(3)])
    rig.body(fail, "OB35")
    rig.start()
    rig.run_ms(30)
    assert rig.cpu.mode is CpuMode.STOP
    assert [name for _, name in rig.engine.runs] == ["Main", "Main", "OB35"]


@pytest.mark.parametrize(("restart", "block"), [(Restart.WARM, "OB100"), (Restart.COLD, "OB102")])
def test_each_restart_has_its_start_up_block(make_rig, restart, block):
    rig = make_rig(text=ob("Main", "OB100", "OB102"))
    rig.slave.power_on(5)
    rig.cpu.start(restart)
    rig.run_ms(12)
    assert [name for _, name in rig.engine.runs] == [block, "Main"]


def test_ob80_keeps_a_cpu_in_run_whose_scan_takes_too_long(make_rig):
    rig = make_rig(text=ob("Main", "OB80"), execution_ns=200 * NS_PER_MS).start()
    rig.run_ms(5)
    assert rig.cpu.mode is CpuMode.RUN
    assert [name for _, name in rig.engine.runs] == ["Main", "OB80"]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (ObSettings(numbers={"Fast": 35}), "there are settings for 'Fast'"),
        (ObSettings(periods={"OB38": Period(NS_PER_MS)}), "there are settings for 'ob38'"),
    ],
)
def test_settings_of_blocks_that_do_not_exist_are_refused(make_rig, settings, message):
    with pytest.raises(DiagnosticError) as caught:
        make_rig(text=ob("Main", "OB35"), obs=settings)
    (found,) = caught.value.diagnostics
    assert (found.code, found.message.startswith(message)) == ("FB7410", True)


def test_two_blocks_with_one_number_are_refused(make_rig):
    with pytest.raises(DiagnosticError) as caught:
        make_rig(text=ob("Main", "OB35", "Fast"), obs=ObSettings(numbers={"Fast": 35}))
    (found,) = caught.value.diagnostics
    assert (found.code, found.span.line, found.span.column) == ("FB7411", 9, 1)


def test_a_scan_does_not_begin_while_an_interrupt_runs(make_rig):
    rig = make_rig(
        text=ob("Main", "OB35"), process_image=False, peripheral_ns=2 * NS_PER_MS,
        obs=every_ms(OB35=29),
    )  # fmt: skip
    rig.body(lambda: rig.cpu.read_peripheral(256, 1), "OB35")
    rig.start()
    rig.run_ms(40)
    times = [time for time, name in rig.engine.runs if name == "Main"]
    assert times == [10.0, 20.0, 30.0, 41.0, 51.0]


@pytest.mark.parametrize(
    ("family", "blocks", "mode"),
    [
        (CpuFamily.S7_300, (), CpuMode.STOP),
        (CpuFamily.S7_300, ("OB80",), CpuMode.RUN),
        (CpuFamily.S7_1500, (), CpuMode.RUN),
    ],
)
def test_an_interrupt_that_is_due_again_before_it_has_run_is_a_time_error(
    make_rig, family, blocks, mode
):
    rig = make_rig(
        text=ob("Main", "OB35", *blocks), process_image=False, family=family,
        peripheral_ns=2 * NS_PER_MS, obs=every_ms(OB35=5),
    )  # fmt: skip
    rig.body(lambda: [rig.cpu.read_peripheral(256, 1) for _ in range(3)], "OB35")
    rig.start()
    rig.run_ms(5)
    assert rig.cpu.mode is mode
    assert {name for _, name in rig.engine.runs} == {"Main", "OB35", *blocks}


def test_interrupts_that_leave_no_time_for_a_scan_stop_the_cpu(make_rig):
    rig = make_rig(
        text=ob("Main", "OB35", "OB36"), process_image=False,
        peripheral_ns=2 * NS_PER_MS, watchdog_ns=30 * NS_PER_MS, obs=every_ms(OB35=5, OB36=6),
    )  # fmt: skip
    for block in ("Main", "OB35", "OB36"):
        rig.body(lambda: [rig.cpu.read_peripheral(256, 1) for _ in range(3)], block)
    rig.start()
    rig.run_ms(1_000)
    assert rig.cpu.mode is CpuMode.STOP
    assert rig.cpu.diagnostics[0].code == "FB7409"


INTERRUPTED = """
DATA_BLOCK "D"
VAR
    before : Int;
    after : Int;
    runs : Int;
    passes : Int;
END_VAR
BEGIN
END_DATA_BLOCK
FUNCTION "Twice" : Int
VAR_INPUT
    x : Int;
END_VAR
VAR_TEMP
    seen : Byte;
    kept : Int;
END_VAR
BEGIN
    #kept := #x;
    #seen := %IB256:P;
    #Twice := #kept * 2;
END_FUNCTION
ORGANIZATION_BLOCK "Main"
VAR_TEMP
    i : Int;
END_VAR
BEGIN
    "D".passes := 0;
    FOR #i := 1 TO 3 DO
        "D".passes := "D".passes + "Twice"(#i);
    END_FOR;
    "D".after := "D".runs;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK "OB35"
BEGIN
    "D".runs := "D".runs + "Twice"(5) / 10;
    "D".before := "D".passes;
END_ORGANIZATION_BLOCK
"""


@pytest.mark.parametrize("engine_name", ["compiled", "reference"])
def test_on_both_engines_an_interrupted_block_goes_on_where_it_was(make_rig, engine_name):
    rig = make_rig(
        text=INTERRUPTED, process_image=False, peripheral_ns=NS_PER_MS, obs=every_ms(OB35=11.5)
    )
    rig.cpu.load(rig.program, engine_named(engine_name))
    rig.slave.power_on(5)
    rig.cpu.start()
    rig.run_ms(26)
    value = rig.cpu.engine.global_value
    assert [value(f'"D".{name}') for name in ("before", "passes", "runs", "after")] == [2, 12, 1, 1]
