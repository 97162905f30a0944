"""Timers, counters and data blocks as arguments: what arrives is their number.

Sources: S7-SCL V5.3 manual, "Parameter types TIMER, COUNTER, BLOCK"; TIA Portal help, "DB_ANY".
"""

import re

from fbgen.lang import ast
from fbgen.lang.checked import Constant, Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.memory_access import block_number
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import BLOCK_DB, COUNTER, DB_ANY, TIMER, Type

NAMES = {
    TIMER: re.compile(r"%?T(\d+)\Z", re.IGNORECASE),
    COUNTER: re.compile(r"%?[CZ](\d+)\Z", re.IGNORECASE),
}
"""How timers and counters are named."""


def number_named(ctx: Context, node: ast.Expression, kind: Type) -> int | None:
    """The number of the timer or counter with that name: T1, C1 (or Z1), %T1."""
    name = node.name if isinstance(node, ast.Name) else node.span.text
    match = next((regex.match(name) for known, regex in NAMES.items() if known == kind), None)
    if match is None:
        return None
    key = name.casefold()
    return int(match[1]) if ctx.of_program(key) is None and ctx.local(key) is None else None


def numbered(ctx: Context, node: ast.Expression, kind: Type, where: str) -> Expression:
    """The argument for a parameter of one of these types; reports what is none."""
    number = number_named(ctx, node, kind)
    if number is not None:
        return Constant(node.span, number, kind)
    if kind in (BLOCK_DB, DB_ANY) and isinstance(node, ast.Name) and not node.local:
        found = block_number(ctx, node)
        if isinstance(found, Constant) and found.type != ERRONEOUS:
            return Constant(node.span, found.value, kind)
        return found
    return check_expression(ctx, node, kind)
