"""Calls of standard functions: written out where that is short, else calls of the library.

Names and parameters: `fbgen.lang.checker.supplied.standard_functions`. Sources: IEC 61131-3
third edition, tables 28 to 36; TIA Portal help.
"""

import re

from fbgen.lang.checked import StandardCall
from fbgen.lang.types import BOOL, LREAL, REAL, Elementary, Family, StringType, Type
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.evaluation import Write, named, value
from harness.engine.compiled.expressions.conversions import cut
from harness.engine.compiled.expressions.function_code import Writer, all_of, called, failing
from harness.engine.compiled.expressions.further_functions import WRITERS
from harness.engine.compiled.expressions.instants import instant
from harness.engine.compiled.library import dates, reals, time_texts
from harness.engine.compiled.library.dates import COUNTS
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import is_counted, limits, masked

_TEXT = re.compile(r"(W?STRING)_TO_([A-Z]+)|([A-Z_]+)_TO_(W?STRING)\Z")
_LONGEST_TEXT = 1 << 16


def _hull(codes: list[Code]) -> tuple[int, int]:
    return min(code.low for code in codes), max(code.high for code in codes)


# --- selection ----------------------------------------------------------------------------------


def _extreme(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    smallest = node.name == "MIN"
    pick = min if smallest else max
    ends = (pick(code.low for code in codes), pick(code.high for code in codes))
    if len(codes) == 2:
        one, two = codes
        first, one_again = named(procedure, one)
        second, two_again = named(procedure, two)
        sign = "<" if smallest else ">"
        if one.simple or two.simple or one.safe:
            # In Python's order the second operand is evaluated first: nobody can tell.
            text = f"{two_again} if {second} {sign} {first} else {one_again}"
            return all_of(codes, text, Level.CONDITIONAL, 3).within(*ends)
    return called(node.name.lower(), node, codes).within(*ends)


def _limit(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    low, code, high = codes
    constants = is_counted(node.type) and low.low == low.high and high.low == high.high
    if constants and low.low <= high.low and low.simple and high.simple:
        first, again = named(procedure, code)
        text = f"{low.text} if {first} < {low.text} else {high.text} if {again} > {high.text} "
        text += f"else {again}"
        result = all_of(codes, text, Level.CONDITIONAL, 3)
        return result.within(low.low, high.high)
    if node.name == "LIMIT" or (is_counted(node.type) and low.high <= high.low):
        return called("_limit", node, codes)
    return called("_limit_or_operand", node, codes)


def _selected(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    which, zero, one = codes
    if zero.safe and one.safe:
        text = f"{one.at(Level.OR)} if {which.at(Level.OR)} else {zero.text}"
        return all_of(codes, text, Level.CONDITIONAL, 2).within(*_hull([zero, one]))
    text = f"_chosen({which.text}, {zero.text}, {one.text})"
    return all_of(codes, text).within(*_hull([zero, one]))


def _multiplexed(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    inputs = codes[1:]
    text = f"_select({codes[0].text}, ({', '.join(code.text for code in inputs)}))"
    return failing(procedure, node, all_of(codes, text, more_depth=2).within(*_hull(inputs)))


# --- shifts -------------------------------------------------------------------------------------


def _shift(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    kind = node.type
    assert isinstance(kind, Elementary)
    operand, places = codes
    bits = kind.bits
    fill_sign = kind.is_signed and procedure.context.model.program.dialect in ("tia", "step7")
    if node.name == "SHR" and fill_sign:
        if places.low == places.high:
            count = places.low if 0 <= places.low < bits else bits - 1
            text = f"{operand.at(Level.SHIFT)} >> {count}"
            ends = (operand.low >> count, operand.high >> count)
            return all_of([operand], text, Level.SHIFT).within(*ends)
        return called("_shift_right_signed", node, codes, bits)
    operand = masked(operand, bits)
    if places.low == places.high:
        return _constant_shift(procedure, node, operand, places.low)
    function = {
        "SHL": "_shift_left",
        "SHR": "_shift_right",
        "ROL": "_rotate_left",
        "ROR": "_rotate_right",
    }[node.name]
    result = called(function, node, [operand, places], bits)
    return result.within(0, (1 << bits) - 1)


def _constant_shift(procedure: Procedure, node: StandardCall, code: Code, places: int) -> Code:
    assert isinstance(node.type, Elementary)
    bits, name = node.type.bits, node.name
    if name in ("ROL", "ROR"):
        left = places % bits if name == "ROL" else -places % bits
        if left == 0:
            return code
        if bits == 8:
            table = tuple(byte << left & 255 | byte >> 8 - left for byte in range(256))
            name = procedure.context.shared_table(f"_rotated_left_{left}", table)
            return all_of([code], f"{name}[{code.text}]", more_depth=2).within(0, 255)
        first, again = named(procedure, code)
        text = f"({first} << {left} | {again} >> {bits - left}) & {(1 << bits) - 1}"
        result = all_of([code], text, Level.BIT_AND, 3)
        return result.within(0, (1 << bits) - 1)
    if not 0 <= places < bits:
        return all_of([code], "0")._replace(simple=True) if code.safe else _zero(code)
    if places == 0:
        return code
    sign = "<<" if name == "SHL" else ">>"
    shifted = code.high << places if name == "SHL" else code.high >> places
    result = all_of([code], f"{code.at(Level.SHIFT)} {sign} {places}", Level.SHIFT)
    return result.within(0, shifted)


def _zero(code: Code) -> Code:
    return all_of([code], f"{code.at(Level.PRODUCT)} * 0", Level.PRODUCT)


def _swapped(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    assert isinstance(node.type, Elementary)
    if node.type.bits == 16:
        first, again = named(procedure, codes[0])
        text = f"({first} << 8 | {again} >> 8) & 65535"
        return all_of(codes, text, Level.BIT_AND, 3).within(0, 65535)
    return called("_rotated_bytes", node, codes, node.type.bits // 8)


# --- numbers ------------------------------------------------------------------------------------


def _absolute(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    code = codes[0]
    if is_counted(node.type) and code.low >= 0:
        return code
    high = max(abs(code.low), abs(code.high))
    return called("abs", node, codes).within(0, high)


def _mathematical(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    code = called(f"_{node.name.lower()}", node, codes)
    if node.type == REAL:
        return code._replace(text=f"_rounded({code.text})", depth=code.depth + 1)
    return code


def _to_next_whole(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    function = "_ceiling" if node.name == "CEIL" else "_floor"
    return failing(procedure, node, called(function, node, codes, *limits(node.type)))


def _date(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    code = called(f"_{node.name.lower()}", node, codes)
    # The functions leave the wrapping to us, and their results can be of any size.
    return code.within(-(1 << 70), 1 << 70)


# --- texts --------------------------------------------------------------------------------------


def _length(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    return called("len", node, codes).within(0, _LONGEST_TEXT)


def _concatenated(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    text = " + ".join(code.at(Level.SUM) for code in codes[:1] + codes[1:])
    if len(codes) > 20:
        text = f'"".join(({", ".join(code.text for code in codes)}))'
        return _fitted(all_of(codes, text), node.type)
    return _fitted(all_of(codes, text, Level.SUM, len(codes)), node.type)


def _fitted(code: Code, kind: Type) -> Code:
    assert isinstance(kind, StringType)
    return cut(code, _LONGEST_TEXT, kind)


def _text_function(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    code = called(f"_{node.name.lower()}", node, codes)
    if isinstance(node.type, StringType):
        return _fitted(code, node.type)
    return code


def _number_and_text(procedure: Procedure, node: StandardCall, codes: list[Code]) -> Code:
    match = _TEXT.match(node.name)
    assert match is not None
    kind = node.type
    if match[1]:
        if kind == BOOL:
            return failing(procedure, node, called("_text_to_truth", node, codes))
        if isinstance(kind, Elementary) and kind.family is Family.REAL:
            code = called("_text_to_real", node, codes, kind.bits)
        else:
            code = called("_text_to_whole", node, codes, *limits(kind))
        return failing(procedure, node, code)
    source = node.arguments[0].type
    assert isinstance(kind, StringType)
    if source in (REAL, LREAL):
        digits = 6 if source == REAL else 14
        return cut(called("_text_of_real", node, codes, digits), 25, kind)
    if source == BOOL:
        return cut(called("_text_of_truth", node, codes), 5, kind)
    if source.name in time_texts.FUNCTIONS:
        shown = [instant(codes[0], source)] if source in COUNTS else codes
        return cut(called(f"_show_{source.name.lower()}", node, shown), 40, kind)
    return cut(called("str", node, codes), 20, kind)


_WRITERS: dict[str, Writer] = {
    "MIN": _extreme,
    "MAX": _extreme,
    **dict.fromkeys(("LIMIT", "LIMIT_OR_IN"), _limit),
    "SEL": _selected,
    "MUX": _multiplexed,
    "SWAP": _swapped,
    "ABS": _absolute,
    "CEIL": _to_next_whole,
    "FLOOR": _to_next_whole,
    "LEN": _length,
    "CONCAT": _concatenated,
    **dict.fromkeys(("SHL", "SHR", "ROL", "ROR"), _shift),
    **dict.fromkeys(reals.FUNCTIONS, _mathematical),
    **dict.fromkeys(dates.FUNCTIONS, _date),
    **WRITERS,
    **dict.fromkeys(
        (
            *("LEFT", "RIGHT", "MID", "INSERT", "DELETE", "REPLACE", "FIND", "STRING_TO_CHAR"),
            "WSTRING_TO_WCHAR",
        ),
        _text_function,
    ),
}


def _standard_call(procedure: Procedure, node: StandardCall) -> Code:
    codes = [value(procedure, argument) for argument in node.arguments]
    return _WRITERS.get(node.name, _number_and_text)(procedure, node, codes)


EXPRESSIONS: dict[type, Write] = {StandardCall: _standard_call}
"""Which function of this module writes which node."""
