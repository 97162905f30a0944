"""OB82, OB85, OB86, OB121 and OB122: when they run, with which start information, and STOP.

The expected bytes follow the tables of local data in the TIA Portal help, "Organization blocks
(S7-300, S7-400)"; which family calls OB85 is in "Programming with STEP 7", 27.2.
"""

import pytest

from fbgen.lang.types import DATE_AND_TIME
from harness.engine.layout import S7
from harness.engine.loading import engine_named
from harness.engine.services import CALENDAR_START_NS
from harness.kernel import NS_PER_MS
from harness.plc import CpuFamily, CpuMode, ImageErrors


def ob(*names: str) -> str:
    return "".join(
        f'ORGANIZATION_BLOCK "{name}"\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n' for name in names
    )


ALL = ob("OB1", "OB82", "OB85", "OB86", "OB122")


def count(rig, name: str) -> int:
    return [block for _, block in rig.engine.runs].count(name)


def events(rig, name: str) -> list[str]:
    """The start information of each run without the time, as hexadecimal text."""
    return [start[:12].hex(" ").upper() for start in rig.engine.starts.get(name, [])]


# --- OB86 ---------------------------------------------------------------------------------------


def test_a_classic_cpu_without_ob86_stops_when_a_slave_fails(make_rig, classic):
    rig = make_rig(text=ob("OB1", "OB82", "OB85", "OB122"), family=classic).start()
    rig.slave.power_off()
    rig.run_ms(20)
    assert rig.cpu.mode is CpuMode.STOP
    assert rig.cpu.diagnostics[0].code == "FB7408"
    assert "OB86" in rig.cpu.diagnostics[0].message


def test_a_classic_cpu_without_ob86_stops_when_a_slave_comes_that_was_not_there(make_rig, classic):
    rig = make_rig(text=ob("OB1"), family=classic, process_image=False)
    rig.cpu.start()
    rig.run_ms(30)
    assert rig.cpu.mode is CpuMode.RUN
    rig.slave.power_on(5)
    rig.run_ms(100)
    assert rig.cpu.mode is CpuMode.STOP
    assert "'gw' is back" in rig.cpu.diagnostics[0].message


def test_ob86_is_told_which_station_has_failed_and_that_it_is_back(make_rig, classic):
    rig = make_rig(text=ALL, family=classic).start()
    rig.slave.power_off()
    rig.run_ms(20)
    rig.slave.power_on(5)
    rig.run_ms(100)
    assert rig.cpu.mode is CpuMode.RUN
    assert events(rig, "OB86") == [
        "39 C4 1A 56 00 00 00 00 00 00 01 05",
        "38 C4 1A 56 00 00 00 00 00 00 01 05",
    ]


def test_the_start_information_ends_with_date_and_time(make_rig, classic):
    rig = make_rig(text=ALL, family=classic).start()
    rig.slave.power_off()
    rig.run_ms(4)
    (start,) = rig.engine.starts["OB86"]
    passed_ms = (S7.decode(DATE_AND_TIME, start[12:]) - CALENDAR_START_NS) // NS_PER_MS
    assert 20 <= passed_ms <= 24


@pytest.mark.parametrize("family", [CpuFamily.S7_1200, CpuFamily.S7_1500])
def test_a_cpu_of_today_goes_on_without_any_of_them(make_rig, family):
    rig = make_rig(family=family).start()
    rig.body(lambda: rig.cpu.read_peripheral(256, 1))
    rig.slave.set_ext_diag(True)
    rig.run_ms(20)
    rig.slave.power_off()
    rig.run_ms(100)
    assert rig.cpu.mode is CpuMode.RUN
    assert rig.cpu.access_errors > 0


def test_a_cpu_of_today_runs_ob86_where_it_has_one(make_rig):
    rig = make_rig(text=ob("Main", "Rack or station failure")).start()
    rig.slave.power_off()
    rig.run_ms(20)
    rig.slave.power_on(5)
    rig.run_ms(100)
    assert count(rig, "Rack or station failure") == 2


@pytest.mark.parametrize("name", ["OB86", "RACK_FLT"])
def test_the_name_from_the_standard_library_is_known(make_rig, name):
    rig = make_rig(text=ob("OB1", name), family=CpuFamily.S7_300).start()
    rig.slave.power_off()
    rig.run_ms(20)
    assert count(rig, name) == 1


# --- OB82 ---------------------------------------------------------------------------------------


def test_ob82_runs_when_a_diagnosis_comes_and_when_it_goes(make_rig, classic):
    rig = make_rig(text=ALL, family=classic).start()
    rig.slave.set_ext_diag(True)
    rig.run_ms(20)
    rig.slave.set_ext_diag(False)
    rig.run_ms(20)
    # the first module has inputs from byte 256 on
    assert events(rig, "OB82") == [
        "39 42 1A 52 00 54 01 00 05 00 00 00",
        "38 42 1A 52 00 54 01 00 00 00 00 00",
    ]


def test_a_classic_cpu_without_ob82_stops_at_a_diagnosis(make_rig, classic):
    rig = make_rig(text=ob("OB1", "OB85", "OB86", "OB122"), family=classic).start()
    rig.slave.set_ext_diag(True)
    rig.run_ms(20)
    assert rig.cpu.mode is CpuMode.STOP
    assert "OB82" in rig.cpu.diagnostics[0].message


# --- OB122 --------------------------------------------------------------------------------------


def test_a_classic_cpu_without_ob122_stops_at_an_access_to_nothing(make_rig, classic):
    rig = make_rig(text=ob("OB1", "OB82", "OB85", "OB86"), family=classic).start()
    rig.body(lambda: rig.cpu.write_peripheral(700, 1, 1), "OB1")
    rig.run_ms(20)
    assert rig.cpu.mode is CpuMode.STOP
    assert "OB122" in rig.cpu.diagnostics[0].message


def test_ob122_is_told_the_address_and_the_access_goes_on(make_rig, classic):
    rig = make_rig(text=ALL, family=classic)
    values: list[int] = []
    rig.body(lambda: values.append(rig.cpu.read_peripheral(700, 2)), "OB1")
    rig.start()
    rig.body(lambda: rig.cpu.write_peripheral(701, 1, 5), "OB1")
    rig.run_ms(10)
    assert events(rig, "OB122") == [
        "29 42 01 7A 00 20 02 BC 00 00 00 00",
        "29 42 01 7A 00 20 02 BC 00 00 00 00",
        "29 43 01 7A 00 10 02 BD 00 00 00 00",
    ]
    assert values == [0, 0]
    assert rig.cpu.access_errors == 3


def test_ob122_has_the_priority_of_what_it_interrupts(make_rig):
    rig = make_rig(text=ALL, family=CpuFamily.S7_400, process_image=False).start()
    rig.body(lambda: rig.cpu.read_peripheral(256, 1), "OB86")
    rig.slave.power_off()
    rig.run_ms(5)
    assert [start[2] for start in rig.engine.starts["OB122"]] == [26]


# --- OB85 ---------------------------------------------------------------------------------------


def test_an_s7_400_without_ob85_stops_when_a_slave_in_the_process_image_fails(make_rig):
    for process_image, mode in ((True, CpuMode.STOP), (False, CpuMode.RUN)):
        rig = make_rig(
            text=ob("OB1", "OB82", "OB86", "OB122"),
            family=CpuFamily.S7_400,
            process_image=process_image,
        ).start()
        rig.slave.power_off()
        rig.run_ms(20)
        assert rig.cpu.mode is mode


def test_an_s7_300_does_not_call_ob85_unless_it_is_told_to(make_rig):
    rig = make_rig(text=ob("OB1", "OB86"), family=CpuFamily.S7_300).start()
    rig.slave.power_off()
    rig.run_ms(20)
    assert rig.cpu.mode is CpuMode.RUN
    rig = make_rig(
        text=ob("OB1", "OB86"), family=CpuFamily.S7_300, image_errors=ImageErrors.CHANGES
    ).start()
    rig.slave.power_off()
    rig.run_ms(20)
    assert rig.cpu.mode is CpuMode.STOP
    assert "OB85" in rig.cpu.diagnostics[0].message


def test_an_s7_400_calls_ob85_for_each_module_in_each_update(make_rig):
    rig = make_rig(text=ALL, family=CpuFamily.S7_400).start()
    rig.slave.power_off()
    rig.run_ms(25)
    calls = events(rig, "OB85")
    reads = [event for event in calls if event.startswith("39 B1")]
    writes = [event for event in calls if event.startswith("39 B2")]
    # 30 30 20 30 30 70 20 70: six modules with inputs, eight with outputs, two updates
    assert (len(reads), len(writes)) == (12, 16)
    assert reads[:6] == [
        "39 B1 1A 55 10 00 01 00 00 00 01 00",
        "39 B1 1A 55 10 00 01 01 00 00 01 01",
        "39 B1 1A 55 10 00 01 02 00 00 01 02",
        "39 B1 1A 55 10 00 01 03 00 00 01 03",
        "39 B1 1A 55 20 00 01 04 00 00 01 04",
        "39 B1 1A 55 20 00 01 06 00 00 01 06",
    ]


def test_incoming_and_outgoing_calls_come_once_each(make_rig, classic):
    rig = make_rig("C0 89 87", text=ALL, family=classic, image_errors=ImageErrors.CHANGES).start()
    rig.slave.power_off()
    rig.run_ms(50)
    rig.slave.power_on(5)
    rig.run_ms(100)
    assert events(rig, "OB85") == [
        "39 B3 1A 55 57 00 01 00 00 08 01 00",
        "39 B4 1A 55 57 00 01 00 00 0A 01 00",
        "38 B3 1A 55 57 00 01 00 00 08 01 00",
        "38 B4 1A 55 57 00 01 00 00 0A 01 00",
    ]


# --- OB121 --------------------------------------------------------------------------------------

FAULTY = """
DATA_BLOCK "D"
STRUCT
    fault : BYTE;
    scans : INT;
    digits : WORD := W#16#00AB;
    number : INT;
END_STRUCT;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB1
BEGIN
    D.scans := D.scans + 1;
    D.number := BCD_TO_INT(D.digits);
END_ORGANIZATION_BLOCK
"""
OB121 = """
ORGANIZATION_BLOCK OB121
VAR_TEMP
    EV_CLASS : BYTE;
    SW_FLT : BYTE;
END_VAR
BEGIN
    D.fault := SW_FLT;
END_ORGANIZATION_BLOCK
"""


@pytest.mark.parametrize("engine_name", ["compiled", "reference"])
def test_a_programming_error_calls_ob121_and_the_cpu_goes_on(make_rig, engine_name):
    rig = make_rig(text=FAULTY + OB121, dialect="step7", family=CpuFamily.S7_300)
    rig.cpu.load(rig.program, engine_named(engine_name))
    rig.start()
    assert rig.cpu.mode is CpuMode.RUN
    assert rig.cpu.engine.global_value("D.fault") == 0x21
    assert rig.cpu.engine.global_value("D.scans") == 2
    assert [found.code for found in rig.cpu.programming_errors] == ["FB6014"] * 2


@pytest.mark.parametrize("engine_name", ["compiled", "reference"])
@pytest.mark.parametrize(
    ("family", "text"),
    [(CpuFamily.S7_300, FAULTY), (CpuFamily.S7_1500, FAULTY + OB121)],
    ids=["without OB121", "S7-1500"],
)
def test_otherwise_a_programming_error_takes_the_cpu_to_stop(make_rig, engine_name, family, text):
    rig = make_rig(text=text, dialect="step7", family=family)
    rig.cpu.load(rig.program, engine_named(engine_name))
    rig.start()
    assert rig.cpu.mode is CpuMode.STOP
    assert rig.cpu.diagnostics[0].code == "FB6014"
