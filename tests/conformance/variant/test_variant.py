"""VARIANT: a parameter that takes variables of any type.

Expected values: TIA Portal help, "TypeOf", "TypeOfElements", "IS_ARRAY", "CountOfElements",
"VariantGet", "VariantPut", "Assignment attempt", "MOVE_BLK_VARIANT", "Serialize", "Deserialize".
"""

from collections.abc import Callable

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


def _code(code: int) -> int:
    """An error code as the INT that RET_VAL is."""
    return code - 0x10000


def _run(program: LoadedProgram, block: str) -> BlockInstance:
    instance = program.instance(block)
    instance()
    return instance


def test_a_variant_says_which_type_it_refers_to(load: Load) -> None:
    asked = _run(load("ask.scl"), "Asked")
    assert asked["kinds"] == [1, 2, 3, 4, 5, 6, 7, 1]
    assert asked["same"] == [True, False, True, False]


def test_a_variant_counts_the_elements_of_an_array(load: Load) -> None:
    asked = _run(load("ask.scl"), "Asked")
    assert asked["counts"] == [6, 0, 10, 2]


def test_a_variant_is_compared_with_null(load: Load) -> None:
    assert _run(load("ask.scl"), "Asked")["isNull"] == [True, False]


def test_get_and_put_work_where_the_types_are_the_same(load: Load) -> None:
    program = load("access.scl")
    accessed = _run(program, "Accessed")
    assert accessed["point"] == {"x": 10, "y": 1.5}
    assert accessed["text"] == "abc"
    assert program.globals["Store"] == {"number": 42, "point": {"x": 0, "y": 0.0}}


def test_get_and_put_do_nothing_where_the_types_differ(load: Load) -> None:
    accessed = _run(load("access.scl"), "Accessed")
    assert accessed["other"] == 4
    assert accessed["longer"] == [1, 2, 3, 4]
    assert accessed["wide"] == "abcdef"


def test_eno_of_get_says_whether_the_types_are_the_same(load: Load) -> None:
    accessed = _run(load("access.scl"), "Accessed")
    assert accessed["done"] == [True, True, False, False, False, False, True, False]


def test_an_assignment_attempt_gives_a_reference_or_null(load: Load) -> None:
    accessed = _run(load("access.scl"), "Accessed")
    assert accessed["referred"] == [True, False]
    assert accessed["list"] == [1, 99, 6]


def test_a_variant_reaches_the_temporaries_of_its_caller(load: Load) -> None:
    assert load("access.scl").call("Locals", start=3) == 24


def test_a_function_block_keeps_what_its_variant_refers_to(load: Load) -> None:
    assert _run(load("access.scl"), "Accessed")["kept"] == 9


def test_move_blk_variant_counts_from_zero_on_both_sides(load: Load) -> None:
    moved = _run(load("moves.scl"), "Moved")
    assert moved["target"] == [0, 4, 5, 0]
    assert moved["single"] == 5
    assert moved["pairs"] == [{"a": 1, "b": [2, 3]}, {"a": 1, "b": [2, 3]}]


def test_move_blk_variant_reads_everything_before_it_writes(load: Load) -> None:
    assert _run(load("moves.scl"), "Moved")["source"] == [1, 1, 2, 3, 5]


def test_ret_val_of_move_blk_variant_names_the_parameter(load: Load) -> None:
    moved = _run(load("moves.scl"), "Moved")
    codes = (0x80B4, 0x8154, 0x8281, 0x8382, 0x8383, 0x8482, 0x8151)
    assert moved["results"] == [0, 0, 0, *map(_code, codes)]
    assert (moved["good"], moved["bad"]) == (True, False)


def test_serialize_lays_a_structure_out_as_a_standard_block_has_it(load: Load) -> None:
    packed = _run(load("moves.scl"), "Packed")
    record = [1, 0, 0x12, 0x34, 3, 2, ord("a"), ord("b"), 0, 0, 0xDE, 0xAD, 0xBE, 0xEF]
    assert packed["buffer"] == [*record, 1, 2, 0, 0, 0, 0]
    assert packed["copy"] == packed["record"]


def test_serialize_goes_on_behind_what_it_wrote(load: Load) -> None:
    packed = _run(load("moves.scl"), "Packed")
    assert packed["positions"] == [14, 16, 14, 18, 0, 0]


def test_ret_val_of_serialize_says_what_does_not_fit(load: Load) -> None:
    packed = _run(load("moves.scl"), "Packed")
    assert packed["results"] == [0, 0, 0, *map(_code, (0x8253, 0x8382, 0x8254))]


def test_a_variant_refers_to_parameters_and_the_result(load: Load) -> None:
    places = _run(load("places.scl"), "Places")
    assert (places["both"], places["output"], places["result"]) == (6, 4, 15)


def test_a_variant_refers_to_absolute_addresses(load: Load) -> None:
    places = _run(load("places.scl"), "Places")
    assert (places["marker"], places["bit"]) == (0x3412, True)


def test_a_variant_refers_to_variables_that_are_overlaid(load: Load) -> None:
    laid = _run(load("places.scl"), "Bytes")
    assert laid["number"] == 259
    assert laid["view"] == [1, 3]
    assert laid["words"] == [0x0002, 0x0403]
    assert laid["buffer"] == [0, 0, 1, 0, 0, 0, 2, 0]


def test_a_variant_is_an_area_for_instructions_on_bytes(load: Load) -> None:
    assert _run(load("places.scl"), "Places")["target"] == [0x0102, 0x0304]
