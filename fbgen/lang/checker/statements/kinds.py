"""Statements: what they do to which variables, and whether their types go together.

Sources: IEC 61131-3 third edition, table 72; TIA Portal help, "Program control (SCL)".
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from fbgen.diagnostics import Note
from fbgen.lang import ast, checked
from fbgen.lang.checked import Constant, Expression, Statement
from fbgen.lang.checker.calls.bit_gathering import bit_move, is_bit_move
from fbgen.lang.checker.calls.callees import (
    body_call,
    function_call,
    instance_call,
    is_built_in,
    method_call,
    system_call,
)
from fbgen.lang.checker.calls.enabling import enabled, speaks_of_enable
from fbgen.lang.checker.calls.members import Receiver, called_member
from fbgen.lang.checker.calls.routine_calls import is_routine, routine
from fbgen.lang.checker.calls.standard_calls import check_standard_call, is_standard_function
from fbgen.lang.checker.calls.timer_control import is_timer_control, timer_control
from fbgen.lang.checker.calls.unknown_callees import unknown_callee
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.objects import Method
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.characters import written_character
from fbgen.lang.checker.operands.memory_access import check_poke, memory_access_named
from fbgen.lang.checker.operands.name_lookup import names_block, without_library
from fbgen.lang.checker.operands.variants import (
    asks_for_type,
    case_of_type,
    is_variant_access,
    variant_access,
)
from fbgen.lang.checker.statements.assignments import check_assignment
from fbgen.lang.checker.statements.exceptions import check_try
from fbgen.lang.checker.statements.jumps import check_goto, check_label
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.supplied.system_instructions import instruction_named
from fbgen.lang.checker.types.coercion import as_counted, as_typed, coerce, converted, spelled
from fbgen.lang.checker.types.conversions import SIGNED_OF, UNSIGNED_OF
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import BOOL, BYTE, WORD, Elementary, Family, counting_type
from fbgen.source import Span

_RESULTS = ("OUT", "OUT1", "RET_VAL")
"""What the help calls the result of a function; the editor writes it with an arrow."""
_SELECTORS = (Family.SIGNED, Family.UNSIGNED, Family.BITS)


def check_body(ctx: Context, nodes: Sequence[ast.Statement]) -> tuple[Statement, ...]:
    """The statements of a list; those with errors are reported and left out."""
    found: list[Statement] = []
    ctx.depth += 1
    for node in nodes:
        if ctx.too_deep(node.span):
            break
        around, ctx.not_run = ctx.not_run, []
        checked_ones = _CHECKS[type(node)](ctx, node)
        if ctx.not_run:
            checked_ones = (checked.Stop(node.span, ctx.not_run[0]),)
        elif not checked_ones:
            ctx.findings.unclear.append(node.span)
        ctx.not_run = around
        found.extend(checked_ones)
    ctx.depth -= 1
    return tuple(found)


def _with_copies(
    check: Callable[[Context, Any], Sequence[Statement]],
) -> Callable[[Context, Any], Sequence[Statement]]:
    """A statement, and behind it what converts the outputs of its calls."""

    def checked_with_copies(ctx: Context, node: Any) -> Sequence[Statement]:
        ctx.copies = []
        found = check(ctx, node)
        copies, ctx.copies = ctx.copies, None
        return (*found, *copies) if copies and found else found

    return checked_with_copies


def _call(ctx: Context, node: ast.CallStatement) -> Sequence[Statement]:
    if speaks_of_enable(node.call):
        return enabled(ctx, node.span, node.call, lambda call: _plain_call(ctx, node, call))
    return _plain_call(ctx, node, node.call)


def _plain_call(ctx: Context, node: ast.CallStatement, call: ast.Call) -> Sequence[Statement]:
    call = replace(call, callee=without_library(ctx, call.callee))
    member = called_member(ctx, call)
    if member is not None:
        return _member_statement(ctx, node.span, call, *member)
    callee = call.callee
    if not isinstance(callee, ast.Name) or not names_block(ctx, callee):
        instance = instance_call(ctx, call)
        return () if instance is None else (instance,)
    name = callee.name
    block = ctx.library.user_block(name)
    if block is not None and not (
        ctx.rules.quoted_blocks and not callee.quoted and is_built_in(name)
    ):
        if block.kind is ast.BlockKind.FUNCTION_BLOCK:
            check_expression(ctx, call)
            return ()
        function = function_call(ctx, call, block)
        return () if function is None else (checked.Evaluate(node.span, function),)
    if is_variant_access(ctx, name):
        return variant_access(ctx, call, name)
    if is_bit_move(ctx, name):
        return bit_move(ctx, call, name)
    if is_timer_control(ctx, name):
        return timer_control(ctx, call, name)
    access = memory_access_named(name)
    if access is not None and access.writes:
        poke = check_poke(ctx, call, access)
        return () if poke is None else (poke,)
    if access is not None:
        _unused(ctx, node.span, access.name)
        return ()
    instruction = instruction_named(name)
    if instruction is not None:
        result, place = system_call(ctx, call, instruction)
        return _system_statement(ctx, node.span, result, place)
    if is_standard_function(name):
        assignment = _taken_by_arrow(call)
        if assignment is not None:
            return check_assignment(ctx, assignment)
        if check_standard_call(ctx, call, name, None).type != ERRONEOUS:
            _unused(ctx, node.span, name)
        return ()
    if is_routine(ctx, name):
        found = routine(ctx, call, name, None)
        return () if found is None else (checked.Evaluate(node.span, found),)
    unknown_callee(ctx, call, name)
    return ()


def _taken_by_arrow(call: ast.Call) -> ast.Assignment | None:
    """`T_ADD(IN1 := a, IN2 := b, OUT => c)` as the assignment that it is; None without an arrow."""
    taken = [one for one in call.arguments if one.kind is ast.ArgumentKind.OUTPUT]
    if len(taken) != 1 or taken[0].name.upper() not in _RESULTS or taken[0].value is None:
        return None
    rest = tuple(one for one in call.arguments if one is not taken[0])
    value = ast.Call(call.span, call.callee, rest)
    return ast.Assignment(call.span, taken[0].value, ":=", value)


def _unused(ctx: Context, span: Span, name: str) -> None:
    ctx.findings.error(
        "FB4049",
        f"the result of {name.upper()} is not used",
        span,
        f"assign it: x := {name}(...);",
    )


def _member_statement(
    ctx: Context, span: Span, call: ast.Call, receiver: Receiver, member: Method | checked.Block
) -> Sequence[Statement]:
    if isinstance(member, Method):
        function = method_call(ctx, call, receiver, member)
        return () if function is None else (checked.Evaluate(span, function),)
    body = body_call(ctx, call, receiver, member)
    return () if body is None else (body,)


def _system_statement(
    ctx: Context, span: Span, call: Expression, place: ast.Expression | None
) -> Sequence[Statement]:
    if not isinstance(call, checked.SystemCall):
        return ()
    if place is None:
        return (checked.Evaluate(span, call),)
    target = check_target(ctx, place, "RET_VAL")
    if target is None:
        return ()
    value = coerce(ctx, call, target.type, "RET_VAL")
    return () if value.type == ERRONEOUS else (checked.Assignment(span, target, value),)


def _condition(ctx: Context, node: ast.Expression, keyword: str) -> Expression:
    condition = check_expression(ctx, node, BOOL)
    if condition.type not in (BOOL, ERRONEOUS):
        kind = as_typed(condition).type
        ctx.findings.error(
            "FB4013",
            f"the condition of {keyword} is {spelled(kind)}, not BOOL",
            node.span,
            "compare it with something: x <> 0",
        )
    return condition


def _assignment(ctx: Context, node: ast.Assignment) -> Sequence[Statement]:
    meant = written_character(ctx, node)
    if meant is None:
        return check_assignment(ctx, node)
    return _if(ctx, meant) if isinstance(meant, ast.If) else meant


def _if(ctx: Context, node: ast.If) -> Sequence[Statement]:
    branches = tuple(
        checked.Branch(
            branch.span,
            _condition(ctx, branch.condition, "IF"),
            check_body(ctx, branch.body),
        )
        for branch in node.branches
    )
    otherwise = check_body(ctx, node.otherwise.body) if node.otherwise else ()
    return (checked.If(node.span, branches, otherwise),)


def _case(ctx: Context, node: ast.Case) -> Sequence[Statement]:
    if asks_for_type(ctx, node.selector):
        bodies = [check_body(ctx, arm.body) for arm in node.arms]
        bodies.append(check_body(ctx, node.otherwise.body) if node.otherwise else ())
        return (case_of_type(ctx, node, bodies),)
    selector = as_typed(check_expression(ctx, node.selector))
    kind: Elementary | None = None
    if isinstance(selector.type, Elementary) and selector.type.family in _SELECTORS:
        kind = selector.type
    elif isinstance(selector.type, Elementary) and _selects(ctx, selector.type):
        kind = selector.type
        selector = checked.Convert(selector.span, selector, WORD if kind.bits == 16 else BYTE)
    elif selector.type != ERRONEOUS:
        ctx.findings.error(
            "FB4031",
            f"CASE selects by a whole number, not by {spelled(selector.type)}",
            node.selector.span,
            "use an integer variable, or IF and ELSIF",
        )
    taken: list[tuple[int, int, Span]] = []
    arms = []
    for arm in node.arms:
        ranges = [_label_range(ctx, label, kind) for label in arm.labels]
        known = [found for found in ranges if found is not None]
        taken += known
        bounds = tuple((first, last) for first, last, _ in known)
        arms.append(checked.CaseArm(arm.span, bounds, check_body(ctx, arm.body)))
    _report_overlaps(ctx, taken)
    otherwise = check_body(ctx, node.otherwise.body) if node.otherwise else ()
    return (checked.Case(node.span, selector, tuple(arms), otherwise),)


def _selects(ctx: Context, kind: Elementary) -> bool:
    """CASE by a character: IEC 61131-3 takes every elementary type, S7 numbers only."""
    return kind.family is Family.CHAR and ctx.rules.dialect == "iec"


def _label_range(
    ctx: Context, label: ast.Expression | ast.LabelRange, kind: Elementary | None
) -> tuple[int, int, Span] | None:
    if isinstance(label, ast.LabelRange):
        first, last = _label(ctx, label.first, kind), _label(ctx, label.last, kind)
    else:
        first = last = _label(ctx, label, kind)
    if first is None or last is None:
        return None
    if first > last:
        ctx.findings.error(
            "FB4032",
            f"the range {first}..{last} is empty",
            label.span,
            f"write {last}..{first}",
        )
        return None
    return first, last, label.span


def _label(ctx: Context, node: ast.Expression, kind: Elementary | None) -> int | None:
    value = check_expression(ctx, node, kind)
    if kind is not None and value.type != ERRONEOUS and isinstance(value, Constant):
        value = coerce(ctx, value, kind, "this CASE label")
    if value.type == ERRONEOUS:
        return None
    if not isinstance(value, Constant):
        ctx.findings.error(
            "FB4017",
            "a CASE label has to be constant",
            node.span,
            "use literals and VAR CONSTANT names only, or IF and ELSIF",
        )
        return None
    if kind is not None and kind.family is Family.CHAR:
        return ord(str(value.value))
    return int(value.value) if isinstance(value.value, int) else None


def _report_overlaps(ctx: Context, taken: list[tuple[int, int, Span]]) -> None:
    """Each label that an earlier one covers, with the place of that one."""
    ordered = sorted(taken, key=lambda item: (item[0], item[2].start))
    widest: tuple[int, int, Span] | None = None
    for item in ordered:
        if widest is not None and item[0] <= widest[1]:
            early, late = sorted((widest, item), key=lambda one: one[2].start)
            ctx.findings.error(
                "FB4030",
                f"CASE label {late[2].text} is taken already",
                late[2],
                "each value can select one arm only: change one of the labels",
                (Note("the first one is here", early[2]),),
            )
        if widest is None or item[1] > widest[1]:
            widest = item


def _for(ctx: Context, node: ast.For) -> Sequence[Statement]:
    variable = check_target(ctx, node.variable, "FOR")
    kind = variable.type if variable is not None else None
    counts = ctx.rules.bits_are_numbers and kind in UNSIGNED_OF
    if kind is not None and not (isinstance(kind, Elementary) and (kind.is_integer or counts)):
        ctx.findings.error(
            "FB4033",
            f"FOR counts in an integer variable, not in {spelled(kind)}",
            node.variable.span,
            "declare the variable as INT or DINT",
        )
        kind = None
    counter = kind if isinstance(kind, Elementary) else None
    first = _bound(ctx, node.first, counter, "the start of FOR")
    last = _end(ctx, node.last, counter)
    step = _step(ctx, node, counter)
    body = _loop_body(ctx, node)
    if variable is None or counter is None or step is None:
        return ()
    return (checked.For(node.span, variable, first, last, step, body),)


def _bound(ctx: Context, node: ast.Expression, kind: Elementary | None, where: str) -> Expression:
    value = check_expression(ctx, node, kind)
    return value if kind is None else coerce(ctx, value, kind, where)


def _end(ctx: Context, node: ast.Expression, kind: Elementary | None) -> Expression:
    """The end; CODESYS and TwinCAT compare it with a variable of another integer type, too."""
    if kind is None or not ctx.rules.sign_may_change:
        return _bound(ctx, node, kind, "the end of FOR")
    value = check_expression(ctx, node, kind)
    if isinstance(value, Constant):
        return coerce(ctx, value, kind, "the end of FOR")
    number = as_counted(ctx, value)
    is_whole = isinstance(number.type, Elementary) and number.type.is_integer
    return converted(number, kind) if is_whole else coerce(ctx, value, kind, "the end of FOR")


def _step(ctx: Context, node: ast.For, kind: Elementary | None) -> Expression | None:
    """The step in the variable's type; a negative constant of an unsigned one in its signed."""
    if node.step is None:
        return None if kind is None else Constant(node.span, 1, counting_type(kind))
    kind = None if kind is None else counting_type(kind)
    step = check_expression(ctx, node.step, kind)
    if kind is None or step.type == ERRONEOUS:
        return None
    if isinstance(step, Constant):
        if step.value == 0:
            ctx.findings.error(
                "FB4035",
                "FOR with a step of 0 never ends",
                node.step.span,
                "leave BY out to count up by 1",
            )
            return None
        if isinstance(step.value, int) and step.value < 0 and kind in SIGNED_OF:
            kind = SIGNED_OF[kind]
    return coerce(ctx, step, kind, "the step of FOR")


def _loop_body(ctx: Context, node: ast.For | ast.While | ast.Repeat) -> tuple[Statement, ...]:
    around = ctx.loops
    ctx.loops = (*around, node.span)
    body = check_body(ctx, node.body)
    ctx.loops = around
    return body


def _while(ctx: Context, node: ast.While) -> Sequence[Statement]:
    condition = _condition(ctx, node.condition, "WHILE")
    return (checked.While(node.span, condition, _loop_body(ctx, node)),)


def _repeat(ctx: Context, node: ast.Repeat) -> Sequence[Statement]:
    body = _loop_body(ctx, node)
    return (checked.Repeat(node.span, body, _condition(ctx, node.condition, "UNTIL")),)


def _try(ctx: Context, node: ast.Try) -> Sequence[Statement]:
    return check_try(ctx, node, check_body)


def _region(ctx: Context, node: ast.Region) -> Sequence[Statement]:
    return check_body(ctx, node.body)


def _jump(ctx: Context, node: ast.Jump) -> Sequence[Statement]:
    if node.keyword == "RETURN":
        return (checked.Return(node.span),)
    if not ctx.loops:
        ctx.findings.error(
            "FB4034",
            f"{node.keyword} stands outside of a loop",
            node.span,
            "use RETURN to leave the block",
        )
        return ()
    return (checked.Exit(node.span) if node.keyword == "EXIT" else checked.Continue(node.span),)


def _empty(_ctx: Context, _node: ast.Empty) -> Sequence[Statement]:
    return ()


_CHECKS: dict[type, Callable[[Context, Any], Sequence[Statement]]] = {
    ast.Assignment: _with_copies(_assignment),
    ast.CallStatement: _with_copies(_call),
    ast.If: _if,
    ast.Case: _case,
    ast.For: _for,
    ast.While: _while,
    ast.Repeat: _repeat,
    ast.Try: _try,
    ast.Region: _region,
    ast.Jump: _jump,
    ast.Goto: check_goto,
    ast.Label: check_label,
    ast.Empty: _empty,
}
