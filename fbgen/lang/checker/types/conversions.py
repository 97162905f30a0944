"""Which type becomes which other: by itself, or by a conversion somebody writes.

What a `Convert` does, for each pair of families (both engines follow this table):

* integer or bit string to integer or bit string: the low bits of the two's complement, signed
  sources sign-extended. BOOL gives 0 or 1; to BOOL: the lowest bit.
* REAL, LREAL to integer, bit string or duration: rounded (to nearest, ties to even, or cut); what
  does not fit, infinite and not-a-number stop the program (FB6006). Exceptions: REAL to DWORD and
  LREAL to LWORD, and back, copy the 32 or 64 bits unchanged. Integer to REAL: the nearest number,
  rounded once. REAL to LREAL: the same.
* TIME counts milliseconds, LTIME nanoseconds: to and from a number as that count; TIME to LTIME
  times 1,000,000, back divided and cut towards zero. TIME_OF_DAY counts milliseconds,
  LTIME_OF_DAY nanoseconds: numbers likewise, and what `fbgen.lang.dates` says of dates.
* DATE_AND_TIME and LDT to DATE, LDATE, TIME_OF_DAY, LTIME_OF_DAY: the part. LDATE to DATE, and
  what counts seconds to what counts nanoseconds and back: the same instant.
* DTL to LDT: the instant, whatever the WEEKDAY; parts that are no date stop the program (FB6032).
  LDT to DTL: its parts.
* CHAR and WCHAR to a number: the code; back: the character. CHAR to STRING: that one character.
  STRING to a shorter STRING: cut; WSTRING to STRING: characters above 255 become `?`.

By itself a value widens within its family. BOOL converts by itself in `step7` only: IEC 61131-3
would let it become a bit string, TIA Portal does not, and text that means to be portable should
not depend on it. DINT becomes REAL by itself on S7 although REAL holds only 24 bits. Without the
IEC check, bit strings and integers mix as long as nothing gets narrower, and a bit string becomes
a time, date or character of the same width; an assignment on S7-1200/1500 narrows, too, and rounds
REAL to whole numbers. In `twincat` a bit string is an unsigned integer in all this, and the sign
may change with a warning.

Sources: IEC 61131-3 third edition, section 6.6.2.5.2 and figures 11 and 12; TIA Portal help,
"Implicit conversion of BYTE" to "of WSTRING", "Activate or deactivate IEC check"; the rules of
the other dialects: see `rules`; ties to even: conformance rule of the project for all dialects.
"""

from functools import cache

from fbgen.lang.checker.rules import RULES, Rules, without_iec_check
from fbgen.lang.dates import STAMPS
from fbgen.lang.types import (
    ALIASES,
    BOOL,
    BYTE,
    CHAR,
    DATE,
    DATE_AND_TIME,
    DINT,
    DTL,
    DWORD,
    ELEMENTARY,
    INT,
    LDATE,
    LDT,
    LINT,
    LREAL,
    LTIME,
    LTIME_OF_DAY,
    LWORD,
    NUMBER_TYPES,
    PC_DATE,
    PC_DATE_AND_TIME,
    REAL,
    S5TIME,
    SINT,
    TIME,
    TIME_OF_DAY,
    UDINT,
    UINT,
    ULINT,
    USINT,
    WCHAR,
    WORD,
    Elementary,
    Enumeration,
    Family,
    StringType,
    StructType,
    Subrange,
    Type,
    counting_type,
)

_WIDENING: dict[Elementary, tuple[Elementary, ...]] = {
    SINT: (INT, DINT, LINT, REAL, LREAL),
    INT: (DINT, LINT, REAL, LREAL),
    DINT: (LINT, LREAL),
    USINT: (UINT, UDINT, ULINT, INT, DINT, LINT, REAL, LREAL),
    UINT: (UDINT, ULINT, DINT, LINT, REAL, LREAL),
    UDINT: (ULINT, LINT, LREAL),
    REAL: (LREAL,),
    BYTE: (WORD, DWORD, LWORD),
    WORD: (DWORD, LWORD),
    DWORD: (LWORD,),
    TIME: (LTIME,),
    TIME_OF_DAY: (LTIME_OF_DAY,),
    DATE_AND_TIME: (LDT,),
    PC_DATE_AND_TIME: (LDT,),
    PC_DATE: (LDATE,),
}
_INTEGERS = (SINT, USINT, INT, UINT, DINT, UDINT, LINT, ULINT)
_BITS = (BYTE, WORD, DWORD, LWORD)
_ASCENDING = (*_INTEGERS, REAL, LREAL, *_BITS, TIME, LTIME)
_COUNTS = (Family.SIGNED, Family.UNSIGNED, Family.BITS)
_SAME_WIDTH = (CHAR, DATE, TIME, TIME_OF_DAY)
"""What a bit string of the same width becomes without the IEC check."""
_COUNTED = (DATE, TIME, TIME_OF_DAY, LTIME, LTIME_OF_DAY, LDT)
"""What becomes a whole number of the same width, and back, without the IEC check."""
_SHORTENED = (
    (LREAL, REAL),
    (LTIME, TIME),
    (LTIME_OF_DAY, TIME_OF_DAY),
    (LDT, DATE_AND_TIME),
    (DTL, DATE_AND_TIME),
)
_STAMPS = ((DATE_AND_TIME, DTL), (LDT, DTL), (DTL, LDT))
"""What TIA Portal converts always."""
UNSIGNED_OF = {BYTE: USINT, WORD: UINT, DWORD: UDINT, LWORD: ULINT}
"""The integer that a bit string acts as in a calculation."""
SIGNED_OF = {USINT: SINT, UINT: INT, UDINT: DINT, ULINT: LINT}
"""The signed integer of the same width."""


@cache
def _implicit(source: Elementary, target: Elementary, rules: Rules) -> bool:
    if isinstance(target, Enumeration | Subrange):
        return False
    if isinstance(source, Enumeration):
        mixes = rules.enumerations_are_numbers
        return mixes and (source.base == target or _implicit(source.base, target, rules))
    if isinstance(source, Subrange):
        return source.base == target or _implicit(source.base, target, rules)
    if target in _WIDENING.get(source, ()):
        return True
    if rules.any_integer_to_real and source.is_integer and target == REAL:
        return source.bits <= 32
    if rules.bool_is_bits and source == BOOL:
        return target in (BYTE, WORD, DWORD)
    if rules.bits_are_numbers and (source in UNSIGNED_OF or target in UNSIGNED_OF):
        source, target = UNSIGNED_OF.get(source, source), UNSIGNED_OF.get(target, target)
        return source == target or _implicit(source, target, rules)
    return not rules.iec_check and S5TIME not in (source, target) and _mixes(source, target)


def _mixes(source: Elementary, target: Elementary) -> bool:
    """Without the IEC check."""
    if source in _BITS and target in _SAME_WIDTH:
        return source.bits == target.bits
    return (
        source.family in _COUNTS
        and target.family in _COUNTS
        and Family.BITS in (source.family, target.family)
        and source.bits <= target.bits
    )


def changes_sign(source: Type, target: Type, rules: Rules) -> bool:
    """True for what converts by itself only with a warning."""
    if not rules.sign_may_change or isinstance(target, Enumeration | Subrange):
        return False
    if not isinstance(source, Elementary) or not isinstance(target, Elementary):
        return False
    source = counting_type(source) if isinstance(source, Enumeration | Subrange) else source
    if (source, target) == (LREAL, REAL):
        return True
    pair = (UNSIGNED_OF.get(source, source), UNSIGNED_OF.get(target, target))
    signs = {kind.family for kind in pair}
    return signs == {Family.SIGNED, Family.UNSIGNED} and source.bits <= target.bits


def converts_in_codesys(source: Type, target: Type) -> bool:
    """True for what CODESYS and TwinCAT convert by themselves, be it with a warning."""
    rules = RULES["twincat"]
    return is_implicit(source, target, rules) or changes_sign(source, target, rules)


def is_implicit(source: Type, target: Type, rules: Rules) -> bool:
    """True if a value of `source` becomes `target` in an assignment without anybody writing it."""
    if widens(source, target, rules) or (rules.dialect == "tia" and (source, target) in _STAMPS):
        return True
    return not rules.iec_check and rules.narrows_unchecked and _is_unchecked(source, target)


def _is_unchecked(source: Type, target: Type) -> bool:
    """What TIA Portal converts without the IEC check only, losing digits where they do not fit.

    DWORD to REAL and LWORD to LREAL are left out: the help contradicts itself on their value.
    """
    if (source, target) in _SHORTENED:
        return True
    if not isinstance(source, Elementary) or not isinstance(target, Elementary):
        return False
    if isinstance(source, Enumeration | Subrange) or isinstance(target, Enumeration | Subrange):
        return False
    if source.family in _COUNTS:
        return (
            target.family in (*_COUNTS, Family.CHAR)
            or (target.family is Family.REAL and source.is_integer)
            or (target in _COUNTED and source.bits == target.bits)
            or (source, target) == (WORD, S5TIME)
        )
    if target.family in _COUNTS:
        counted = source in _COUNTED and source.bits == target.bits
        copied = (source, target) in ((REAL, DWORD), (LREAL, LWORD), (S5TIME, WORD))
        rounded = source.family is Family.REAL and target.is_integer
        return counted or copied or rounded or source.family is Family.CHAR
    return False


def is_likely_unchecked(source: Type, target: Type, rules: Rules) -> bool:
    """True if the text most likely relies on the IEC check being off.

    REAL to a whole number is left out: nobody rounds without saying so.
    """
    rounds = isinstance(source, Elementary) and source.family is Family.REAL
    if rounds and isinstance(target, Elementary) and target.is_integer:
        return False
    return is_implicit(source, target, without_iec_check(rules))


def widens(source: Type, target: Type, rules: Rules) -> bool:
    """True if a value of `source` becomes `target` by itself, also in a calculation."""
    if isinstance(source, Elementary) and isinstance(target, Elementary):
        return source == target or _implicit(source, target, rules)
    if isinstance(target, StringType):
        if isinstance(source, StringType):
            return source.wide == target.wide
        return source == (WCHAR if target.wide else CHAR)
    return source == target


def common_type(left: Type, right: Type, rules: Rules) -> Type | None:
    """The smallest type that both become by themselves; None if there is none."""
    if left != right:
        left, right = _limitless(left), _limitless(right)
    if left == right or widens(right, left, rules):
        return left
    if widens(left, right, rules):
        return right
    if isinstance(left, Elementary) and isinstance(right, Elementary):
        for kind in _ASCENDING:
            if _implicit(left, kind, rules) and _implicit(right, kind, rules):
                return kind
    return None


def _limitless(kind: Type) -> Type:
    """The base of a subrange."""
    return kind.base if isinstance(kind, Subrange) else kind


def wider_types(kind: Elementary, rules: Rules) -> tuple[Elementary, ...]:
    """What `kind` becomes by itself, the smallest first."""
    return tuple(wider for wider in _ASCENDING if wider != kind and _implicit(kind, wider, rules))


def keeps_representation(source: Type, target: Type) -> bool:
    """True if every value of `source` is the same run-time value in `target`."""
    if source == target:
        return True
    if isinstance(source, Subrange):
        return keeps_representation(source.base, target)
    if not isinstance(source, Elementary) or target not in _WIDENING.get(source, ()):
        return False
    return isinstance(target, Elementary) and (
        source == REAL or (source.family in _COUNTS and target.family in _COUNTS)
    )


def fits_place(source: Type, place: Type, rules: Rules) -> bool:
    """True if an output of a block can be given to that place as it is."""
    if keeps_representation(source, place):
        return True
    if not isinstance(source, Elementary) or not isinstance(place, Elementary):
        return False
    counts = source.family in _COUNTS and place.family in _COUNTS
    return counts and rules.bits_are_numbers and _implicit(source, place, rules)


@cache
def is_convertible(source: Type, target: Type) -> bool:
    """True if a written conversion from `source` to `target` exists as a `Convert`."""
    if isinstance(source, StringType) and isinstance(target, StringType):
        return True
    if isinstance(target, StringType):
        return source == (WCHAR if target.wide else CHAR)
    if DTL in (source, target):
        partner = target if source == DTL else source
        return partner in (DTL, LDT, DATE_AND_TIME, DATE) or (
            source == DTL and partner in (TIME_OF_DAY, LTIME_OF_DAY)
        )
    if not isinstance(source, Elementary) or not isinstance(target, Elementary):
        return False
    if source == target:
        return source.family is not Family.VOID
    if S5TIME in (source, target):
        return {source.family, target.family} == {Family.BITS}
    pair = (source.family, target.family)
    if Family.VOID in pair:
        return False
    if Family.DATE in pair and Family.DATE == source.family == target.family:
        times = (TIME_OF_DAY, LTIME_OF_DAY)
        if source in times:
            return target in times
        return source in STAMPS or target not in times
    plain = (*_COUNTS, Family.BOOL, Family.REAL)
    if source.family in plain and target.family in plain:
        return pair not in ((Family.BOOL, Family.REAL), (Family.REAL, Family.BOOL))
    counted = (*_COUNTS, Family.DATE, Family.CHAR)
    if Family.DURATION in pair:
        other = target.family if source.family is Family.DURATION else source.family
        return other in (*_COUNTS, Family.DURATION, Family.REAL)
    if Family.CHAR in pair and pair[0] is not pair[1]:
        return pair[0] in (*_COUNTS, Family.CHAR) and pair[1] in (*_COUNTS, Family.CHAR)
    return source.family in counted and target.family in counted


def elementary_named(name: str) -> Elementary | StringType | StructType | None:
    """The elementary type, string type or DTL of that name in a conversion; None for others."""
    key = name.upper()
    key = ALIASES.get(key, key)
    if key in ("STRING", "WSTRING"):
        return StringType(wide=key == "WSTRING")
    if key == "DTL":
        return DTL
    if key in ("BLOCK_DB", "DB_ANY"):
        return NUMBER_TYPES[key]
    kind = ELEMENTARY.get(key)
    return kind if kind is not None and kind.family is not Family.VOID else None


def conversion_between(source: Type, target: Type) -> str:
    """The name of the function that converts, for a help text; empty if there is none."""
    if isinstance(source, Elementary) and isinstance(target, Elementary):
        if isinstance(target, Enumeration):
            return ""
        if isinstance(source, Enumeration):
            return f"TO_{counting_type(target).name}"
        source, target = counting_type(source), counting_type(target)
        if is_convertible(source, target):
            return f"{source.name}_TO_{target.name}"
        if source.family is Family.BOOL or target.family is Family.BOOL:
            return ""
    elif DTL in (source, target) and is_convertible(source, target):
        return f"{source.name}_TO_{target.name}"
    return ""
