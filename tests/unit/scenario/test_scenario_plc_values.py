"""Variables of every type are set and expected as the PLC languages write their values."""

import pytest

from fbgen.catalog import load_catalog, load_yaml, validate
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import load_plant
from fbgen.source import Source
from harness.installation import PlantSetup, build_plant
from harness.scenario.model import Scenario
from harness.scenario.plant_stage import PlantStage
from harness.scenario.runner import ScenarioRun
from tests.unit.scenario.scenario_files import PLANT

PROGRAM = """
TYPE "typeItem"
VERSION : 0.1
STRUCT
  ok : Bool;
  value : Int;
END_STRUCT;
END_TYPE

DATA_BLOCK "Types"
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
VAR
  flag : Bool;
  b : Byte;
  w : Word;
  dw : DWord;
  lw : LWord;
  si : SInt;
  i : Int;
  ui : UInt;
  r : Real;
  lr : LReal;
  t : Time;
  lt : LTime;
  d : Date;
  tod : Time_Of_Day;
  ldt : LDT;
  c : Char;
  s : String[5];
  list : Array[0..3] of Int;
  grid : Array[1..2, 1..3] of Real;
  items : Array[1..2] of "typeItem";
END_VAR
BEGIN
END_DATA_BLOCK

ORGANIZATION_BLOCK "Main"
VERSION : 0.1
BEGIN
  "Types".list[1] := "Types".list[1] + 1;
  IF "Types".list[0] > 0 THEN
    "Types".list[0] := "Types".list[0] / "Types".list[2];
  END_IF;
END_ORGANIZATION_BLOCK
"""


def run(steps: str) -> ScenarioRun:
    """A scenario on a CPU that runs the program above."""
    catalog = load_catalog()
    setup = PlantSetup(sources=[Source("main.scl", PROGRAM)])
    plant = build_plant(load_plant(PLANT, catalog), catalog, setup)
    text = f"version: 1\ntitle: Types\nplant: x\nsteps:\n{steps}"
    scenario = validate(load_yaml(Source("types.scenario.yaml", text)), Scenario)
    return ScenarioRun(scenario, PlantStage(plant, catalog))


def failure(steps: str) -> str:
    """The message of the only finding."""
    with pytest.raises(DiagnosticError) as wrong:
        run(steps).run()
    (found,) = wrong.value.diagnostics
    return f"{found.code}: {found.message}"


@pytest.mark.parametrize(
    ("variable", "value", "same"),
    [
        ("flag", "true", "true"),
        ("b", "16#FF", "255"),
        ("w", "16#8401", "2#1000_0100_0000_0001"),
        ("w", "WORD#16#8401", "33793"),
        ("dw", "DW#16#FFFF_FFFF", "4294967295"),
        ("lw", "5", "16#5"),
        ("si", "-128", "-128"),
        ("i", "INT#-5", "-5"),
        ("ui", "65535", "16#FFFF"),
        ("r", "43.28", "43.28"),
        ("r", "2", "2.0"),
        ("lr", "0.1", "0.1"),
        ("r", ".nan", ".nan"),
        ("lr", "-.inf", "-.inf"),
        ("s", ".nan", ".nan"),
        ("t", "T#2s", "TIME#2000ms"),
        ("t", "T#-1s500ms", "T#-1.5s"),
        ("lt", "LT#2us", "LTIME#2000ns"),
        ("d", "D#2024-02-29", "DATE#2024-2-29"),
        ("tod", "TOD#01:00:00.5", "TIME_OF_DAY#1:00:00.500"),
        ("ldt", "LDT#2024-02-29-01:00:00", "LDT#2024-02-29-01:00:00"),
        ("c", "x", '"x"'),
        ("s", "16#1", '"16#1"'),
        ("s", '""', "''"),
        ("list[3]", "7", "7"),
        ("grid[2, 3]", "1.5", "1.5"),
        ("items[2].ok", "true", "true"),
        ("items[1].value", "-3", "-3"),
    ],
)
def test_a_value_of_each_type_is_set_and_found(variable: str, value: str, same: str) -> None:
    path = f"plc.Types.{variable}"
    # set before the start: a restart would take it back, so it is set again in RUN
    run(
        f"  - wait: 50 ms\n  - set:\n      {path}: {value}\n"
        f"  - wait: 20 ms\n  - expect:\n      {path}: {same}\n"
    ).run()


@pytest.mark.parametrize(
    ("set_to", "expected"), [("1.5", ".nan"), (".nan", "1.5"), (".inf", "-.inf"), ("0.0", ".inf")]
)
def test_what_is_no_number_equals_only_itself(set_to: str, expected: str) -> None:
    steps = f"  - wait: 50 ms\n  - set: {{plc.Types.r: {set_to}}}\n"
    assert failure(f"{steps}  - expect: {{plc.Types.r: {expected}}}\n").startswith("FB8001")
    run(f"{steps}  - expect: {{plc.Types.r: {{differs_from: {expected}}}}}\n").run()


def test_what_is_no_number_is_no_limit() -> None:
    assert failure("  - expect: {plc.Types.r: {min: .nan}}\n") == (
        "FB8009: nothing is less or greater than .nan"
    )


def test_paths_with_indices_stand_in_quotes_in_flow_style() -> None:
    run('  - expect: {"plc.Types.grid[2,3]": 0.0, "plc.types.ITEMS[1].OK": false}\n').run()


def test_limits_of_a_time_are_times() -> None:
    run(
        "  - wait: 50 ms\n  - set: {plc.Types.t: T#2s}\n"
        "  - expect: {plc.Types.t: {min: T#1s, max: T#2s, differs_from: T#1500ms}}\n"
    ).run()
    assert failure("  - expect: {plc.Types.t: {min: T#1s}}\n") == (
        "FB8001: plc.Types.t is T#0ms, expected at least T#1000ms"
    )


@pytest.mark.parametrize(
    ("variable", "value"),
    [
        ("flag", "T#2s"),
        ("b", "256"),
        ("w", "65536"),
        ("si", "128"),
        ("i", "5.0"),
        ("i", "T#2s"),
        ("r", "true"),
        ("t", "2000"),
        ("t", "2 s"),
        ("t", "D#2024-02-29"),
        ("t", "T#25d"),
        ("d", "2024-02-29"),
        ("d", "D#2024-02-30"),
        ("tod", "TOD#25:00:00"),
        ("c", "xy"),
        ("c", "1"),
        ("s", "longer"),
        ("s", "5"),
        ("list", "5"),
        ("items[1]", "5"),
        ("grid", "0.0"),
    ],
)
def test_a_value_that_a_type_does_not_have_is_a_mistake(variable: str, value: str) -> None:
    path = f"plc.Types.{variable}"
    assert failure(f"  - set:\n      {path}: {value}\n  - expect: {{cpu.scans: 0}}\n").startswith(
        f"FB8009: {path} is of type "
    )
    assert failure(f"  - expect:\n      {path}: {value}\n").startswith("FB8009")


@pytest.mark.parametrize("path", ["list[4]", "list[1,2]", "list[a]", "grid[1]", "flag[1]", "i.x"])
def test_an_index_or_part_that_is_not_there_is_an_unknown_path(path: str) -> None:
    assert failure(f"  - expect:\n      plc.Types.{path}: 0\n").startswith("FB8003")


def test_values_are_shown_as_the_plc_writes_them() -> None:
    steps = (
        "  - wait: 50 ms\n  - set: {plc.Types.t: T#2s, plc.Types.b: 10, plc.Types.s: hello}\n"
        "  - expect: {plc.Types.t: T#3s, plc.Types.b: 16#0B, plc.Types.s: world}\n"
    )
    with pytest.raises(DiagnosticError) as wrong:
        run(steps).run()
    assert [item.message for item in wrong.value.diagnostics] == [
        "plc.Types.t is T#2000ms, expected T#3000ms",
        "plc.Types.b is 16#0A (10), expected 16#0B (11)",
        "plc.Types.s is 'hello', expected 'world'",
    ]


def test_bits_of_a_plc_word_are_named_after_a_word_of_the_catalogue() -> None:
    run(
        "  - wait: 50 ms\n  - set: {plc.Types.w: 16#9F00}\n"
        "  - expect: {plc.Types.w: {word: tospbdp001.status, bits: {status_code: 16#1F}}}\n"
    ).run()


def test_a_program_that_stops_the_cpu_fails_a_scenario_that_does_not_look() -> None:
    steps = (
        "  - wait: 50 ms\n  - set:\n      plc.Types.list[0]: 1\n  - wait: 50 ms\n"
        "  - expect: {drive.pump.running: false}\n"
    )
    with pytest.raises(DiagnosticError) as wrong:
        run(steps).run()
    (found,) = wrong.value.diagnostics
    assert (found.code, found.help) == (
        "FB8012",
        "mend what the notes say, or expect cpu.mode: STOP",
    )
    note, *values = found.notes
    assert note.message == "the CPU went to STOP: division by zero [FB6003]"
    assert note.span is not None
    assert note.span.text == '"Types".list[0] / "Types".list[2]'
    assert [value.message for value in values] == ['"Types".list[0] = 1', '"Types".list[2] = 0']
    run(steps + "  - expect: {cpu.mode: STOP, bus.mode: CLEAR}\n").run()


def test_a_failed_expectation_says_why_the_cpu_stopped() -> None:
    steps = (
        "  - wait: 50 ms\n  - set:\n      plc.Types.list[0]: 1\n"
        "  - expect: {drive.pump.running: true}\n    within: 1 s\n"
    )
    with pytest.raises(DiagnosticError) as wrong:
        run(steps).run()
    (found,) = wrong.value.diagnostics
    assert "the CPU went to STOP: division by zero [FB6003]" in [n.message for n in found.notes]
