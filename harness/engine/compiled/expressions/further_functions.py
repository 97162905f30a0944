"""Calls of the less frequent standard functions: bits, BCD, scaling, the calendar.

Names and parameters: `fbgen.lang.checker.supplied.standard_functions`.
"""

from fbgen.lang.checked import StandardCall
from fbgen.lang.types import REAL, Elementary, Family
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.expressions.function_code import Writer, all_of, called, failing
from harness.engine.compiled.expressions.instants import count, instant
from harness.engine.compiled.library import reals
from harness.engine.compiled.library.dates import COUNTS, NS_PER_MS, OF_UNITS
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits

_UNBOUNDED = (-(1 << 70), 1 << 70)
"""Where a result is enclosed that can be of any size before it is wrapped around."""
_SIGNS = {"GT": ">", "GE": ">=", "EQ": "==", "LE": "<=", "LT": "<"}


def _library(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    return called(f"_{node.name.lower()}", node, codes)


def _failing_library(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    return failing(procedure, node, _library(procedure, node, codes))


def _rounded(code: Code, node: StandardCall) -> Code:
    if node.type == REAL:
        return code._replace(text=f"_rounded({code.text})", depth=code.depth + 1)
    return code


def _real(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    return _rounded(_library(procedure, node, codes), node)


def _scaled(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    kind = node.type
    assert isinstance(kind, Elementary)
    if kind.family is Family.REAL:
        return _real(procedure, node, codes)
    return failing(procedure, node, called("_scale_x_whole", node, codes, *limits(kind)))


def _finite(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    return called("_isfinite", node, codes)


def _chain(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    """Python chains comparisons itself, but stops at the first that does not hold."""
    if not all(code.safe for code in codes):
        texts = ", ".join(code.text for code in codes)
        return all_of(codes, f"_in_order_{node.name.lower()}({texts})")
    chain = f" {_SIGNS[node.name]} ".join(code.at(Level.BIT_OR) for code in codes)
    return all_of(codes, chain, Level.COMPARISON, 2)


def _width(node: StandardCall) -> int:
    kind = node.arguments[0].type
    assert isinstance(kind, Elementary)
    return kind.bits


def _from_bcd(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    most = limits(node.type)[1]
    return failing(procedure, node, called("_from_bcd", node, codes, _width(node), most))


def _to_bcd(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    assert isinstance(node.type, Elementary)
    return failing(procedure, node, called("_to_bcd", node, codes, node.type.bits))


def _ones(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    code = all_of(codes, f"{codes[0].at(Level.ATOM)}.bit_count()")
    if codes[0].text.isdigit():
        code = code._replace(text=f"({codes[0].text}).bit_count()")
    return code.within(0, _width(node))


def _lowest(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    return called("_lowest_one", node, codes).within(0, _width(node))


def _one_bit(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    assert isinstance(node.type, Elementary)
    places = f"({codes[0].at(Level.BIT_AND)} & {node.type.bits - 1})"
    return all_of(codes, f"1 << {places}", Level.SHIFT, 2).within(0, limits(node.type)[1])


def _byte_order(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    """S7 is big endian, every other controller little endian."""
    is_native = ("BIG" in node.name) == (
        procedure.context.model.program.dialect in ("tia", "step7")
    )
    kind = node.type
    assert isinstance(kind, Elementary)
    if is_native or kind.bits == 8:
        return codes[0]
    function = "_swapped_signed" if kind.is_signed else "_rotated_bytes"
    return called(function, node, codes, kind.bits // 8)


def _weekday(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    stamp = instant(codes[0], node.arguments[0].type)
    return called("_weekday_of_stamp", node, [stamp]).within(0, 6)


def _with_unit(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    """Calculations in the unit of the first operand; the result is not wrapped around yet."""
    kind = node.arguments[0].type
    assert isinstance(kind, Elementary)
    code = called(f"_{node.name.lower()}", node, codes, COUNTS[kind][1])
    return code.within(*_UNBOUNDED)


def _date_with_time(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    """CONCAT_DATE_TOD and CONCAT_DATE_LTOD."""
    day, time = instant(codes[0], node.arguments[0].type), codes[1]
    tick = NS_PER_MS if node.name == "CONCAT_DATE_TOD" else 1
    text = f"{day.at(Level.SUM)} + {time.at(Level.PRODUCT)} * {tick}"
    both = all_of([day, time], text, Level.SUM, 2).within(*_UNBOUNDED)
    assert isinstance(node.type, Elementary)
    return count(both, node.type)


def _date_of_parts(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    kind = node.type
    assert isinstance(kind, Elementary)
    counted = (*COUNTS[kind], kind.maximum)
    parts = ", ".join(code.text for code in codes)
    code = all_of(codes, f"_{node.name.lower()}({counted}, {parts})")
    return failing(procedure, node, code.within(*limits(kind)))


def _multiplexed(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    inputs, otherwise = codes[1:-1], codes[-1]
    values = ", ".join(code.text for code in inputs)
    text = f"_select_or_else({codes[0].text}, ({values},), {otherwise.text})"
    low, high = min(one.low for one in codes[1:]), max(one.high for one in codes[1:])
    return all_of(codes, text, more_depth=2).within(low, high)


WRITERS: dict[str, Writer] = {
    "ATAN2": _real,
    "NORM_X": _real,
    "SCALE_X": _scaled,
    "IS_VALID": _finite,
    "IS_VALID_BCD": _library,
    "FROM_BCD": _from_bcd,
    "TO_BCD": _to_bcd,
    "BITSUM": _ones,
    "ENCO": _lowest,
    "DECO": _one_bit,
    "DAY_OF_WEEK": _weekday,
    "MUX_ELSE": _multiplexed,
    **dict.fromkeys(reals.WHOLE_REALS, _real),
    **dict.fromkeys(_SIGNS, _chain),
    **dict.fromkeys(
        ("TO_BIG_ENDIAN", "FROM_BIG_ENDIAN", "TO_LITTLE_ENDIAN", "FROM_LITTLE_ENDIAN"), _byte_order
    ),
    **dict.fromkeys(
        (
            *("BCD16_TO_INT", "INT_TO_BCD16", "BCD32_TO_DINT", "DINT_TO_BCD32"),
            *("S5TIME_TO_TIME", "TIME_TO_S5TIME"),
            *("CONCAT_TOD", "CONCAT_LTOD"),
        ),
        _failing_library,
    ),
    **dict.fromkeys(("CONCAT_DATE", "CONCAT_DT", "CONCAT_LDT"), _date_of_parts),
    **dict.fromkeys(("CONCAT_DATE_TOD", "CONCAT_DATE_LTOD"), _date_with_time),
    **dict.fromkeys(OF_UNITS, _with_unit),
}
"""By canonical name."""
