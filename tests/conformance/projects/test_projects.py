"""Lists of global variables and PROGRAMs that call each other.

Sources: TwinCAT 3 help, "Object GVL", "Attribute 'qualified_only'" and "Object POU"; CODESYS help,
"POU PROGRAM": a program can be called by other blocks, and all calls see the same variables.
"""

from pathlib import Path

import pytest

from harness import LoadedProgram, load_program

_FOLDER = Path(__file__).parent


@pytest.fixture
def line(engine_name: str) -> LoadedProgram:
    names = ("GVL_Line.TcGVL", "GVL_Store.TcGVL", "line.st")
    return load_program([_FOLDER / name for name in names], dialect="twincat", engine=engine_name)


def test_a_variable_is_reached_by_the_name_of_its_list(line: LoadedProgram) -> None:
    line.run("MAIN")
    assert line.engine.global_value("GVL_Line.history") == [0, 0, 3]
    assert line.engine.global_value("GVL_Line.pump.runs") == 1


def test_two_lists_have_the_same_name_for_two_variables(line: LoadedProgram) -> None:
    line.run("MAIN")
    assert line.engine.global_value("GVL_Line.speed") == 40
    assert line.engine.global_value("GVL_Store.speed") == 7
    assert line.engine.global_value("GVL_Store.level") == 147, (
        "without a list in front: not qualified_only"
    )


def test_a_program_that_is_called_keeps_its_variables(line: LoadedProgram) -> None:
    line.run("MAIN")
    line.run("MAIN")
    assert line.engine.global_value("Filling.total") == 4
    assert line.engine.global_value("MAIN.seen") == 4242, (
        "each cycle two pumps wish, and MAIN itself"
    )


def test_a_called_program_is_not_run_by_the_controller_too(line: LoadedProgram) -> None:
    line.scan()
    assert line.engine.global_value("Filling.total") == 2


def test_variables_of_named_programs_come_back_from_a_snapshot(line: LoadedProgram) -> None:
    line.run("MAIN")
    before = line.engine.snapshot()
    line.run("MAIN")
    line.engine.restore(before)
    assert line.engine.global_value("Filling.total") == 2
    assert line.engine.global_value("MAIN.wishes") == 21


def test_what_twincat_projects_do_with_their_types(engine_name: str) -> None:
    program = load_program([_FOLDER / "structures.st"], dialect="twincat", engine=engine_name)
    program.run("Main")
    got = {
        name: program.engine.global_value(f"Main.{name}")
        for name in ("sum", "masked", "inverted", "mixed", "stamps", "found", "counter.Q")
    }
    assert got == {
        "sum": 4 + 2,
        "masked": -2 & 0xF0F0 - 0x10000,
        "inverted": 1,
        "mixed": 0xF0F0 - 0x10000 - 2,
        "stamps": 2,
        "found": True,
        "counter.Q": True,
    }, "the parts of a base come first; integers combine bit by bit; a FUNCTION begins anew"


def test_variables_are_handed_over_as_references(engine_name: str) -> None:
    program = load_program([_FOLDER / "references.st"], dialect="twincat", engine=engine_name)
    program.run("Main")
    names = ("x", "user.sum", "asked", "text", "found")
    got = [program.engine.global_value(f"Main.{name}") for name in names]
    assert got == [4, 8, 4, "bc", 2 + 2], "without REF=, and to FB_init; CODESYS's names of texts"
