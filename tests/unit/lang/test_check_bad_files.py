"""Each broken file gives its code at its place, and the page of the code shows the way out."""

import re
from pathlib import Path

import pytest
from checking import findings_of, hints_of

from fbgen.diagnostics import Severity
from fbgen.resources import shipped

_BAD = Path(__file__).parent.parent / "bad"
_DIALECTS = {"scl": "tia", "st": "iec", "step7": "step7", "twincat": "twincat"}
_BLOCK = re.compile(r"```(scl|st|step7|twincat)\n(.*?)```", re.DOTALL)
_PAGES = sorted(path.stem for path in shipped("diagnostics").glob("FB4*.md"))
_WITHOUT_WHOLE_TEXT = ("FB4000", "FB4053", "FB4062", "FB4301", "FB4302", "FB4303")


def _dialect_of(path: Path) -> str:
    """`name.scl` is `tia`, `name.st` is `iec`, `name.step7.scl` says it itself."""
    return _DIALECTS[(path.suffixes[-2:-1] or path.suffixes)[0][1:]]


@pytest.mark.parametrize(
    ("name", "line", "column"),
    [
        ("FB4001_unknown_name.scl", 5, 13),
        ("FB4002_declared_twice.st", 4, 3),
        ("FB4003_unknown_type.st", 2, 13),
        ("FB4004_unknown_function.scl", 4, 14),
        ("FB4005_unknown_member.scl", 9, 3),
        ("FB4006_unknown_parameter.st", 3, 7),
        ("FB4010_type_mismatch.scl", 7, 13),
        ("FB4011_needs_conversion.scl", 7, 11),
        ("FB4012_operator_types.st", 6, 9),
        ("FB4013_condition.st", 3, 4),
        ("FB4014_out_of_range.st", 3, 10),
        ("FB4015_index_out_of_bounds.st", 3, 7),
        ("FB4016_division_by_zero.st", 3, 10),
        ("FB4017_not_constant.st", 7, 3),
        ("FB4018_slice.scl", 7, 11),
        ("FB4019_index.st", 3, 1),
        ("FB4020_constant_written.scl", 6, 3),
        ("FB4022_not_a_variable.st", 10, 18),
        ("FB4023_not_writable.st", 4, 1),
        ("FB4030_case_overlap.st", 5, 3),
        ("FB4031_case_selector.st", 3, 6),
        ("FB4032_case_empty_range.st", 4, 3),
        ("FB4033_for_variable.st", 6, 5),
        ("FB4034_exit_outside_loop.st", 4, 3),
        ("FB4035_for_step_zero.st", 3, 20),
        ("FB4040_missing_argument.scl", 12, 13),
        ("FB4041_argument_direction.st", 6, 31),
        ("FB4042_too_many_arguments.st", 3, 22),
        ("FB4043_argument_twice.st", 3, 31),
        ("FB4044_mixed_arguments.st", 3, 10),
        ("FB4045_block_without_instance.st", 3, 9),
        ("FB4046_function_as_type.st", 6, 18),
        ("FB4047_not_callable.st", 3, 1),
        ("FB4048_no_result.scl", 9, 14),
        ("FB4049_result_unused.st", 3, 1),
        ("FB4050_contains_itself.st", 4, 12),
        ("FB4051_recursive_call.st", 6, 20),
        ("FB4052_array_too_large.st", 2, 11),
        ("FB4054_not_supported.twincat", 6, 16),
        ("FB4054_jump_in_finally.twincat", 6, 5),
        ("FB4010_exception_variable.twincat", 5, 9),
        ("FB4055_bounds.st", 2, 19),
        ("FB4056_wrong_section.scl", 3, 3),
        ("FB4057_initial_value.st", 2, 36),
        ("FB4058_inner_variable.st", 12, 8),
        ("FB4059_constant_without_value.st", 2, 14),
        ("FB4060_unknown_task.st", 8, 5),
        ("FB4061_task_property.st", 7, 25),
        ("FB4061_single.st", 8, 5),
        ("FB4080_label_twice.scl", 6, 1),
        ("FB4081_unknown_label.scl", 6, 18),
        ("FB4082_into_loop.scl", 4, 18),
        ("FB4083_label_not_declared.step7.scl", 6, 1),
        ("FB4084_enable_inside.scl", 10, 20),
        ("FB4085_internal_function.st", 9, 8),
        ("FB4085_private_variable.st", 8, 8),
        ("FB4096_unknown_namespace.st", 9, 1),
        ("FB4098_lone_method.st", 3, 8),
        ("FB4042_generic_constants.twincat", 8, 11),
        ("FB4097_two_namespaces.st", 16, 8),
        ("FB4110_number_for_enumerator.twincat", 6, 10),
        ("FB4111_sign.twincat", 4, 8),
        ("FB4112_unchecked.scl", 6, 13),
        ("FB4092_not_a_reference.scl", 6, 3),
        ("FB4093_reference_to_temporary.scl", 5, 17),
        ("FB4094_no_type.scl", 3, 31),
        ("FB4095_variant_in_static.scl", 3, 12),
        ("FB4090_ambiguous_enumerator.st", 7, 18),
        ("FB4091_open_array.scl", 3, 19),
        ("FB4085_private_method.st", 12, 6),
        ("FB4086_other_parameters.st", 10, 15),
        ("FB4087_no_base.st", 1, 34),
        ("FB4088_not_implemented.st", 8, 16),
        ("FB4089_abstract_instance.st", 14, 13),
        ("FB4070_address.st", 2, 5),
        ("FB4071_overlay_too_large.scl", 5, 12),
        ("FB4072_unknown_area.scl", 3, 26),
        ("FB4073_optimized_block.scl", 8, 3),
        ("FB4074_timer_in_union.st", 2, 3),
        ("FB4075_no_element.scl", 4, 18),
        ("FB4101_unused.st", 4, 3),
        ("FB4102_result_not_set.st", 1, 10),
        ("FB4103_own_input_changed.scl", 4, 3),
        ("FB4104_external_missing.st", 5, 1),
        ("FB4105_fraction_lost.st", 3, 8),
        ("FB4106_instance_written.scl", 4, 3),
        ("FB4201_parameter_unused.scl", 4, 3),
        ("FB4202_output_not_written.scl", 7, 3),
        ("FB4203_never_read.scl", 12, 3),
        ("FB4204_result_not_on_every_path.scl", 1, 10),
        ("FB4205_never_written.scl", 6, 3),
        ("FB4206_read_before_set.scl", 9, 11),
        ("FB4207_not_set_on_every_path.scl", 15, 14),
        ("FB4208_label_unused.scl", 13, 3),
        ("FB4210_unreachable.scl", 11, 3),
        ("FB4211_constant_condition.scl", 10, 6),
        ("FB4212_condition_twice.scl", 11, 9),
        ("FB4213_endless_loop.scl", 10, 9),
        ("FB4214_counter_written.scl", 16, 7),
        ("FB4215_division_cuts.scl", 10, 15),
        ("FB4216_case_leaves_names_out.st", 10, 6),
        ("FB4220_conditional_call.scl", 13, 5),
        ("FB4221_called_twice.scl", 14, 3),
        ("FB4222_never_called.scl", 9, 11),
        ("FB4223_two_callers.scl", 23, 3),
        ("FB4224_two_writers.scl", 7, 3),
        ("FB4225_resets_itself.scl", 9, 21),
        ("FB4226_two_kinds.scl", 14, 3),
        ("FB4230_real_equality.scl", 9, 15),
        ("FB4231_range_comparison.scl", 9, 11),
        ("FB4232_same_operands.scl", 10, 13),
        ("FB4233_self_assignment.scl", 12, 3),
        ("FB4234_pointless_call.scl", 16, 3),
        ("FB4235_answer_dropped.scl", 20, 3),
        ("FB4240_hides_global.st", 7, 3),
        ("FB4241_name_too_long.st", 3, 3),
        ("FB4242_other_capitals.st", 5, 11),
        ("FB4243_word_of_another_dialect.st", 3, 3),
        ("FB4290_allow_unknown_code.scl", 9, 21),
        ("FB4291_allow_without_finding.scl", 9, 3),
        ("FB4292_allow_error.scl", 9, 21),
        ("FB4140_without_model.scl", 7, 15),
        ("FB4143_unknown_hardware_parameter.scl", 4, 35),
        ("FB4141_not_modelled.scl", 3, 11),
        ("FB4142_new.st", 3, 11),
    ],
)
def test_broken_file_is_reported_at_its_place(name: str, line: int, column: int) -> None:
    path = _BAD / name
    dialect = _dialect_of(path)
    found = findings_of(path.read_text(encoding="utf-8"), dialect, name)
    worst = [one for one in found if one.severity is Severity.ERROR] or found
    worst = worst or hints_of(path.read_text(encoding="utf-8"), dialect, name)
    assert [(one.code, one.span and (one.span.line, one.span.column)) for one in worst] == [
        (name[:6], (line, column))
    ]
    assert worst[0].help


@pytest.mark.parametrize("code", [page for page in _PAGES if page not in _WITHOUT_WHOLE_TEXT])
def test_page_shows_a_failing_and_a_fixed_example(code: str) -> None:
    text = (shipped("diagnostics") / f"{code}.md").read_text(encoding="utf-8")
    assert text.startswith(f"# {code}: ")
    (bad_name, bad), (good_name, good) = _BLOCK.findall(text)
    found = [*findings_of(bad, _DIALECTS[bad_name]), *hints_of(bad, _DIALECTS[bad_name])]
    assert code in {one.code for one in found}
    left = [*findings_of(good, _DIALECTS[good_name]), *hints_of(good, _DIALECTS[good_name])]
    assert [one for one in left if one.severity is Severity.ERROR or one.code == code] == []
