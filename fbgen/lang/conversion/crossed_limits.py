"""LIMIT whose lower limit lies above the upper one: TIA Portal gives IN then, the others MX.

`LIMIT(MN := a, IN := x, MX := b)` of `tia` becomes `SEL(a > b, LIMIT(a, x, b), x)`, and that of the
others `MIN(MAX(x, a), b)`. Where the limits are constants in the right order nothing changes.
Source: TIA Portal help, "LIMIT: Set limit value"; IEC 61131-3 third edition, table 33.
"""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    Binary,
    Block,
    Call,
    Expression,
    File,
    Literal,
    Name,
    Parenthesized,
    Unary,
)
from fbgen.lang.checker import RULES
from fbgen.lang.checker.calls.standard_calls import is_standard_function
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.plant import BlockScope, PlantText
from fbgen.lang.rewriting import Rewriter, Rule, rewritten
from fbgen.lang.standard_parameters import STANDARD, standard_without_names
from fbgen.lang.walk import walk
from fbgen.source import Span

_LIMIT = "LIMIT"


def with_same_limits(files: Sequence[File], target: str, findings: Findings) -> list[File]:
    """The files, in their own dialect, with LIMITs that give the same in the other one."""
    dialect = files[0].dialect
    if RULES[dialect].crossed_limits_pass == RULES[target].crossed_limits_pass:
        return list(files)
    plant = PlantText(files)
    return rewritten(files, dialect, lambda unit: _Limits(plant, unit, dialect, findings))


class _Limits(Rewriter):
    """Rewrites one unit."""

    def __init__(self, plant: PlantText, unit: object, dialect: str, findings: Findings) -> None:
        self._plant = plant
        self._scope = BlockScope(plant, unit) if isinstance(unit, Block) else None
        self._passes = RULES[dialect].crossed_limits_pass
        self._findings = findings

    def _call(self, node: Call) -> Expression:
        call: Call = self.inside(node)
        if not (self._is_of_the_controller(call) and _name(call) == _LIMIT):
            return call
        given = [one.value for one in standard_without_names(call).arguments]
        low, operand, high = (*given, None, None, None)[:3]
        if low is None or operand is None or high is None:
            return call
        first, last = self._number(low), self._number(high)
        if first is not None and last is not None and first <= last:
            return call
        if len(given) != 3:
            hint = "give it constants, or compare the limits first"
            self._findings.refuse("LIMIT with EN or ENO, whose limits may cross,", call.span, hint)
            return call
        if not self._passes:
            return _called(call.span, "MIN", _called(call.span, "MAX", operand, low), high)
        if any(self._may_act(part) for one in (low, operand, high) for part in walk(one)):
            hint = "work out its operands into variables first"
            self._findings.refuse("LIMIT of calls, whose limits may cross,", call.span, hint)
            return call
        crossed = Binary(call.span, ">", _operand(low), _operand(high))
        return _called(call.span, "SEL", crossed, call, operand)

    def _is_of_the_controller(self, call: Call) -> bool:
        """True for a standard function, not for a block of the same name."""
        callee = call.callee
        return (
            isinstance(callee, Name)
            and not callee.quoted
            and is_standard_function(callee.name)
            and callee.name.casefold() not in self._plant.blocks
            and not (self._scope is not None and self._scope.is_declared(callee))
        )

    def _may_act(self, part: object) -> bool:
        """True for a call that must not happen twice."""
        return isinstance(part, Call) and not self._is_of_the_controller(part)

    def _number(self, node: Expression) -> int | float | None:
        """The value of a limit that is a constant."""
        if isinstance(node, Literal):
            return None if isinstance(node.value, str) else node.value
        if isinstance(node, Parenthesized):
            return self._number(node.inner)
        if isinstance(node, Name) and self._scope is not None:
            initial = self._scope.constants.get(node.name.casefold())
            return None if initial is None else self._number(initial)
        if isinstance(node, Unary) and node.operator == "-":
            value = self._number(node.operand)
            return None if value is None else -value
        return None

    rules: ClassVar[Mapping[type, Rule]] = {Call: _call}


def _called(place: Span, function: str, *operands: Expression) -> Call:
    """A standard function with the names of its parameters; the dialect takes them off again."""
    arguments = tuple(
        Argument(place, ArgumentKind.INPUT, name, operand)
        for name, operand in zip(STANDARD[function], operands, strict=False)
    )
    return Call(place, Name(place, function), arguments)


def _name(call: Call) -> str:
    return call.callee.name.upper() if isinstance(call.callee, Name) else ""


def _operand(node: Expression) -> Expression:
    return Parenthesized(node.span, node) if isinstance(node, Binary) else node
