"""Conditions that can never decide alone, because of constants or of what others say as well.

A condition that stands twice in a decision has the same value in both places, and comparisons of
one value with several constants depend on each other: `x > 3` is TRUE wherever `x > 5` is. So not
every vector can occur. Where all vectors that can are tried and a condition decides in no pair of
them, no test can show it.
"""

from collections.abc import Hashable, Iterator, Sequence
from itertools import pairwise, product
from math import nan, prod
from operator import eq, ge, gt, le, lt, ne

from fbgen.lang.checked import (
    Binary,
    Constant,
    Convert,
    Expression,
    FieldRef,
    IndexRef,
    SliceRef,
    Unary,
    VariableRef,
)
from fbgen.lang.types import Elementary, Family, Type
from harness.engine.compiled.expressions.decisions import Decision, Fixed, Join, Not, Tree
from harness.verify.coverage.masking import shown_by

MOST_VECTORS = 512
"""Decisions with more vectors that may occur are not looked at: then nothing is excluded."""

_COMPARISONS = {"=": eq, "<>": ne, "<": lt, ">": gt, "<=": le, ">=": ge}
_TURNED = {"=": "=", "<>": "<>", "<": ">", ">": "<", "<=": ">=", ">=": "<="}
_Comparison = tuple[str, int | float]


def never_deciding(decision: Decision) -> frozenset[int]:
    """The conditions, by their numbers, that decide in no pair of vectors that can occur."""
    groups = _groups(decision.conditions)
    if len(groups) == len(decision.conditions) and not has_constants(decision.tree):
        return frozenset()
    patterns = [list(_patterns(decision.conditions, members)) for members in groups]
    if prod(map(len, patterns)) > MOST_VECTORS:
        return frozenset()
    vectors = [sum(parts) for parts in product(*patterns)]
    count = len(decision.conditions)
    return frozenset(
        number for number in range(count) if shown_by(decision.tree, number, count, vectors) is None
    )


def _groups(conditions: Sequence[Expression]) -> list[list[int]]:
    """The numbers of conditions that depend on each other."""
    groups: dict[Hashable, list[int]] = {}
    for number, condition in enumerate(conditions):
        compared = _compared(condition)
        key = _key(condition) if compared is None else ("compared", _key(compared[0]))
        groups.setdefault(key, []).append(number)
    return list(groups.values())


def _patterns(conditions: Sequence[Expression], members: Sequence[int]) -> Iterator[int]:
    """The values that the members can have together, as a part of the vector."""
    tests: list[_Comparison] = []
    for number in members:
        compared = _compared(conditions[number])
        if compared is None:
            yield 0
            yield sum(1 << one for one in members)
            return
        tests.append((compared[1], compared[2]))
    compared = _compared(conditions[members[0]])
    assert compared is not None, "members of one group are alike"
    samples = _samples({constant for _, constant in tests}, compared[0].type)
    seen = {
        sum(
            1 << number
            for number, (operator, constant) in zip(members, tests, strict=True)
            if _COMPARISONS[operator](sample, constant)
        )
        for sample in samples
    }
    yield from sorted(seen)


def _samples(constants: set[int | float], kind: Type) -> list[int | float]:
    """Values on all sides of the constants, as far as the type has them."""
    edges = sorted(constants)
    if not isinstance(kind, Elementary) or kind.family is Family.REAL:
        between = [(one + other) / 2 for one, other in pairwise(edges)]
        return [edges[0] - 1, *edges, *between, edges[-1] + 1, nan]
    near = {edge + step for edge in edges for step in (-1, 0, 1)}
    return [one for one in near if kind.minimum <= one <= kind.maximum]


def _compared(node: Expression) -> tuple[Expression, str, int | float] | None:
    """What a condition compares with a number, how, and the number."""
    if not isinstance(node, Binary) or node.operator not in _COMPARISONS:
        return None
    for one, other, operator in (
        (node.left, node.right, node.operator),
        (node.right, node.left, _TURNED[node.operator]),
    ):
        if isinstance(other, Constant) and isinstance(other.value, int | float):
            return one, operator, other.value
    return None


def _key(node: Expression) -> Hashable:
    """Equal for expressions that have the same value within one decision."""
    match node:
        case VariableRef() if node.variable.address is None:
            return id(node.variable)
        case FieldRef():
            return ("field", _key(node.base), node.name)
        case IndexRef():
            return ("index", _key(node.base), *map(_key, node.indices))
        case SliceRef():
            return ("slice", _key(node.base), node.index, node.type.bits)
        case Constant():
            return ("constant", repr(node.value))
        case Unary():
            return (node.operator, _key(node.operand))
        case Convert():
            return ("convert", _key(node.operand), repr(node.type))
        case Binary():
            return (node.operator, _key(node.left), _key(node.right))
        case _:
            # A call, or an access to hardware: it may give something else each time.
            return ("this", id(node))


def has_constants(tree: Tree) -> bool:
    """True if a constant is among what is joined."""
    match tree:
        case Not(operand):
            return has_constants(operand)
        case Join(_, left, right):
            return has_constants(left) or has_constants(right)
        case _:
            return isinstance(tree, Fixed)
