"""X_TO_BOOL, which asks for the lowest bit in one dialect and for any number but 0 in another.

Which dialect does what stands in the checker's rules. Where two differ, the conversion says what
the first one means: `INT_TO_BOOL(n)` of `tia` becomes `(n MOD 2 <> 0)`, that of `iec` `(n <> 0)`.
TO_BOOL does not tell the type, so it is refused.
"""

from fbgen.lang.ast import Binary, Call, Expression, Name, Parenthesized, Unary
from fbgen.lang.checker import RULES
from fbgen.lang.checker.types.conversions import elementary_named
from fbgen.lang.lowering.build import binary, bits, integer
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.types import INT, WORD, Elementary, Family

_SUFFIX = "_TO_BOOL"
_KINDS = (INT, WORD)
"""One of each kind that dialects treat alike."""
_COUNTED = (Family.BITS, Family.SIGNED, Family.UNSIGNED)


def same_truth(call: Call, source: str, target: str, findings: Findings) -> Expression:
    """What a call of a standard function in dialect `source` is in dialect `target`."""
    if isinstance(call.callee, Name) and call.callee.name.upper() == "TO_BOOL":
        if any(_number_decides(kind, source) != _number_decides(kind, target) for kind in _KINDS):
            hint = "name the type of what it converts: INT_TO_BOOL, WORD_TO_BOOL"
            findings.refuse("TO_BOOL, which means something else there,", call.span, hint)
        return call
    kind = _asked(call)
    operand = call.arguments[0].value if len(call.arguments) == 1 else None
    if kind is None or operand is None:
        return call
    was, becomes = _number_decides(kind, source), _number_decides(kind, target)
    if was == becomes:
        return call
    span = call.span
    if isinstance(operand, Binary | Unary):
        operand = Parenthesized(operand.span, operand)
    if kind.family is not Family.BITS:
        asked = operand if was else Binary(span, "MOD", operand, integer(span, 2))
        return binary(span, "<>", asked, integer(span, 0))
    if becomes:
        operand = binary(span, "AND", operand, bits(span, kind.name, 1, kind.bits))
    return binary(span, "<>", operand, bits(span, kind.name, 0, kind.bits))


def _asked(call: Call) -> Elementary | None:
    """The whole number or bit string that a call makes a BOOL of."""
    name = call.callee.name.upper() if isinstance(call.callee, Name) else ""
    kind = elementary_named(name.removesuffix(_SUFFIX)) if name.endswith(_SUFFIX) else None
    return kind if isinstance(kind, Elementary) and kind.family in _COUNTED else None


def _number_decides(kind: Elementary, dialect: str) -> bool:
    """Whether any number but 0 becomes TRUE."""
    rules = RULES[dialect]
    counts = kind.family is not Family.BITS or rules.bits_are_numbers
    return counts and not rules.lowest_bit_is_bool
