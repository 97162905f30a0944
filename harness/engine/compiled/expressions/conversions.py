"""Changes of type. What each pair does stands in `fbgen.lang.checker.types.conversions`."""

from fbgen.lang.checked import Convert
from fbgen.lang.types import (
    BOOL,
    DWORD,
    LREAL,
    LTIME,
    LTIME_OF_DAY,
    LWORD,
    REAL,
    TIME,
    TIME_OF_DAY,
    WCHAR,
    Elementary,
    Family,
    StringType,
    StructType,
    Subrange,
    Type,
)
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.expressions.instants import count, instant
from harness.engine.compiled.library.dates import COUNTS, NS_PER_DAY, NS_PER_MS
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import is_counted, limits, masked, wrapped

_EXACT_IN_REAL = 1 << 24
_EXACT_IN_LREAL = 1 << 53
_BIT_COPIES = {
    (REAL, DWORD): "_bits_of_real",
    (DWORD, REAL): "_real_of_bits",
    (LREAL, LWORD): "_bits_of_long_real",
    (LWORD, LREAL): "_long_real_of_bits",
}
_TO_NANOSECONDS = ((TIME, LTIME), (TIME_OF_DAY, LTIME_OF_DAY))


def _call(function: str, code: Code, kind: Type, *more: object) -> Code:
    low, high = limits(kind)
    texts = ", ".join((code.text, *(str(one) for one in more)))
    return code._replace(
        text=f"{function}({texts})",
        level=Level.ATOM,
        low=low,
        high=high,
        depth=code.depth + 1,
        simple=False,
    )


def convert(procedure: Procedure, node: Convert, operand: Code) -> Code:
    """The operand in the type of the conversion; a whole number may still have to be wrapped."""
    source, target = node.operand.type, node.type
    if isinstance(source, StructType):
        result = _call("_stamp_of_dtl", operand, target)._replace(safe=False)
        procedure.site(result.text, node)
        return result
    if isinstance(target, StructType):
        make = procedure.context.model.record_of(target).class_name
        operand = _in_range(procedure, operand, source)
        return operand._replace(
            text=f"_dtl({make}, {operand.text})",
            level=Level.ATOM,
            depth=operand.depth + 1,
            simple=False,
        )
    if isinstance(target, Subrange):
        return _limited(procedure, node, operand, target)
    if isinstance(source, StringType) or isinstance(target, StringType):
        return _text(operand, source, target)
    assert isinstance(source, Elementary)
    assert isinstance(target, Elementary)
    if source == target:
        return operand
    if function := _BIT_COPIES.get((source, target)):
        return _call(function, _in_range(procedure, operand, source), target)
    if source.family is Family.REAL:
        return _from_real(procedure, node, operand)
    if target.family is Family.REAL:
        return _to_real(_in_range(procedure, operand, source), target)
    if Family.CHAR in (source.family, target.family):
        return _character(operand, source, target)
    if source == BOOL:
        return operand._replace(
            text=f"+{operand.at(Level.SIGN)}",
            level=Level.SIGN,
            low=0,
            high=1,
            depth=operand.depth + 1,
            simple=False,
        )
    if target == BOOL:
        return operand._replace(
            text=f"{operand.at(Level.BIT_AND)} & 1 == 1",
            level=Level.COMPARISON,
            low=0,
            high=0,
            depth=operand.depth + 1,
            simple=False,
        )
    return _counted(procedure, operand, source, target)


def _limited(procedure: Procedure, node: Convert, operand: Code, target: Subrange) -> Code:
    """A whole number in the limits of a subrange; the type is checked where it can be left."""
    code = operand
    if node.operand.type != target:
        in_base = Convert(node.span, node.operand, target.base, node.implicit, node.rounding)
        code = convert(procedure, in_base, operand)
    code = _in_range(procedure, code, target.base)
    low, high = target.lowest, target.highest
    if low <= code.low and code.high <= high:
        return code
    text = f"_limited({code.text}, {low}, {high})"
    procedure.site(text, node)
    return code._replace(
        text=text,
        level=Level.ATOM,
        low=low,
        high=high,
        depth=code.depth + 1,
        safe=False,
        simple=False,
    )


def _in_range(procedure: Procedure, code: Code, kind: Type) -> Code:
    if is_counted(kind):
        assert isinstance(kind, Elementary)
        return wrapped(code, kind, procedure.temporary)
    return code


def _counted(procedure: Procedure, code: Code, source: Elementary, target: Elementary) -> Code:
    if (source, target) in _TO_NANOSECONDS:
        code = _in_range(procedure, code, source)
        return code._replace(
            text=f"{code.at(Level.PRODUCT)} * {NS_PER_MS}",
            level=Level.PRODUCT,
            low=code.low * NS_PER_MS,
            high=code.high * NS_PER_MS,
            depth=code.depth + 1,
            simple=False,
        )
    if (target, source) in _TO_NANOSECONDS:
        code = _in_range(procedure, code, source)
        largest = max(abs(code.low), abs(code.high)) // NS_PER_MS
        low = -largest if source.is_signed else 0
        return _call("_cut_to_ms", code, source)._replace(low=low, high=largest)
    if source in COUNTS and target.family is Family.DATE:
        return _part_of(instant(_in_range(procedure, code, source), source), target)
    if source.bits < target.bits:
        return _in_range(procedure, code, source)
    # Going to a narrower type, only the low bits count, so nothing is wrapped before.
    return code


def _part_of(code: Code, target: Elementary) -> Code:
    """A date, or the time of day, out of an instant."""
    if target in COUNTS:
        return count(code, target)
    text = f"{code.at(Level.PRODUCT)} % {NS_PER_DAY}"
    low, high = 0, NS_PER_DAY - 1
    if target == TIME_OF_DAY:
        text = f"{text} // {NS_PER_MS}"
        high //= NS_PER_MS
    return code._replace(
        text=text, level=Level.PRODUCT, low=low, high=high, depth=code.depth + 2, simple=False
    )


def _from_real(procedure: Procedure, node: Convert, code: Code) -> Code:
    target = node.type
    assert isinstance(target, Elementary)
    if target.family is Family.REAL:
        return _call("_rounded", code, target) if target == REAL else code
    function = "_cut_to_whole" if node.rounding == "truncate" else "_to_whole"
    result = _call(function, code, target, *limits(target))._replace(safe=False)
    procedure.site(result.text, node)
    return result


def _to_real(code: Code, target: Elementary) -> Code:
    largest = max(abs(code.low), abs(code.high))
    if target == REAL and largest > _EXACT_IN_LREAL:
        return _call("_real_of_whole", code, target)
    result = code._replace(
        text=f"{code.at(Level.SUM)} + 0.0",
        level=Level.SUM,
        low=0,
        high=0,
        depth=code.depth + 1,
        simple=False,
    )
    if target == REAL and largest > _EXACT_IN_REAL:
        return _call("_rounded", result, target)
    return result


def _character(code: Code, source: Elementary, target: Elementary) -> Code:
    if source.family is Family.CHAR and target.family is Family.CHAR:
        return _call("_narrowed", code, target) if target.bits < source.bits else code
    if source.family is Family.CHAR:
        result = _call("ord", code, target)
        return result._replace(low=0, high=(1 << source.bits) - 1)
    return _call("chr", masked(code, target.bits), target)


def _text(code: Code, source: Type, target: Type) -> Code:
    wide_source = source.wide if isinstance(source, StringType) else source == WCHAR
    wide_target = target.wide if isinstance(target, StringType) else target == WCHAR
    if wide_source and not wide_target:
        code = _call("_narrowed", code, target)
    if isinstance(target, StringType):
        length = source.length if isinstance(source, StringType) else 1
        return cut(code, length, target)
    return code


def cut(code: Code, length: int, target: StringType) -> Code:
    """A text of up to `length` characters in the room that the target has."""
    if length <= target.length:
        return code
    return code._replace(
        text=f"{code.at(Level.ATOM)}[:{target.length}]",
        level=Level.ATOM,
        depth=code.depth + 1,
        simple=False,
    )
