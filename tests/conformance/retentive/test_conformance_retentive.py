"""What a warm restart keeps and a cold one forgets.

Expected: IEC 61131-3 section 6.5.6 (RETAIN keeps its value at a warm restart; NON_RETAIN and what
says neither have initial values here); STEP 7 System Software reference, "Cold restart" and "Warm
restart": data blocks of an S7-300/400 keep their contents at a warm one.
"""

import json
from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program

Load = Callable[[str], LoadedProgram]
CLASSIC = """
DATA_BLOCK DB10
STRUCT
    n : INT;
END_STRUCT
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB1
VAR_TEMP
    info : ARRAY[0..19] OF BYTE;
END_VAR
BEGIN
    DB10.n := DB10.n + 1;
END_ORGANIZATION_BLOCK
"""


def test_a_warm_restart_keeps_what_is_retentive(load: Load) -> None:
    program = load("retentive.scl")
    program.scan(3)
    program.start()
    kept = program.globals.Kept
    assert (kept.hours, kept.name, list(kept.table)) == (3, "old", [0.0, 0.5, 0.0])
    assert program.globals.Lost.hours == 0


def test_in_instances_each_variable_for_itself_also_in_nested_ones(load: Load) -> None:
    program = load("retentive.scl")
    program.scan(3)
    program.start()
    value = program.engine.global_value
    assert [value("Hall.meter.sum"), value("Hall.meter.last")] == [3, 0]
    assert [value("Hall.pair[1].sum"), value("Hall.pair[1].last")] == [3, 0]


def test_a_cold_restart_forgets_everything(load: Load) -> None:
    program = load("retentive.scl")
    program.scan(3)
    program.start(warm=False)
    assert (program.globals.Kept.hours, program.globals.Kept.name) == (0, "new")
    assert program.engine.global_value("Hall.meter.sum") == 0


def test_variables_of_a_program_are_kept_as_their_section_says(load: Load) -> None:
    program = load("retentive.st")
    program.scan(2)
    program.start()
    value = program.engine.global_value
    assert [value("Main.kept"), value("Main.lost"), value("Main.plain")] == [7, 0, 0]


def test_data_blocks_of_step7_are_retentive(engine_name: str) -> None:
    program = load_program([Source("classic", CLASSIC)], "step7", engine_name)
    program.scan(3)
    program.start()
    assert program.globals.DB10.n == 3
    program.start(warm=False)
    assert program.globals.DB10.n == 0


@pytest.mark.parametrize(("word", "expected"), [("RETAIN", 3), ("NON_RETAIN", 0)])
def test_the_head_of_a_data_block_can_say_it(engine_name: str, word: str, expected: int) -> None:
    text = f"""
    DATA_BLOCK "D"
    VERSION : 0.1
    {word}
    STRUCT
        n : Int;
    END_STRUCT;
    BEGIN
    END_DATA_BLOCK
    ORGANIZATION_BLOCK "Main"
    BEGIN
        "D".n += 1;
    END_ORGANIZATION_BLOCK
    """
    program = load_program([Source("head", text)], engine=engine_name)
    program.scan(3)
    program.start()
    assert program.globals.D.n == expected


def test_retentive_data_go_through_a_file_into_another_run(load: Load) -> None:
    program = load("retentive.scl")
    program.scan(3)
    text = json.dumps(program.retentive())
    later = load("retentive.scl")
    later.restore_retentive(json.loads(text))
    later.start()
    later.scan()
    assert later.globals.Kept.hours == 4
    assert later.engine.global_value("Hall.pair[1].sum") == 4
    assert later.globals.Lost.hours == 1


def test_retentive_data_that_do_not_fit_change_nothing(load: Load) -> None:
    program = load("retentive.scl")
    with pytest.raises(DiagnosticError) as caught:
        program.restore_retentive({'"Kept".hours': 7, '"Gone".x': 1, '"Lost".hours': "text"})
    assert len(caught.value.diagnostics) == 2
    assert program.globals.Kept.hours == 0
