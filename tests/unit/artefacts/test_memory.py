"""The estimate of work memory: data blocks to the byte, code by the stated rule."""

from pathlib import Path

import pytest

from fbgen.artefacts.memory import (
    BYTES_A_BLOCK,
    BYTES_A_CALL,
    BYTES_A_DATA_BLOCK,
    BYTES_AN_OPERAND,
    WorkMemory,
    memory_of,
)
from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.lang.checker import check
from fbgen.lang.parser import parse
from fbgen.plant import CPUS, cpus_of, load_plant, read_plant
from fbgen.source import Source
from tests.unit.artefacts.reading import TWO_GATEWAYS, generated
from tests.unit.blocks.programs import shipped_catalog

PROGRAM = """
TYPE "part"
STRUCT
   first : Bool;
   second : Bool;
   count : Byte;
   wide : Word;
   text : String[5];
END_STRUCT;
END_TYPE
FUNCTION_BLOCK "inner"
VAR_INPUT a : Bool; b : Real; END_VAR
VAR_IN_OUT p : "part"; n : Int; END_VAR
VAR t {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME; last : Bool; END_VAR
VAR_TEMP unseen : Array[0..99] of DWord; END_VAR
BEGIN
   #n := #n + 1;
END_FUNCTION_BLOCK
FUNCTION_BLOCK "outer"
VAR one : "inner"; two : "inner"; many : Array[1..3] of "part"; END_VAR
BEGIN
   #one(a := TRUE, b := 1.0, p := #many[1], n := #many[2].wide);
END_FUNCTION_BLOCK
DATA_BLOCK "values"
STRUCT x : "part"; y : Bool; END_STRUCT;
BEGIN
END_DATA_BLOCK
DATA_BLOCK "instance"
"outer"
BEGIN
END_DATA_BLOCK
""".replace("n := #many[2].wide", "n := #count").replace(
    'VAR one : "inner"', 'VAR count : Int; one : "inner"'
)

PART = 4 + 8
"""Two BOOLs and a BYTE, then a WORD at byte 2; STRING[5] has 7 bytes and ends at an even one."""
INNER = {True: 2 + 4 + 6 + 2 + 22 + 2, False: 2 + 4 + 6 + 2 + 16 + 2}
"""a, b, a pointer to p, n, the timer of S7-300/400 or S7-1200/1500, last."""


def memory(*, classic: bool) -> dict[str, tuple[int, bool]]:
    file = parse(Source("memory.scl", PROGRAM), "tia")
    found = memory_of([file], check([file], "tia"), classic=classic)
    return {block.name: (block.size, block.exact) for block in found.blocks}


@pytest.mark.parametrize("classic", [True, False])
def test_data_blocks_have_the_bytes_of_the_classic_layout(classic: bool) -> None:
    found = memory(classic=classic)
    assert found["values"] == (BYTES_A_DATA_BLOCK + PART + 2, True)
    inside = 2 + 2 * INNER[classic] + 3 * PART
    assert found["instance"] == (BYTES_A_DATA_BLOCK + inside, True)


def test_code_is_estimated_by_the_rule_of_thumb() -> None:
    found = memory(classic=True)
    assert found["inner"] == (BYTES_A_BLOCK + 3 * BYTES_AN_OPERAND, False)
    size, exact = found["outer"]
    assert not exact
    assert size > BYTES_A_BLOCK + BYTES_A_CALL + 4 * BYTES_AN_OPERAND


def test_code_and_data_are_summed_up_apart() -> None:
    file = parse(Source("memory.scl", PROGRAM), "tia")
    found: WorkMemory = memory_of([file], check([file], "tia"), classic=True)
    assert found.data == sum(block.size for block in found.blocks if block.exact)
    assert found.code + found.data == sum(block.size for block in found.blocks)


GATEWAY = """\
  - name: g{0}
    type: tospbdp001
    layout: gsd10
    profibus_address: {0}
    access: per_identifier
    input_address: {1}
    output_address: {1}
    drives:
      - {{name: d{0}, inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}}
"""


def with_cpu(plc: str, cpu: str) -> tuple[Diagnostic, ...]:
    """What is said about a plant with 30 gateways on this CPU."""
    head = f"version: 1\nname: hall\ndialect: tia\nplc: {plc}\ncpu: {cpu}\ngateways:\n"
    gateways = "".join(GATEWAY.format(number, 512 + 16 * number) for number in range(1, 31))
    return generated(head + gateways).warnings


def test_a_cpu_with_too_little_memory_is_a_warning_at_its_place() -> None:
    found = with_cpu("s7-400", "412-1XF03")[0]
    assert (found.code, found.severity) == ("FB5015", Severity.WARNING)
    assert found.span is not None
    assert found.span.source.text[found.span.start : found.span.end] == "412-1XF03"
    assert "the work memory of CPU 412-1XF03 has 48 KiB" in found.message
    assert "414-3EM05" in found.help


def test_a_cpu_with_enough_memory_is_none() -> None:
    assert with_cpu("s7-1500", "1513-1") == ()


@pytest.mark.parametrize(
    ("cpu", "said"),
    [("1512C", "is not known"), ("1214C", "is no S7-1500")],
)
def test_a_cpu_that_is_not_in_the_table_is_refused(cpu: str, said: str) -> None:
    text = TWO_GATEWAYS.replace("plc: s7-1500", f"plc: s7-1500\ncpu: {cpu}")
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", text), shipped_catalog())
    (found,) = failure.value.diagnostics
    assert found.code == "FB2023"
    assert said in found.message
    assert "1511-1, 1513-1" in found.help


def test_the_bad_plant_file_names_line_and_column() -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_plant(Path(__file__).parents[1] / "bad" / "FB2023_cpu.yaml", shipped_catalog())
    (found,) = failure.value.diagnostics
    assert found.code == "FB2023"
    assert found.span is not None
    assert found.span.source.line_column(found.span.start) == (5, 6)


def test_every_s7_family_has_cpus_and_every_size_is_one() -> None:
    for family in ("s7-300", "s7-400", "s7-1200", "s7-1500"):
        assert cpus_of(family)
    assert cpus_of("iec") == ()
    assert all(cpu.code_kib > 0 and (cpu.data_kib or 1) > 0 for cpu in CPUS.values())
