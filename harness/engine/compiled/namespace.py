"""What generated code can name: the library, the controller, cells, and a few functions of ours."""

from collections.abc import Callable
from dataclasses import replace
from math import atan2, inf, isfinite, nan
from typing import Any

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Expression, Place, SystemCall
from fbgen.lang.checker.supplied.system_instructions import ELEMENT_MOVES, INSTRUCTIONS, ON_VARIANTS
from fbgen.lang.types import Scalar, Type
from harness.engine.compiled.data.areas import VariableArea, cell_location, fixed_location
from harness.engine.compiled.data.cells import AttributeCell, ElementCell, ValueCell, same, target
from harness.engine.compiled.data.memory import Memory
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.data.placed_pointers import PlacedVariant
from harness.engine.compiled.data.placement import FUNCTIONS, Bytes
from harness.engine.compiled.expressions.bound_variants import Variant
from harness.engine.compiled.expressions.memory_access import access
from harness.engine.compiled.expressions.open_arrays import OpenArray
from harness.engine.compiled.expressions.variants import FUNCTIONS as VARIANT_FUNCTIONS
from harness.engine.compiled.expressions.variants import area_of
from harness.engine.compiled.expressions.variants import run as run_on_variants
from harness.engine.compiled.library import (
    calendar,
    dates,
    decimals,
    dtl,
    reals,
    stops,
    texts,
    time_texts,
    timers,
    wholes,
)
from harness.engine.compiled.statements.instructions import areas
from harness.engine.compiled.statements.memory_instructions import (
    BlockPokes,
    move_area,
    move_elements,
)
from harness.engine.environment import Environment
from harness.engine.faults import no_such_area
from harness.engine.interface import Limits
from harness.engine.layout import size_bits
from harness.engine.values import accept_scalar


class Cpu:
    """What one call from outside may still do; `start` is its start information."""

    __slots__ = ("depth", "most_passes", "passes", "start")

    def __init__(self, limits: Limits) -> None:
        self.most_passes = limits.loop_passes
        self.passes = limits.loop_passes
        self.depth = 0
        self.start = b""

    def retrigger(self) -> None:
        """The cycle monitoring time begins anew."""
        self.passes = self.most_passes


def _chosen(which: bool, zero: object, one: object) -> object:
    return one if which else zero


def _text_to_real(text: str, bits: int) -> float:
    number = texts.to_real(text)
    if bits == 64:
        return number
    nearest = reals.rounded(number)
    if nearest - nearest != 0:
        raise stops.NoNumber(text)
    return nearest


def _no_block(number: int) -> int:
    raise stops.NoBlock(number)


def _cannot_run(what: str) -> None:
    raise stops.CannotRun(what)


def _outside(size: int) -> int:
    raise stops.NoAddress(size)


LIBRARY: dict[str, Any] = {
    "_inf": inf,
    "_nan": nan,
    "_cell": reals.CELL,
    "_keep": object(),
    "_type": type,
    "_accept": accept_scalar,
    "_AttributeCell": AttributeCell,
    "_ElementCell": ElementCell,
    "_ValueCell": ValueCell,
    "_OpenArray": OpenArray,
    "_same": same,
    "_target": target,
    **VARIANT_FUNCTIONS,
    "_rounded": reals.rounded,
    "_real_of_whole": reals.real_of_whole,
    "_real_quotient": reals.quotient,
    "_real_power": reals.power,
    "_to_whole": reals.to_whole,
    "_cut_to_whole": reals.cut_to_whole,
    "_floor": reals.floor,
    "_ceiling": reals.ceiling,
    "_bits_of_real": reals.bits_of_real,
    "_real_of_bits": reals.real_of_bits,
    "_bits_of_long_real": reals.bits_of_long_real,
    "_long_real_of_bits": reals.long_real_of_bits,
    "_quotient": wholes.quotient,
    "_remainder": wholes.remainder,
    "_power": wholes.power,
    "_scaled": wholes.scaled,
    "_divided": wholes.divided,
    "_shift_left": wholes.shift_left,
    "_shift_right": wholes.shift_right,
    "_shift_right_signed": wholes.shift_right_signed,
    "_rotate_left": wholes.rotate_left,
    "_rotate_right": wholes.rotate_right,
    "_rotated_bytes": wholes.rotated_bytes,
    "_turn": timers.turn,
    "_limit": wholes.limit,
    "_limit_or_operand": wholes.limit_or_operand,
    "_select": wholes.select,
    "_chosen": _chosen,
    "_bad_index": wholes.bad_index,
    "_checked_index": wholes.checked_index,
    "_limited": wholes.limited,
    "_runaway": wholes.runaway,
    "_no_step": wholes.no_step,
    "_stamp_of_dtl": dtl.stamp_of,
    "_dtl": dtl.in_parts,
    "_cut_to_ms": dates.cut_to_ms,
    "_bcd16_to_int": decimals.bcd_to_int,
    "_int_to_bcd16": decimals.int_to_bcd,
    "_bcd32_to_dint": decimals.long_bcd_to_int,
    "_dint_to_bcd32": decimals.int_to_long_bcd,
    "_from_bcd": decimals.from_bcd,
    "_to_bcd": decimals.to_bcd,
    "_is_valid_bcd": decimals.is_bcd,
    "_lowest_one": wholes.lowest_one,
    "_swapped_signed": wholes.swapped_signed,
    "_select_or_else": wholes.select_or_else,
    "_atan2": atan2,
    "_isfinite": isfinite,
    "_norm_x": reals.normalized,
    "_scale_x": reals.scaled,
    "_scale_x_whole": reals.scaled_to_whole,
    "_concat_date": calendar.concat_stamp,
    "_concat_tod": calendar.ms_of,
    "_concat_ltod": calendar.concat_ltod,
    "_concat_dt": calendar.concat_stamp,
    "_concat_ldt": calendar.concat_stamp,
    "_weekday_of_stamp": calendar.weekday_of_stamp,
    "_text_of_truth": texts.of_truth,
    "_text_to_truth": texts.to_truth,
    "_wstring_to_wchar": texts.first_character,
    "_s5time_to_time": decimals.s5time_to_time,
    "_time_to_s5time": decimals.time_to_s5time,
    "_left": texts.left,
    "_right": texts.right,
    "_mid": texts.middle,
    "_insert": texts.insert,
    "_delete": texts.delete,
    "_replace": texts.replace,
    "_find": texts.find,
    "_narrowed": texts.narrowed,
    "_string_to_char": texts.first_character,
    "_text_of_real": texts.of_real,
    "_text_to_whole": texts.to_whole,
    "_text_to_real": _text_to_real,
    **FUNCTIONS,
    "_no_block": _no_block,
    "_cannot_run": _cannot_run,
    "_outside": _outside,
    **{f"_{name.lower()}": function for name, function in reals.FUNCTIONS.items()},
    **{f"_{name.lower()}": function for name, function in reals.WHOLE_REALS.items()},
    **{f"_in_order_{name}": function for name, function in wholes.CHAINS.items()},
    **{f"_show_{name.lower()}": function for name, function in time_texts.FUNCTIONS.items()},
    **{f"_{name.lower()}": function for name, function in dates.FUNCTIONS.items()},
    **{f"_{name.lower()}": function for name, function in dates.OF_UNITS.items()},
}
"""Everything that does not depend on the program."""


def counting(cpu: Cpu, limits: Limits) -> dict[str, Callable[..., None]]:
    """The functions that count how deep blocks are nested."""

    def enter(block: str) -> None:
        if cpu.depth >= limits.call_depth:
            raise stops.TooDeep(block)
        cpu.depth += 1

    def leave() -> None:
        cpu.depth -= 1

    return {"_enter": enter, "_leave": leave}


def hardware(
    memory: Memory, data: Bytes, environment: Environment
) -> dict[str, Callable[..., Any]]:
    """The functions that reach the controller and absolute addresses."""
    block_pokes = BlockPokes(data, environment)

    def instruction(node: SystemCall, *arguments: Any) -> Scalar:
        if node.name in ELEMENT_MOVES:
            return move_elements(node, *arguments)
        if node.name == "POKE_BLK":
            return block_pokes.run(node, *arguments)
        if node.name in ON_VARIANTS:
            given = zip(node.arguments, arguments, strict=True)
            return run_on_variants(node, memory, *(_bound(one, data) for (_, one), data in given))
        by_name: dict[str, Scalar | VariableArea] = {}
        places = areas(node)
        for (name, _), argument in zip(node.arguments, arguments, strict=True):
            place = places.get(name)
            if place is None:
                by_name[name] = argument
                continue
            argument = _bound(place, argument)
            if isinstance(argument, Variant):
                _check_layout(place, argument.kind)
                by_name[name] = area_of(memory, argument)
                continue
            _check_layout(place, place.type)
            if is_scalar(place.type):
                by_name[name] = VariableArea(memory, cell_location(place.type, argument))
            else:
                by_name[name] = VariableArea(memory, fixed_location(place.type, argument))
        if INSTRUCTIONS[node.name.casefold()].on_memory:
            source, target = by_name.values()
            assert isinstance(source, VariableArea)
            assert isinstance(target, VariableArea)
            return move_area(node, source, target)
        return environment.instruction(node.name, by_name, node.span)

    def fill(place: Place, data: Any, value: Any) -> None:
        memory.fill(place.span.text, place.type, data, value)

    return {"_instruction": instruction, "_fill": fill, **access(data, environment)}


def _bound(node: Expression, argument: Any) -> Any:
    """What an ANY in memory means; any other argument as it is. Raises FB6017."""
    if not isinstance(argument, PlacedVariant):
        return argument
    try:
        return Variant(argument.kind, argument.target)
    except stops.NoArea as problem:
        raise no_such_area(node.span, problem.pattern, problem.reason) from None


def _check_layout(place: Place, kind: Type) -> None:
    """Raises FB6013, with the place, if the variable has no layout in memory."""
    try:
        size_bits(kind)
    except DiagnosticError as problem:
        raise DiagnosticError(
            replace(diagnostic, span=place.span) for diagnostic in problem.diagnostics
        ) from None
