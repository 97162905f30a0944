"""Methods, properties, actions, inheritance and namespaces.

IEC 61131-3 third edition, sections 6.6.5 to 6.6.9; CODESYS online help, "Object METHOD", "Object
PROPERTY", "Object ACTION", "SUPER": all methods are virtual, the body of a base block runs only if
SUPER^() calls it.
"""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
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


def test_the_instance_behind_a_variable_of_an_interface_decides_what_is_called(
    twincat: Twincat,
) -> None:
    block = twincat("interfaces.st").instance("User")
    block()
    # 3 * 3, then 10 * 2, then the square again, which has grown to 4 * 4, times 3.
    assert (block.a, block.b, block.sum) == (9, (9 * 10 + 20) * 10 + 48, 25 + 2 * 7)
    assert (block.total, block.before) == (1 + 100 + 1, 4)


def test_properties_are_read_and_written_by_a_variable_of_an_interface(twincat: Twincat) -> None:
    block = twincat("interfaces.st").instance("User")
    block()
    assert (block.width, block.name) == (7 + 7, "strip")


def test_interface_variables_start_with_null_and_compare_by_instance(twincat: Twincat) -> None:
    block = twincat("interfaces.st").instance("User")
    block()
    assert (block.isNull, block.same, block.differs) == (True, True, True)
    assert (block.shape, block.named) == (False, True)


def test_a_method_of_null_stops_the_program(twincat: Twincat) -> None:
    block = twincat("interfaces.st").instance("Empty")
    with pytest.raises(DiagnosticError) as caught:
        block()
    found = caught.value.diagnostics[0]
    assert (found.code, found.span and found.span.text) == ("FB6031", "shape")


@pytest.mark.parametrize(("n", "answer"), [(1, 10), (2, 21), (3, 32), (9, 32)])
def test_instances_of_one_block_may_ask_each_other(twincat: Twincat, n: int, answer: int) -> None:
    block = twincat("interfaces.st").instance("Links")
    block(n=n)
    assert block.answer == answer


def test_a_part_can_change_the_block_around_it(twincat: Twincat) -> None:
    block = twincat("interfaces.st").instance("Whole")
    block()
    block()
    assert block.told == 1002


def test_the_index_of_an_instance_is_worked_out_once(twincat: Twincat) -> None:
    block = twincat("interfaces.st").instance("Chooser")
    block()
    assert (block.area, block.asked) == (45, 1)
    block()
    assert (block.area, block.asked) == (50, 2)


def test_fb_init_runs_after_the_initial_values_base_first_inner_instances_first(
    twincat: Twincat,
) -> None:
    program = twincat("starts.st")
    station = program.globals.theStation
    assert [pump.base for pump in (station.pumps[1], station.pumps[3])] == [104, 104]
    assert (station.pumps[2].order, station.pumps[2].speed) == ("bd", 2.5)
    assert (station.one.base, station.ready) == (7 + 1, 104 + 8)
    assert program.globals["Main.s"][1].ready == 112
    assert (program.globals["Main.p"].base, program.globals["Main.p"].speed) == (111, 50.0)


def test_fb_init_is_told_whether_remanent_variables_start_anew(twincat: Twincat) -> None:
    program = twincat("starts.st")
    pump = program.globals.thePump
    assert pump.retained is True
    program.reset(warm=True)
    assert (pump.retained, pump.order, pump.base) == (False, "bd", 111)
    program.reset()
    assert (pump.retained, pump.order, pump.base) == (True, "bd", 111)


def test_an_instance_from_outside_gets_the_arguments_of_fb_init(twincat: Twincat) -> None:
    pump = twincat("starts.st").instance("Pump", number=5)
    assert (pump.base, pump.speed, pump.order) == (105, 1.5, "bd")


def test_an_unknown_argument_of_fb_init_is_reported(twincat: Twincat) -> None:
    with pytest.raises(DiagnosticError) as caught:
        twincat("starts.st").instance("Pump", numbr=5)
    assert caught.value.diagnostics[0].code == "FB6020"


def test_methods_are_called_from_python(twincat: Twincat) -> None:
    motor = twincat("objects.st").instance("Motor")
    assert (motor.Faster(step=3), motor.faster(), motor.speed) == (3, 8, 8)
    given = motor.Faster.with_outputs(step=500)
    assert (given.value, given.outputs) == (100, {"limited": True})
    assert motor.Count.with_outputs(total=5).outputs == {"total": 16}
    assert (motor.Stop(), motor.speed) == (None, 0)


def test_properties_are_attributes_in_python(twincat: Twincat) -> None:
    user = twincat("objects.st").instance("User")
    user()
    user.motors[3].Percent = 77.0
    assert (user.motors[3].speed, user.motors[3].Percent) == (77, 77.0)
    assert user.fastMotor.Faster(step=1000) == 150


def test_an_unknown_input_of_a_method_is_reported(twincat: Twincat) -> None:
    motor = twincat("objects.st").instance("Motor")
    with pytest.raises(DiagnosticError) as caught:
        motor.Faster(stepp=3)
    assert caught.value.diagnostics[0].code == "FB6020"


def test_an_in_out_instance_is_the_instance_itself(twincat: Twincat) -> None:
    block = twincat("shared.st").instance("User")
    block()
    assert (block.sum, block.left) == (5 + 6, 6)


def test_var_stat_of_a_method_is_shared_by_all_instances(twincat: Twincat) -> None:
    block = twincat("shared.st").instance("User")
    block()
    assert (block.first, block.second) == (1, 2)
    block()
    assert (block.first, block.second) == (3, 4)


def test_an_instance_data_block_is_called_and_keeps_what_is_retained(engine_name: str) -> None:
    path = __file__.replace("test_conformance_objects.py", "instance_block.scl")
    program = load_program([path], engine=engine_name)
    program.run("Main")
    assert program.globals.Counter_DB.count == 4 + 4
    program.reset(warm=True)
    assert (program.globals.Counter_DB.count, program.globals.Counter_DB.step) == (0, 4)


def test_names_in_namespaces_are_found_whole_and_from_inside(engine_name: str) -> None:
    path = __file__.replace("test_conformance_objects.py", "namespaces.st")
    block = load_program([path], dialect="iec", engine=engine_name).instance("User")
    block()
    block()
    assert (block.moved, block.turns) == (28, 2)


def test_the_innermost_namespace_that_has_a_name_is_meant(engine_name: str) -> None:
    path = __file__.replace("test_conformance_objects.py", "using.st")
    program = load_program([path], dialect="iec", engine=engine_name)
    user, other = program.instance("User"), program.instance("Other")
    user()
    other()
    assert (user.first, user.second, user.third, user.runs) == (100, 102, 200, True)
    assert other.n == 8


def test_each_element_of_an_array_has_arguments_of_its_own(twincat: Twincat) -> None:
    program = twincat("element_arguments.st")
    program.run("Main")
    assert program.engine.global_value("Main.sum") == 11 + 25 + 8 + 8 + 9
