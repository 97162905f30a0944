"""Methods, properties, actions, inheritance and namespaces.

IEC 61131-3 third edition, sections 6.6.5 to 6.6.9; CODESYS online help, "Object METHOD", "Object
PROPERTY", "Object ACTION", "SUPER": all methods are virtual, the body of a base block runs only if
SUPER^() calls it.
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram, load_program

Twincat = Callable[[str], LoadedProgram]


@pytest.fixture
def twincat(request: pytest.FixtureRequest, engine_name: str) -> Twincat:
    """`twincat("name.st")` runs the file beside this one in the dialect of TwinCAT and CODESYS."""
    return lambda name: load_program(
        [request.path.parent / name], dialect="twincat", engine=engine_name
    )


def test_a_method_has_inputs_with_defaults_outputs_locals_and_a_result(twincat: Twincat) -> None:
    block = twincat("objects.st").instance("User")
    block()
    assert (block.first, block.second, block.limited) == (5, 100, True)


def test_var_inst_belongs_to_the_instance_and_in_outs_are_references(twincat: Twincat) -> None:
    block = twincat("objects.st").instance("User")
    block()
    assert (block.counted, block.total) == (11 + 12, 11 + 12)
    block()
    assert (block.counted, block.total) == (13 + 14, 11 + 12 + 13 + 14)


def test_a_property_is_read_by_get_and_written_by_set(twincat: Twincat) -> None:
    block = twincat("objects.st").instance("User")
    block()
    assert block.percent == 25.5


def test_methods_are_called_on_elements_of_arrays(twincat: Twincat) -> None:
    block = twincat("objects.st").instance("User")
    block()
    assert (block.listed, block.motors[1].speed, block.motors[3].speed) == (246, 0, 6)


def test_an_inherited_method_calls_what_the_derived_block_overrides(twincat: Twincat) -> None:
    block = twincat("objects.st").instance("User")
    block()
    assert (block.fast, block.fastLimited) == (150, True)


def test_super_runs_the_body_of_the_base_on_the_same_variables(twincat: Twincat) -> None:
    motor = twincat("objects.st").instance("FastMotor")
    seen = []
    for enable in (True, True, False):
        motor(enable=enable)
        seen.append((motor.speed, motor.calls, motor.boost))
    # Faster adds 1, AddTo adds 1 to the speed it refers to and doubles it; Stop begins at 0.
    assert seen == [(4, 1, 51), (12, 2, 52), (2, 103, 53)]


def test_the_block_of_the_instance_decides_which_method_is_meant(twincat: Twincat) -> None:
    block = twincat("abstract.st").instance("User")
    block()
    assert (block.square, block.strip, block.wide) == (18, 12, 2 * 120)
    assert (block.name, block.other) == ("square figure", "figure")


def test_names_in_namespaces_are_found_whole_and_from_inside(engine_name: str) -> None:
    path = __file__.replace("test_conformance_objects.py", "namespaces.st")
    block = load_program([path], dialect="iec", engine=engine_name).instance("User")
    block()
    block()
    assert (block.moved, block.turns) == (28, 2)
