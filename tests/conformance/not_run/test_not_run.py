"""What is right in CODESYS and TwinCAT and cannot run here stops the run, and nothing else does.

Sources: CODESYS help, "ADR", "SIZEOF", "Pointers"; for the sizes "Data types" and "Alignment".
"""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram, load_program

_FILE = Path(__file__).parent / "not_run.st"


@pytest.fixture
def program(engine_name: str) -> LoadedProgram:
    return load_program([_FILE], dialect="twincat", engine=engine_name)


def test_a_pointer_to_a_variable_runs(program: LoadedProgram) -> None:
    copy = program.instance("Copy")
    copy(raw=False)
    assert copy.done == 2


def test_a_calculated_pointer_stops_the_run_where_it_is(program: LoadedProgram) -> None:
    copy = program.instance("Copy")
    with pytest.raises(DiagnosticError) as caught:
        copy(raw=True)
    (found,) = caught.value.diagnostics
    assert (found.code, found.span and found.span.line) == ("FB6072", 10)
    assert copy.done == 1, "what stands in front has run"


def test_sizes_count_bytes_with_their_gaps(program: LoadedProgram) -> None:
    assert program.call("Size") == 24 * 1000 + 2 * 100 + 24
