"""DPNRM_DG (SFC13): a slave's diagnosis over several calls, on every family and both engines."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.types import BOOL, ArrayType
from fbgen.source import Source, Span
from harness.engine.loading import engine_named, read_program
from harness.plc import CpuFamily

ALL = [CpuFamily.S7_300, CpuFamily.S7_400, CpuFamily.S7_1200, CpuFamily.S7_1500]
LADDR = 2046
SPAN = Span(Source("test.scl", "DPNRM_DG"), 0, 8)


class Calls:
    """A rig whose station has a diagnosis address, and calls of the instruction on it."""

    def __init__(self, make_rig, record_of, family=CpuFamily.S7_1500, max_diagnosis=8):
        self.rig = rig = make_rig(process_image=False, family=family)
        self.record_of = record_of
        rig.slave.type = rig.slave.type.__class__(
            1, rig.slave.type.configuration, max_diagnosis_bytes=max_diagnosis
        )
        rig.cpu.slave_diagnosis.stations[LADDR] = rig.station
        rig.start()

    def call(self, record, laddr=LADDR, req=True):
        busy = self.record_of(1, BOOL)
        arguments = {"REQ": req, "LADDR": laddr, "RECORD": record, "BUSY": busy}
        ret_val = self.rig.cpu.instruction("DPNRM_DG", arguments, SPAN)
        return ret_val & 0xFFFF, busy.data[0]

    def read(self, record, laddr=LADDR):
        found = self.call(record, laddr)
        while found[1]:
            self.rig.run_ms(1)
            found = self.call(record, laddr)
        return found[0]


@pytest.mark.parametrize("family", ALL)
def test_a_job_takes_several_calls_and_ends_with_the_length(make_rig, record_of, family):
    calls = Calls(make_rig, record_of, family)
    calls.rig.slave.set_ext_diag(True, b"\x02\x10")
    record = record_of(8)
    assert calls.call(record) == (0x7001, 1)
    assert calls.call(record) == (0x7002, 1)
    assert calls.call(record, req=False) == (0x7002, 1), "REQ says nothing meanwhile"
    assert record.data == b"\xee" * 8
    calls.rig.run_ms(4)
    assert calls.call(record, req=False) == (8, 0)
    assert record.data.hex(" ").upper() == "08 0C 00 01 00 01 02 10"
    assert calls.call(record, req=False) == (0x7000, 0)


def test_a_longer_record_keeps_its_rest_and_a_shorter_one_takes_nothing(make_rig, record_of):
    calls = Calls(make_rig, record_of)
    longer = record_of(10)
    assert calls.read(longer) == 6
    assert longer.data[6:] == b"\xee" * 4
    calls.rig.slave.set_ext_diag(True, b"\x02\x01")
    shorter = record_of(7)
    assert calls.read(shorter) == 0x80B1
    assert shorter.data == b"\xee" * 7


def test_what_nobody_has_configured_is_refused_at_once(make_rig, record_of):
    calls = Calls(make_rig, record_of)
    assert calls.call(record_of(8), laddr=4) == (0x8090, 0)
    assert calls.call(record_of(8, ArrayType(((0, 7),), BOOL))) == (0x8092, 0)


def test_a_slave_that_is_gone_gives_none_and_is_asked_again(make_rig, record_of):
    calls = Calls(make_rig, record_of)
    calls.rig.slave.power_off()
    calls.rig.run_ms(10)
    assert calls.read(record_of(8)) == 0x80C5
    calls.rig.slave.power_on(5)
    calls.rig.run_ms(30)
    assert calls.read(record_of(8)) == 6


def test_a_start_of_the_cpu_ends_the_job(make_rig, record_of):
    calls = Calls(make_rig, record_of)
    assert calls.call(record_of(8)) == (0x7001, 1)
    calls.rig.cpu.start()
    calls.rig.run_ms(20)
    assert calls.call(record_of(8), req=False) == (0x7000, 0)


TIA = """
DATA_BLOCK "Data" STRUCT
    record : ARRAY[0..7] OF BYTE; busy : BOOL; result : INT; calls : INT;
END_STRUCT; BEGIN END_DATA_BLOCK
ORGANIZATION_BLOCK "Main" BEGIN
    "Data".result := DPNRM_DG(REQ := TRUE, LADDR := 2046,
        RECORD => "Data".record, BUSY => "Data".busy);
    IF "Data".busy THEN "Data".calls := "Data".calls + 1; END_IF;
END_ORGANIZATION_BLOCK
"""
STEP7 = """
DATA_BLOCK Data STRUCT
    record : ARRAY[0..7] OF BYTE; busy : BOOL; result : INT; calls : INT;
END_STRUCT BEGIN END_DATA_BLOCK
ORGANIZATION_BLOCK OB1 BEGIN
    Data.result := SFC13(REQ := TRUE, LADDR := W#16#7FE, RECORD := Data.record, BUSY := Data.busy);
    IF Data.busy THEN Data.calls := Data.calls + 1; END_IF;
END_ORGANIZATION_BLOCK
"""


@pytest.mark.parametrize("engine", ["compiled", "reference"])
@pytest.mark.parametrize(
    ("text", "dialect", "family"),
    [(TIA, "tia", CpuFamily.S7_1500), (STEP7, "step7", CpuFamily.S7_300)],
)
def test_both_engines_write_record_and_busy(make_rig, engine, text, dialect, family):
    rig = make_rig(process_image=False, family=family)
    rig.cpu.slave_diagnosis.stations[LADDR] = rig.station
    program = read_program([Source("test.scl", text)], dialect)
    rig.cpu.load(program, engine_named(engine))
    rig.slave.power_on(5)
    rig.cpu.start()
    results = set()
    for _ in range(60):
        rig.run_ms(1)
        results.add(rig.cpu.engine.global_value("Data.result"))
    assert results >= {0x7001, 6}
    assert rig.cpu.engine.global_value("Data.calls") > 1
    assert bytes(rig.cpu.engine.global_value("Data.record")[:6]).hex() == "000c00010001"


def test_busy_is_a_bool():
    wrong = TIA.replace("busy : BOOL", "busy : INT").replace('IF "Data".busy', "IF TRUE")
    with pytest.raises(DiagnosticError) as raised:
        read_program([Source("test.scl", wrong)])
    (found,) = raised.value.diagnostics
    assert (found.code, found.span.text) == ("FB4011", '"Data".busy')
