"""References and pointers (IEC 61131-3 third edition, 6.4.4.10; CODESYS help, "Pointers")."""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def program(load: Load) -> LoadedProgram:
    return load("references.scl")


@pytest.fixture
def walker(program: LoadedProgram) -> BlockInstance:
    block = program.instance("Walker")
    block()
    return block


def test_a_reference_is_the_variable_itself(program: LoadedProgram, walker: BlockInstance) -> None:
    assert (walker.seen, walker.count) == (7, 7)
    assert program.globals["Store"].total == 8
    assert program.globals["Store"].list == [10, 21, 30]
    assert walker.sum == 61


def test_references_are_compared_by_what_they_refer_to(walker: BlockInstance) -> None:
    assert (walker.same, walker.different, walker.unset) == (True, True, True)


def test_a_structure_can_refer_to_its_own_kind(walker: BlockInstance) -> None:
    assert walker.length == 3
    assert walker.b.value == 22
    assert walker.copy.value == 22
    assert walker.copy.next is True


def test_an_in_out_and_a_reference_can_be_the_same_variable(walker: BlockInstance) -> None:
    assert (walker.both, walker.small) == (11, 11)


def test_references_are_read_and_followed_from_outside(walker: BlockInstance) -> None:
    assert (walker.number, walker.node) == (False, True)
    assert walker["node^.value"] == 22
    assert walker["a.next^.next^.value"] == 3
    assert walker["item^"] == 21
    walker["item^"] = 5
    assert walker["list^[2]"] == 5
    walker.node = False
    assert walker.node is False


def test_following_nothing_stops_the_program(program: LoadedProgram) -> None:
    block = program.instance("Walker")
    with pytest.raises(DiagnosticError) as caught:
        block(follow=True)
    (found,) = caught.value.diagnostics
    assert found.code == "FB6031"
    assert found.span is not None
    assert found.span.text == "number^"


def test_a_snapshot_has_what_references_refer_to(program: LoadedProgram) -> None:
    block = program.instance("Walker")
    before = block._instance.snapshot()
    block()
    after = block._instance.snapshot()
    block._instance.restore(before)
    assert block.node is False
    block._instance.restore(after)
    assert block["node^.value"] == 22


def test_pointers_and_references_of_twincat(load: Load) -> None:
    block = load("pointers.twincat").instance("Pointers")
    block()
    assert (block.wasValid, block.isNull, block.isValid) == (False, True, True)
    assert block.axis == {"position": 12.5, "enabled": True}
    assert (block.number, block.read) == (60, 60)
    assert block.outOfDrive == 42
    with pytest.raises(DiagnosticError) as caught:
        block(follow=True)
    (found,) = caught.value.diagnostics
    assert (found.code, found.span and found.span.text) == ("FB6031", "numberRef")
