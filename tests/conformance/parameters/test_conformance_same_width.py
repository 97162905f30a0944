"""In-outs that a function block copies may be of another type of the same width, converted twice.

Source: TIA Portal help, "Overview of data type conversion", without the IEC check.
"""

from collections.abc import Callable

from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]


def test_the_bits_go_in_and_come_back(load: Load) -> None:
    caller = load("same_width.scl").instance("Caller")
    caller()
    assert (caller.code, caller.bits) == (ord("b"), 0xFFFF)
    assert list(caller.list) == [1, 3, 3]
    assert caller.kept == 3
    caller()
    assert (caller.bits, list(caller.list)) == (0, [1, 4, 3])
