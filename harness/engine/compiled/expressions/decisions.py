"""Decisions: BOOL expressions as conditions that operators join, and the vector of their values.

Conditions are what the operators NOT, AND, OR, XOR, AND_THEN, OR_ELSE, and = and <> between BOOLs,
join. The vector is a whole number: bit i is the value of condition i, counted in the order of the
text; bit n + i says that condition i of n was not evaluated, because AND_THEN or OR_ELSE left it
out. All others are evaluated, as the language has it.

Where a probe asks for it, the generated code works out the vector and takes the result from a
mapping, `Results`: so each vector that occurs is noted at the cost of a look-up.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from fbgen.lang.checked import Binary, Constant, Expression, Unary
from fbgen.lang.types import BOOL
from harness.engine.compiled.code import Code, Level, deepest
from harness.engine.compiled.evaluation import value
from harness.engine.compiled.procedure import Procedure

MOST_CONDITIONS = 32
"""Decisions with more conditions are written as ever, and no vectors of them are noted."""

_JOINS = {"AND", "OR", "XOR", "AND_THEN", "OR_ELSE", "=", "<>"}


class Condition(NamedTuple):
    """A condition of a decision, by its number."""

    number: int


class Fixed(NamedTuple):
    """A constant in a decision."""

    value: bool


class Not(NamedTuple):
    """NOT."""

    operand: "Tree"


class Join(NamedTuple):
    """Two sides and AND, OR, XOR, AND_THEN, OR_ELSE, = or <>."""

    operator: str
    left: "Tree"
    right: "Tree"


Tree: TypeAlias = Condition | Fixed | Not | Join


class Decision(NamedTuple):
    """A BOOL expression taken apart; the conditions are in the order in which they stand."""

    tree: Tree
    conditions: tuple[Expression, ...]


def is_joined(node: Expression) -> bool:
    """True for NOT on a BOOL, and for two BOOLs with an operator."""
    if isinstance(node, Unary):
        return node.operator == "NOT" and node.type == BOOL
    return isinstance(node, Binary) and node.operator in _JOINS and node.left.type == BOOL


def decision(node: Expression) -> Decision | None:
    """The decision that an expression is; None with less than two or too many conditions."""
    conditions: list[Expression] = []
    if not is_joined(node) or not _collect(node, conditions):
        return None
    if not 2 <= len(conditions) <= MOST_CONDITIONS:
        return None
    numbers = {id(one): number for number, one in enumerate(conditions)}
    return Decision(_tree(node, numbers), tuple(conditions))


def _collect(node: Expression, conditions: list[Expression]) -> bool:
    """The conditions from left to right; False as soon as there are too many."""
    waiting = [node]
    while waiting:
        one = waiting.pop()
        if not is_joined(one):
            if not isinstance(one, Constant):
                conditions.append(one)
        elif isinstance(one, Unary):
            waiting.append(one.operand)
        elif isinstance(one, Binary):
            waiting += (one.right, one.left)
        if len(conditions) + len(waiting) > 2 * MOST_CONDITIONS:
            return False
    return True


def _tree(node: Expression, numbers: dict[int, int]) -> Tree:
    if isinstance(node, Constant):
        return Fixed(bool(node.value))
    if not is_joined(node):
        return Condition(numbers[id(node)])
    if isinstance(node, Unary):
        return Not(_tree(node.operand, numbers))
    assert isinstance(node, Binary)
    return Join(node.operator, _tree(node.left, numbers), _tree(node.right, numbers))


def result(tree: Tree, vector: int) -> bool:
    """What a decision gives for a vector."""
    match tree:
        case Condition(number):
            return bool(vector >> number & 1)
        case Fixed(content):
            return content
        case Not(operand):
            return not result(operand, vector)
        case Join("AND" | "AND_THEN", left, right):
            return result(left, vector) and result(right, vector)
        case Join("OR" | "OR_ELSE", left, right):
            return result(left, vector) or result(right, vector)
        case Join("=", left, right):
            return result(left, vector) == result(right, vector)
        case Join(_, left, right):
            return result(left, vector) != result(right, vector)


def conditions_in(tree: Tree) -> frozenset[int]:
    """The numbers of the conditions in a part of a decision."""
    match tree:
        case Condition(number):
            return frozenset((number,))
        case Fixed():
            return frozenset()
        case Not(operand):
            return conditions_in(operand)
        case Join(_, left, right):
            return conditions_in(left) | conditions_in(right)


class Results(dict[int, bool]):
    """The results of a decision, or of a part of it, for the vectors that have occurred."""

    def __init__(self, tree: Tree) -> None:
        self.tree = tree

    def __missing__(self, vector: int) -> bool:
        self[vector] = found = result(self.tree, vector)
        return found

    def plus(self, other: "Results") -> "Results":
        """The vectors that have occurred here or there, for the same decision."""
        both = Results(self.tree)
        both.update(self)
        both.update(other)
        return both


def write_decision(procedure: Procedure, node: Expression, names: Sequence[str]) -> Code:
    """A decision whose result is taken from mappings, which note its vectors."""
    found = decision(node)
    assert found is not None, "probes name mappings for decisions only"
    codes = [value(procedure, one) for one in found.conditions]
    vector = _vector(procedure, found.tree, codes)
    first, *others = names
    text = f"{first}[{vector}]"
    if others:
        name = procedure.temporary()
        more = ", ".join(f"{other}[{name}]" for other in others)
        text = f"({first}[{name} := {vector}], {more})[0]"
    return Code(
        text,
        depth=deepest(codes) + 4,
        safe=all(code.safe for code in codes),
        pure=all(code.pure for code in codes),
    )


def _vector(procedure: Procedure, tree: Tree, codes: Sequence[Code]) -> str:
    """The Python text that gives the vector of the conditions in a part of a decision."""
    match tree:
        case Condition(number):
            code = codes[number]
            return f"{code.at(Level.SHIFT)} << {number}" if number else code.at(Level.BIT_OR)
        case Fixed():
            return "0"
        case Not(operand):
            return _vector(procedure, operand, codes)
        case Join("AND_THEN" | "OR_ELSE" as operator, left, right):
            name = procedure.temporary()
            known = procedure.context.table("part", Results(left))
            begin = f"({name} := {_vector(procedure, left, codes)})"
            then = f"({_vector(procedure, right, codes)})"
            left_out = str(sum(1 << number + len(codes) for number in conditions_in(right)))
            if operator == "OR_ELSE":
                then, left_out = left_out, then
            return f"{begin} | ({then} if {known}[{name}] else {left_out})"
        case Join(_, left, right):
            return f"{_vector(procedure, left, codes)} | {_vector(procedure, right, codes)}"
