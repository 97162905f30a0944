"""EN and ENO: calls that happen only if they are enabled, and whether they went well.

`f(EN := a, x := 1, ENO => ok)`: with EN FALSE nothing is evaluated or written but ENO, which is
FALSE then. ENO of a block is what the block assigned to its own ENO, TRUE if it did nothing; of an
instruction with a RET_VAL it says that the RET_VAL is not negative; of a standard function or a
conversion that the result is right (`checked.Attempt`).
Sources: IEC 61131-3 third edition, section 6.6.1.6; TIA Portal help, "EN/ENO mechanism"; S7-SCL
V5.3 manual, "OK flag" and "EN/ENO".
"""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from fbgen.lang import ast, checked
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    Attempt,
    Binary,
    Block,
    Constant,
    Convert,
    Evaluate,
    Expression,
    Place,
    RoutineCall,
    StandardCall,
    Statement,
    SystemCall,
    Unary,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.calls.members import called_member
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.name_lookup import names_block
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.supplied.standard_blocks import COUNTER_METHODS, TIMER_METHODS
from fbgen.lang.checker.types.coercion import coerce, converted, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import BOOL, INT, BlockType
from fbgen.lang.walk import walk
from fbgen.source import Span

ENABLE = "en"
ENABLED = "eno"
_OK = "ok"
_MENTION = re.compile(r"\b(?:ENO|OK)\b", re.IGNORECASE)
_WITHOUT_CALLERS = (BlockKind.ORGANIZATION_BLOCK, BlockKind.PROGRAM)

WriteCall = Callable[[ast.Call], Sequence[Statement]]


# --- inside of a block --------------------------------------------------------------------------


def enable_variables(node: ast.Block, dialect: str) -> tuple[dict[str, Variable], Variable | None]:
    """What a block has because it speaks of ENO, by name; and the flag for its calls with ENO.

    In `step7` the flag OK is the same variable: at the end of the block it becomes ENO.
    """
    names: dict[str, Variable] = {}
    span = node.name.span
    if not _MENTION.search(node.span.source.text, node.span.start, node.span.end):
        return names, None
    flag = None
    wanted = {ENABLED, _OK} if dialect == "step7" else {ENABLED}
    mentioned = set()
    for part in walk(node.body):
        if isinstance(part, ast.Name) and not part.quoted and part.name.casefold() in wanted:
            mentioned.add(part.name.casefold())
        elif isinstance(part, ast.Argument) and part.name.casefold() == ENABLED:
            flag = Variable(span, "ENO of a call", VariableKind.TEMP, BOOL)
    if mentioned:
        kind = VariableKind.TEMP if node.kind in _WITHOUT_CALLERS else VariableKind.OUTPUT
        variable = Variable(span, "ENO", kind, BOOL, initial=True)
        names = dict.fromkeys(sorted(wanted), variable)
    return names, flag


def begin_enabled(ctx: Context, body: tuple[Statement, ...]) -> tuple[Statement, ...]:
    """The statements of a block; ENO of one that keeps its variables is TRUE at each start."""
    variable = ctx.own_eno
    if variable is None or ctx.block is None or ctx.block.kind is not BlockKind.FUNCTION_BLOCK:
        return body
    target = VariableRef(variable.span, variable, BOOL)
    start = checked.Assignment(variable.span, target, Constant(variable.span, True, BOOL))
    return (start, *body)


def attempted(ctx: Context, result: Expression) -> Expression:
    """A calculation in a block of `step7` that uses OK: an error in it makes OK FALSE."""
    if ctx.overflow_flag is None:
        return result
    if isinstance(result, Convert) and result.implicit:
        inner = attempted(ctx, result.operand)
        return Convert(result.span, inner, result.type, True, result.rounding)
    if not isinstance(result, Unary | Binary | Convert | StandardCall):
        return result
    flag = VariableRef(result.span, ctx.overflow_flag, BOOL)
    return Attempt(result.span, result, flag, result.type)


# --- calls --------------------------------------------------------------------------------------


def speaks_of_enable(call: ast.Call) -> bool:
    """True if EN or ENO is among the arguments."""
    return any(argument.name.casefold() in (ENABLE, ENABLED) for argument in call.arguments)


def enabled(ctx: Context, span: Span, call: ast.Call, write: WriteCall) -> Sequence[Statement]:
    """The statements of a call that stands alone or is all that a statement assigns."""
    given: dict[str, ast.Argument] = {}
    rest = []
    for argument in call.arguments:
        key = argument.name.casefold()
        if key in (ENABLE, ENABLED) and key not in given and not _declares(ctx, call, key):
            given[key] = argument
        else:
            rest.append(argument)
    if not given:
        return write(call)
    plain = ast.Call(call.span, call.callee, tuple(rest))
    enable, place = _enable(ctx, given), _place(ctx, given)
    own = _own_eno(ctx, call) if place is not None else None
    if own is not None and ENABLED in given:
        # The block has an output for it, which is bound like the others.
        plain = ast.Call(call.span, call.callee, (*rest, given[ENABLED]))
    statements = list(write(plain))
    if place is not None and own is None and statements:
        statements = _asked(ctx, given[ENABLED].span, place, statements)
    if enable is None:
        return statements
    refused: tuple[Statement, ...] = ()
    if place is not None:
        constant = Constant(given[ENABLED].span, False, BOOL)
        refused = (checked.Assignment(given[ENABLED].span, place, constant),)
    branch = checked.Branch(span, enable, tuple(statements))
    return (checked.If(span, (branch,), refused),)


def _enable(ctx: Context, given: dict[str, ast.Argument]) -> Expression | None:
    argument = given.get(ENABLE)
    if argument is None or argument.value is None:
        return None
    value = coerce(ctx, check_expression(ctx, argument.value, BOOL), BOOL, "EN")
    return None if value.type == ERRONEOUS else value


def _place(ctx: Context, given: dict[str, ast.Argument]) -> Place | None:
    argument = given.get(ENABLED)
    if argument is None or argument.value is None:
        return None
    place = check_target(ctx, argument.value, "ENO")
    if place is not None and place.type != BOOL:
        ctx.findings.error(
            "FB4010",
            f"ENO gives BOOL, which {spelled(place.type)} cannot take",
            argument.value.span,
            "take it into a variable of type BOOL",
        )
        return None
    return place


def _declares(ctx: Context, call: ast.Call, key: str) -> bool:
    """True if the block that is called has declared a parameter with that name itself."""
    return any(
        variable.name.casefold() == key and variable not in ctx.library.implicit
        for variable in _variables(ctx, call)
    )


def _own_eno(ctx: Context, call: ast.Call) -> Variable | None:
    variables = _variables(ctx, call)
    return next((one for one in variables if one in ctx.library.implicit), None)


def _variables(ctx: Context, call: ast.Call) -> tuple[Variable, ...]:
    """What the block that is called declares; nothing for what is no block of the user."""
    member = called_member(ctx, call)
    if member is not None:
        return member[1].variables if isinstance(member[1], Block) else member[1].block.variables
    callee = call.callee
    if isinstance(callee, ast.Name) and names_block(ctx, callee):
        block = ctx.library.user_block(callee.name)
        return block.variables if block is not None else ()
    if isinstance(callee, ast.Member) and callee.name.upper() in (*TIMER_METHODS, *COUNTER_METHODS):
        return ()
    kind = check_expression(ctx, callee).type
    return ctx.library.variables_of(kind) if isinstance(kind, BlockType) else ()


def _asked(ctx: Context, span: Span, place: Place, statements: list[Statement]) -> list[Statement]:
    """The statements of a call that has no ENO of its own, and what ENO is then."""
    first, *rest = statements
    if isinstance(first, Evaluate) and isinstance(first.call, SystemCall):
        return [checked.Assignment(span, place, _is_good(span, first.call))]
    if isinstance(first, checked.If):
        # VariantGet and VariantPut, which do nothing where the types are not the same.
        yes = checked.Assignment(span, place, Constant(span, True, BOOL))
        no = checked.Assignment(span, place, Constant(span, False, BOOL))
        (branch,) = first.branches
        branch = checked.Branch(branch.span, branch.condition, (*branch.body, yes))
        return [checked.If(first.span, (branch,), (no,))]
    if isinstance(first, Evaluate) and isinstance(first.call, RoutineCall):
        return [Evaluate(first.span, _telling(span, first.call, place)), *rest]
    call = _called(first.value) if isinstance(first, checked.Assignment) else None
    if isinstance(first, checked.Assignment) and isinstance(call, RoutineCall):
        value = _exchanged(first.value, call, _telling(span, call, place))
        return [checked.Assignment(first.span, first.target, value), *rest]
    if isinstance(first, checked.Assignment) and isinstance(call, SystemCall):
        return [first, *rest, checked.Assignment(span, place, _is_good(span, first.target))]
    true = Constant(span, True, BOOL)
    flag = ctx.call_flag
    if (
        not isinstance(first, checked.Assignment)
        or flag is None
        or not isinstance(call, Unary | Binary | Convert | StandardCall)
    ):
        return [*statements, checked.Assignment(span, place, true)]
    ref = VariableRef(span, flag, BOOL)
    return [
        checked.Assignment(span, ref, true),
        checked.Assignment(
            first.span,
            first.target,
            _exchanged(first.value, call, Attempt(call.span, call, ref, call.type)),
        ),
        *rest,
        checked.Assignment(span, place, ref),
    ]


def _called(value: Expression) -> Expression:
    """What was called, without the conversion for the place that takes it."""
    while isinstance(value, Convert) and value.implicit:
        value = value.operand
    return value


def _exchanged(value: Expression, call: Expression, by: Expression) -> Expression:
    """The value with another call under its conversions."""
    if value is call:
        return by
    assert isinstance(value, Convert)
    inner = _exchanged(value.operand, call, by)
    return Convert(value.span, inner, value.type, value.implicit, value.rounding)


def _telling(span: Span, call: RoutineCall, place: Place) -> RoutineCall:
    """The same call, which says by itself whether it works."""
    return replace(call, outputs=(*call.outputs, (checked.WORKS, place)))


def _is_good(span: Span, result: Expression) -> Expression:
    """RET_VAL without an error: its top bit is clear."""
    return Binary(span, ">=", converted(result, INT), Constant(span, 0, INT), BOOL)
