"""ARRAY data blocks: their elements are those of THIS.

Source: TIA Portal help, "Addressing ARRAY data blocks" and "Creating data blocks".
"""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]


def test_its_elements_are_read_and_written_and_begin_with_their_start_values(load: Load) -> None:
    program = load("array_blocks.scl")
    cells = program.instance("Cells")
    cells(n=1)
    assert (cells.before, cells.sum) == (8, 9)
    cells(n=2)
    assert (cells.before, cells.sum) == (0, 10)
    assert program.globals["Numbers"].THIS[1] == 9


def test_an_index_outside_of_it_stops_the_run(load: Load) -> None:
    cells = load("array_blocks.scl").instance("Cells")
    with pytest.raises(DiagnosticError):
        cells(n=3)
