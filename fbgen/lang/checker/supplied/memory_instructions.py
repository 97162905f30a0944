"""Instructions that move whole areas of memory: what their arguments have to be.

Sources: TIA Portal help, "MOVE_BLK", "FILL_BLK", "POKE_BLK", "BLKMOV", "FILL"; STEP 7 help, "Format
of the parameter type ANY".
"""

import re
from typing import TypeGuard

from fbgen.lang import ast
from fbgen.lang.checked import Constant, Expression, IndexRef, MemoryRef, ReferenceTo
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.operands.memory_access import (
    DATA_BLOCK,
    INPUTS,
    MARKERS,
    OUTPUTS,
    use_block,
)
from fbgen.lang.checker.supplied.system_instructions import ELEMENT_MOVES, ON_VARIANTS, Instruction
from fbgen.lang.checker.types.coercion import coerce, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous
from fbgen.lang.layout import holds_blocks
from fbgen.lang.types import (
    BOOL,
    BYTE,
    DINT,
    ELEMENTARY,
    INT,
    POINTER_VALUE,
    ArrayType,
    Elementary,
    Type,
)

_PLACE = r"(?:DB([0-9]{1,5})\.DB|([IQMEA]))X? ?([0-9]{1,5})\.([0-7])"
_POINTER = re.compile(_PLACE)
_AREA = re.compile(_PLACE + " ([A-Z_]+) ([0-9]{1,5})")
_AREAS = {"I": INPUTS, "E": INPUTS, "Q": OUTPUTS, "A": OUTPUTS, "M": MARKERS}


def points(node: ast.Expression) -> TypeGuard[ast.Literal]:
    """True for `P#...`."""
    return isinstance(node, ast.Literal) and node.kind is ast.LiteralKind.POINTER


def check_pointer_constant(ctx: Context, node: ast.Literal, target: Type, where: str) -> Expression:
    """`P#DB1.DBX0.0 BYTE 10` for an ANY, `P#DB1.DBX0.0` for a POINTER, as a reference to it."""
    if target != POINTER_VALUE:
        return check_area_literal(ctx, node, where)
    match = _POINTER.fullmatch(str(node.value))
    if match is None:
        ctx.findings.error(
            "FB4075",
            f"{where} takes a pointer to a place, not {node.text}",
            node.span,
            "write area and first bit: P#DB1.DBX0.0",
        )
        return erroneous(node.span)
    return _pointed(ctx, node, match, BOOL)


def check_area_literal(ctx: Context, node: ast.Literal, where: str) -> Expression:
    """`P#DB1.DBX0.0 BYTE 10` as the place that it points to."""
    match = _AREA.fullmatch(str(node.value))
    kind = ELEMENTARY.get(match[5]) if match else None
    if match is None or kind is None or kind.bits < 1 or int(match[6]) < 1:
        ctx.findings.error(
            "FB4075",
            f"{where} takes a pointer to an area, not {node.text}",
            node.span,
            "write area, first bit, type and number: P#DB1.DBX0.0 BYTE 10",
        )
        return erroneous(node.span)
    return _pointed(ctx, node, match, ArrayType(((1, int(match[6])),), kind))


def _pointed(ctx: Context, node: ast.Literal, match: re.Match[str], kind: Type) -> Expression:
    def number(text: str | None) -> Constant:
        return Constant(node.span, int(text or 0), DINT)

    db = number(match[1])
    code = DATA_BLOCK if match[1] else _AREAS[match[2]]
    if match[1]:
        use_block(ctx, db)
    area = Constant(node.span, code, BYTE)
    bit = Constant(node.span, int(match[4]), INT)
    return MemoryRef(node.span, area, db, number(match[3]), bit, kind)


def check_memory_instruction(
    ctx: Context, instruction: Instruction, arguments: dict[str, Expression]
) -> bool:
    """Report what is wrong with the arguments together; `IN` may become another expression."""
    if instruction.name == "POKE_BLK":
        for end in ("src", "dest"):
            area = arguments[f"area_{end}"]
            if not isinstance(area, Constant) or area.value == DATA_BLOCK:
                use_block(ctx, arguments[f"dbNumber_{end}"])
        return True
    if instruction.name in ON_VARIANTS:
        return _counts_in_whole_numbers(ctx, instruction, arguments.get("POS"))
    if instruction.name not in ELEMENT_MOVES:
        return all(_lies_in_bytes(ctx, instruction, name, arguments[name]) for name in arguments)
    fills = "FILL" in instruction.name
    for name in ("OUT",) if fills else ("IN", "OUT"):
        if not isinstance(arguments[name], IndexRef) or holds_blocks(arguments[name].type):
            ctx.findings.error(
                "FB4075",
                f"parameter {name} of {instruction.name} takes an element of an array",
                arguments[name].span,
                "give the first element that is meant: table[0]",
            )
            return False
    target, source = arguments["OUT"], arguments["IN"]
    where = f"parameter IN of {instruction.name}"
    if fills:
        arguments["IN"] = coerce(ctx, source, target.type, where)
        return arguments["IN"].type != ERRONEOUS
    if source.type == target.type:
        return True
    ctx.findings.error(
        "FB4010",
        f"{where} has elements of {spelled(source.type)}, OUT of {spelled(target.type)}",
        source.span,
        "both arrays need the same type of elements",
    )
    return False


def _counts_in_whole_numbers(
    ctx: Context, instruction: Instruction, position: Expression | None
) -> bool:
    if position is None:
        return True
    place = position.place if isinstance(position, ReferenceTo) else None
    kind = None if place is None else place.type
    if isinstance(kind, Elementary) and kind.is_integer:
        return True
    ctx.findings.error(
        "FB4075",
        f"parameter POS of {instruction.name} takes a variable that counts bytes",
        position.span,
        "give a variable of type DINT",
    )
    return False


def _lies_in_bytes(ctx: Context, instruction: Instruction, name: str, argument: Expression) -> bool:
    if not holds_blocks(argument.type):
        return True
    ctx.findings.error(
        "FB4075",
        f"parameter {name} of {instruction.name} takes an area of bytes,"
        f" not {spelled(argument.type)}",
        argument.span,
        "give an array, a structure or an elementary variable",
    )
    return False
