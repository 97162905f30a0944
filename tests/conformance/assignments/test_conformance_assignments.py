"""Several assignments in one statement, set and reset, AND_THEN and OR_ELSE.

TIA Portal help, "Value assignments": from right to left. CODESYS online help, "Assignment as an
expression" (both targets receive the value), "Assignment operator S=" and "AND_THEN".
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram, load_program

Load = Callable[[str], LoadedProgram]


def test_a_chain_assigns_from_right_to_left_and_evaluates_its_value_once(load: Load) -> None:
    block = load("chains.scl").instance("Chains")
    block()
    assert (block.calls, block.a, block.b) == (1, 1, 5)
    assert (block.total, block.long, block.real) == (5 - 3, 1, 1.0)


def test_indices_further_left_see_what_was_assigned_further_right(load: Load) -> None:
    block = load("chains.scl").instance("Chains")
    block()
    assert (block.c, list(block.list)) == (2, [0, 2, 0])


def _twincat(engine_name: str, request: pytest.FixtureRequest) -> LoadedProgram:
    path = request.path.parent / "set_reset.st"
    return load_program([path], dialect="twincat", engine=engine_name)


def test_set_and_reset_write_only_where_their_value_is_true(
    engine_name: str, request: pytest.FixtureRequest
) -> None:
    block = _twincat(engine_name, request).instance("SetReset")
    block(condition=False)
    assert (block.set, block.reset, block.both, block.calls) == (False, True, False, 1)
    block(condition=True)
    assert (block.set, block.reset, block.both, block.calls) == (True, False, True, 2)
    block(condition=False)
    assert (block.set, block.reset, block.both, block.calls) == (True, False, False, 3)


@pytest.mark.parametrize(
    ("left", "values", "calls"), [(True, (True, True), (1, 0)), (False, (False, False), (0, 1))]
)
def test_the_right_side_is_evaluated_only_where_the_left_one_does_not_decide(
    engine_name: str,
    request: pytest.FixtureRequest,
    left: bool,
    values: tuple[bool, bool],
    calls: tuple[int, int],
) -> None:
    block = _twincat(engine_name, request).instance("ShortCircuit")
    block(left=left)
    assert (block.conjunction, block.disjunction) == values
    assert (block.conjunctionCalls, block.disjunctionCalls) == calls
    assert (block.strict, block.strictCalls, block.guarded) == (left, 1, 0)


def test_a_chain_hands_its_value_on_without_reading_the_target_again(
    engine_name: str, request: pytest.FixtureRequest
) -> None:
    path = request.path.parent / "chained_calls.st"
    block = load_program([path], dialect="twincat", engine=engine_name).instance("User")
    block()
    # The value is worked out before the index; `list[list[0]] := 5` makes list[0] 5 and gives on 5.
    assert (block.list[2], block.b, block.list[0], block.list[5]) == (11, 5, 5, 44)
    # SET gets 3 (2 + 3 = 5), then the sixth number (6 + 6 = 12); GET is never called.
    assert block.counter.calls == 13
    assert (block.a, block.c, block.r) == (6, 26, 26.0)
    assert (block.text, block.short) == ("abc", "abc")
