"""What the dialects allow: the differences between them, as data.

Sources: TIA Portal help, "Overview of data type conversion" and "Expressions" (IEC check on for
S7-1200/1500, off for S7-300/400); IEC 61131-3 third edition, figures 11 and 12 and section 6.6;
for BOOL on S7-300/400 the conversion functions of class A in the manual "S7-SCL"; TwinCAT 3 help,
"Type conversion operators" and "Compiler errors" C0195 to C0197.
"""

from dataclasses import replace
from functools import cache

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error


@dataclass(frozen=True, slots=True)
class Rules:
    """One dialect's rules for the checker.

    `iec_check`: bit strings and integers do not mix implicitly. `iec_check_open`: the text does not
    tell the setting, so what only the IEC check refuses is a warning. `narrows_unchecked`: without
    the IEC check a value becomes one of a narrower type too. `bit_string_arithmetic`: a bit string
    counts as the unsigned integer of its width. `statics_visible`: the static variables of an
    instance can be read from outside. `inputs_complete`: a call of a FUNCTION gives every input.
    `quoted_blocks`: an unquoted name in a call means the controller's own function first.
    `externals_required`: a block names the global variables it uses in VAR_EXTERNAL.
    `any_integer_to_real`: whole numbers of 32 bits become REAL by themselves.
    `outputs_by_assignment`: outputs of a FUNCTION may be given by `:=`. `shifts_integers`: SHL,
    SHR, ROL and ROR take integers too. `lowest_bit_is_bool`: X_TO_BOOL of an integer looks at its
    lowest bit only, else at the whole number. `labels_declared`: jump labels stand in a LABEL
    section. `enumerations_are_numbers`: an enumeration becomes its base by itself, and a number an
    enumeration with a warning. `bits_are_numbers`: a bit string becomes whatever the unsigned
    integer of its width becomes, and back. `sign_may_change`: an integer becomes one of the other
    sign that is not narrower, and LREAL becomes REAL, with a warning. `bool_is_bits`: BOOL becomes
    a bit string by itself. `mixed_arguments`: arguments without names may stand in front of those
    with names. `instances_behind_blocks`: a data block that is an instance is called behind the
    name of its block, FB10.DB20(...). `crossed_limits_pass`: LIMIT leaves IN alone where MN is
    above MX.
    """

    dialect: str
    iec_check: bool
    iec_check_open: bool
    narrows_unchecked: bool
    bit_string_arithmetic: bool
    statics_visible: bool
    inputs_complete: bool
    quoted_blocks: bool
    externals_required: bool
    any_integer_to_real: bool
    outputs_by_assignment: bool
    shifts_integers: bool
    lowest_bit_is_bool: bool
    labels_declared: bool
    enumerations_are_numbers: bool
    bits_are_numbers: bool
    sign_may_change: bool
    bool_is_bits: bool
    mixed_arguments: bool
    instances_behind_blocks: bool
    crossed_limits_pass: bool


_TIA = Rules(
    dialect="tia",
    iec_check=True,
    iec_check_open=True,
    narrows_unchecked=True,
    bit_string_arithmetic=True,
    statics_visible=True,
    inputs_complete=True,
    quoted_blocks=True,
    externals_required=False,
    any_integer_to_real=True,
    outputs_by_assignment=False,
    shifts_integers=True,
    lowest_bit_is_bool=True,
    labels_declared=False,
    enumerations_are_numbers=False,
    bits_are_numbers=False,
    sign_may_change=False,
    bool_is_bits=False,
    mixed_arguments=False,
    instances_behind_blocks=False,
    crossed_limits_pass=True,
)
_STEP7 = Rules(
    dialect="step7",
    iec_check=False,
    iec_check_open=False,
    narrows_unchecked=False,
    bit_string_arithmetic=True,
    statics_visible=True,
    inputs_complete=True,
    quoted_blocks=False,
    externals_required=False,
    any_integer_to_real=True,
    outputs_by_assignment=True,
    shifts_integers=True,
    lowest_bit_is_bool=True,
    labels_declared=True,
    enumerations_are_numbers=False,
    bits_are_numbers=False,
    sign_may_change=False,
    bool_is_bits=True,
    mixed_arguments=False,
    instances_behind_blocks=True,
    crossed_limits_pass=False,
)
_IEC = Rules(
    dialect="iec",
    iec_check=True,
    iec_check_open=False,
    narrows_unchecked=False,
    bit_string_arithmetic=False,
    statics_visible=False,
    inputs_complete=False,
    quoted_blocks=False,
    externals_required=True,
    any_integer_to_real=False,
    outputs_by_assignment=False,
    shifts_integers=False,
    lowest_bit_is_bool=False,
    labels_declared=False,
    enumerations_are_numbers=False,
    bits_are_numbers=False,
    sign_may_change=False,
    bool_is_bits=False,
    mixed_arguments=True,
    instances_behind_blocks=False,
    crossed_limits_pass=False,
)
_TWINCAT = Rules(
    dialect="twincat",
    iec_check=True,
    iec_check_open=False,
    narrows_unchecked=False,
    bit_string_arithmetic=True,
    statics_visible=True,
    inputs_complete=False,
    quoted_blocks=False,
    externals_required=False,
    any_integer_to_real=True,
    outputs_by_assignment=False,
    shifts_integers=True,
    lowest_bit_is_bool=False,
    labels_declared=False,
    enumerations_are_numbers=True,
    bits_are_numbers=True,
    sign_may_change=True,
    bool_is_bits=False,
    mixed_arguments=True,
    instances_behind_blocks=False,
    crossed_limits_pass=False,
)

RULES = {rules.dialect: rules for rules in (_TIA, _STEP7, _IEC, _TWINCAT)}
"""By the name of the dialect."""


@cache
def without_iec_check(rules: Rules) -> Rules:
    """The same rules with the IEC check off."""
    return replace(rules, iec_check=False, iec_check_open=False)


def rules_for(dialect: str) -> Rules:
    """The rules of a dialect; raises FB4000 for a name that is none."""
    if dialect not in RULES:
        raise error(
            "FB4000", f"there is no dialect '{dialect}'", None, f"known: {', '.join(sorted(RULES))}"
        )
    return RULES[dialect]
