"""What to do about operands that an operator does not take."""

from fbgen.lang.checker.types import folding
from fbgen.lang.checker.types.conversions import UNSIGNED_OF
from fbgen.lang.types import BOOL, Elementary, Enumeration, Family, ReferenceType, Type

IN_CODESYS = "CODESYS and TwinCAT do it by themselves: --dialect twincat"
_COUNTS = (Family.SIGNED, Family.UNSIGNED, Family.BITS)


def operator_help(operator: str, left: Type, right: Type, both_typed: bool) -> str:
    """How to mend an operation on these types; `both_typed`: no side is a plain constant."""
    if operator in folding.SHORT_CIRCUIT:
        return f"{operator} takes BOOLs only; compare numbers first: x <> 0"
    for kind in (left, right):
        if isinstance(kind, ReferenceType):
            return "references are compared by = and <>; use an ARRAY and an index to step on"
        if isinstance(kind, Enumeration):
            number = f"TO_{kind.base.name}(x)"
            return f"compare its own enumerators by = and <>; {number} is the number behind it"
    if operator in folding.LOGIC:
        return f"{operator} takes BOOLs or bit strings; convert integers: INT_TO_WORD(x)"
    if BOOL in (left, right) and operator in folding.COMPARISONS:
        return "a BOOL can be compared with a BOOL by = and <> only"
    if (
        both_typed
        and left != right
        and isinstance(left, Elementary)
        and isinstance(right, Elementary)
        and left.family in _COUNTS
        and right.family in _COUNTS
    ):
        return f"convert one side: {left.name}_TO_{right.name}(...)"
    for kind in (left, right):
        if isinstance(kind, Elementary) and kind in UNSIGNED_OF:
            return f"convert it for the calculation: {kind.name}_TO_{UNSIGNED_OF[kind].name}(...)"
    if operator in ("MOD", "DIV"):
        return f"{operator} takes integers"
    return "bring both sides to one type with a conversion function"


def counts_in_codesys(kind: Type) -> bool:
    """True for numbers, and for what CODESYS and TwinCAT calculate with as with numbers."""
    return isinstance(kind, Elementary) and (kind.family in _COUNTS or kind.family is Family.REAL)
