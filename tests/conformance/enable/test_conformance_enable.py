"""EN keeps a call from happening, ENO says whether it went well.

IEC 61131-3, section 6.6.1.6: with EN FALSE the body is not executed and ENO is FALSE. TIA Portal
help, "EN/ENO mechanism" and "ENO: Enable output": a block sets its own ENO by assigning to it.
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram, load_program

Load = Callable[[str], LoadedProgram]


def test_a_call_with_en_false_changes_nothing_but_eno(load: Load) -> None:
    block = load("enable.scl").instance("Calls")
    block(x=8, go=False)
    assert (block.half, block.halfOk, block.sum, block.noteOk) == (-1, False, 0, False)
    block(x=8, go=True)
    assert (block.half, block.halfOk, block.sum, block.noteOk) == (4, True, 8, True)
    block(x=20, go=False)
    assert (block.half, block.halfOk, block.sum, block.noteOk) == (4, False, 8, False)


def test_eno_of_a_function_is_what_it_assigned(load: Load) -> None:
    block = load("enable.scl").instance("Calls")
    block(x=7, go=True)
    assert (block.half, block.halfOk, block.noteOk) == (3, False, True)
    block(x=6, go=True)
    assert (block.half, block.halfOk) == (3, True)


def test_eno_of_an_instance_is_true_again_at_each_call(load: Load) -> None:
    block = load("enable.scl").instance("Calls")
    seen = []
    for x in (0, 1, 0, 0, 1, 0):
        block(x=x, go=True)
        seen.append(block.countOk)
    assert seen == [True, True, True, False, True, False]


@pytest.mark.parametrize(("go", "order", "half"), [(True, 12, 4), (False, 1, 0)])
def test_en_is_asked_before_the_arguments_and_keeps_them_from_being_evaluated(
    load: Load, go: bool, order: int, half: int
) -> None:
    block = load("enable.scl").instance("Arguments")
    block(go=go)
    assert (block.sum, block.half) == (order, half)


def test_eno_of_a_conversion_tells_what_does_not_fit(load: Load) -> None:
    block = load("enable.scl").instance("Conversions")
    block(number=32767, real=4.0, text="12")
    assert (block.smallOk, block.wholeOk, block.readOk, block.rootOk) == (True,) * 4
    assert (block.small, block.whole, block.read, block.root) == (32767, 4, 12, 2.0)
    block(number=32768, real=1e10, text="12a")
    assert (block.smallOk, block.wholeOk, block.readOk, block.rootOk) == (False, False, False, True)
    assert (block.small, block.whole, block.read) == (-32768, 0, 0)
    block(number=-1, real=-1.0, text="-1")
    assert (block.smallOk, block.wholeOk, block.readOk, block.rootOk) == (True, True, True, False)


def test_a_block_reads_its_own_eno(load: Load) -> None:
    block = load("enable.scl").instance("Own")
    block(fail=True)
    assert (block.before, block.after) == (True, False)
    block(fail=False)
    assert (block.before, block.after) == (True, True)


def test_ok_of_step7_tells_overflow_and_division_by_zero(
    engine_name: str, request: pytest.FixtureRequest
) -> None:
    path = request.path.parent / "ok_flag.scl"
    block = load_program([path], dialect="step7", engine=engine_name).instance("Flag")
    block(x=7, y=2, number=5)
    assert (block.sumOk, block.quotientOk, block.smallOk, block.scaledOk) == (True,) * 4
    assert (block.sum, block.quotient, block.small, block.scaled) == (9, 3, 5, 14)
    block(x=32767, y=1, number=32768)
    assert (block.sumOk, block.quotientOk, block.smallOk, block.scaledOk) == (
        *(False, True, False, True),
    )
    assert block.sum == -32768
    block(x=30000, y=0, number=0)
    assert (block.quotient, block.quotientOk, block.scaledOk) == (0, False, True)
    block(x=30000, y=2, number=0)
    assert (block.scaled, block.scaledOk) == (-1, False)
