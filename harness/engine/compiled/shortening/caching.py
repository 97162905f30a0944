"""Which attributes of `self` a stretch of statements may keep in Python locals, and should.

Reading a local is faster than reading an attribute. A composite variable is never bound anew, so
a local with it is always good. A single value may be kept while nobody but the statements
themselves can write it: writes then go to both, so that the attribute is right at any time. What it
saves is guessed from how often the variable is used: a loop counts for several passes, a branch
for part of one.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from fbgen.lang.checked import (
    LIVING,
    Assignment,
    Binary,
    Block,
    Branch,
    Case,
    Constant,
    Convert,
    Expression,
    FieldRef,
    For,
    If,
    IndexRef,
    Repeat,
    StandardCall,
    Statement,
    Unary,
    Variable,
    VariableKind,
    VariableRef,
    While,
)
from fbgen.lang.types import BOOL, VOID, ArrayType, StructType, Subrange
from fbgen.source import Source, Span
from harness.engine.compiled.data.model import is_scalar, may_be_unconnected
from harness.engine.compiled.shortening.facts import Facts
from harness.engine.compiled.shortening.paths import Path, fields_to, worth_naming
from harness.engine.compiled.shortening.ranges import is_counted
from harness.engine.compiled.walk import Node, children, every_node, nodes_of, root_of

_LOOP_WEIGHT = 6.0
_BRANCH_WEIGHT = 0.4
_WORTH = 2.5
_WORTH_IF_WRITTEN = 1.8
"""Weighted uses from which on a local pays; fewer if it need not be filled first."""

_KEPT_KINDS = (*LIVING, VariableKind.IN_OUT)


_NOBODY = Variable(Span(Source("", ""), 0, 0), "", VariableKind.TEMP, VOID)


_WEIGHED = frozenset((VariableRef, FieldRef, For, While, Repeat, If, Case))
"""The nodes that count for more or less than what is in them. All others are passed over fast."""


class _Uses:
    """How often a variable or a structure inside of one is used.

    `arms` are the branches that the uses stand in, `node` is one of the uses of a structure.
    """

    __slots__ = ("arms", "node", "weight")

    def __init__(self, node: FieldRef | None = None) -> None:
        self.weight = 0.0
        self.arms: set[object] = set()
        self.node = node

    @property
    def in_one_branch(self) -> bool:
        """True if all of it stands in one branch, which may see to it itself."""
        return len(self.arms) <= 1 and None not in self.arms


def _uses(body: Iterable[Statement]) -> tuple[dict[Variable, _Uses], dict[Path, _Uses]]:
    """The uses of the variables of the block, and of the structures in any structure."""
    found: dict[Variable, _Uses] = {}
    structures: dict[Path, _Uses] = {}
    stack: list[tuple[Node, float, object]] = [(statement, 1.0, None) for statement in body]
    while stack:
        node, weight, arm = stack.pop()
        if type(node) not in _WEIGHED:
            stack.extend((child, weight, arm) for child in children(node))
            continue
        match node:
            case VariableRef():
                if node.variable.kind in _KEPT_KINDS:
                    uses = found.setdefault(node.variable, _Uses())
                    uses.weight += weight
                    uses.arms.add(arm)
            case FieldRef() if (way := fields_to(node)) is not None:
                for path, field in way.paths():
                    uses = structures.setdefault(path, _Uses(field))
                    uses.weight += weight
                    uses.arms.add(arm)
                stack.append((way.root, weight, arm))
            case For():
                # The loop variable has a local of its own.
                uses = found.setdefault(root_of(node.variable) or _NOBODY, _Uses())
                uses.weight -= 1000
                stack.extend((child, weight * _LOOP_WEIGHT, arm) for child in children(node))
            case While() | Repeat():
                stack.extend((child, weight * _LOOP_WEIGHT, arm) for child in children(node))
            case If():
                stack.append((node.branches[0].condition, weight, arm))
                inner = weight * _BRANCH_WEIGHT
                for branch in node.branches:
                    if branch is not node.branches[0]:
                        stack.append((branch.condition, inner, arm))
                    stack.extend((one, inner, arm or branch) for one in branch.body)
                stack.extend((one, inner, arm or node) for one in node.otherwise)
            case Case():
                stack.append((node.selector, weight, arm))
                inner = weight * _BRANCH_WEIGHT
                for case_arm in node.arms:
                    stack.extend((one, inner, arm or case_arm) for one in case_arm.body)
                stack.extend((one, inner, arm or node) for one in node.otherwise)
            case _:
                stack.extend((child, weight, arm) for child in children(node))
    return found, structures


_VARIABLES = frozenset((VariableRef,))


def _written_first(body: Sequence[Statement]) -> set[Variable]:
    """The variables that get a value before anybody reads them."""
    first: set[Variable] = set()
    seen: set[Variable] = set()
    for statement in body:
        inside: list[Node] = [statement]
        target = statement.target if isinstance(statement, Assignment) else None
        if isinstance(statement, Assignment) and isinstance(target, VariableRef):
            # A composite one is not bound anew, it is copied into: that reads it.
            inside = [statement.value] if is_scalar(target.type) else [statement]
        seen.update(one.variable for one in nodes_of(_VARIABLES, inside))
        if not isinstance(target, VariableRef) or not is_scalar(target.type):
            continue
        if target.variable not in seen:
            first.add(target.variable)
    return first


class Kept(NamedTuple):
    """What statements should keep in locals.

    `variables` says for each variable whether its local must be filled before; `structures` has
    one use of each structure inside of another one, outer ones first.
    """

    variables: list[tuple[Variable, bool]]
    structures: list[tuple[Path, FieldRef]]


def worth_keeping(body: Sequence[Statement], block: Block, facts: Facts) -> Kept:
    """What these statements should keep in locals; what one branch uses alone is left to that."""
    found, structures = _uses(body)
    often = [
        variable
        for variable, uses in found.items()
        if uses.weight >= _WORTH_IF_WRITTEN
        and not uses.in_one_branch
        and variable.address is None
        and not may_be_unconnected(variable, block)
    ]
    written_first = _written_first(body) if often else set()
    wanted = [
        variable
        for variable in often
        if variable in written_first or found[variable].weight >= _WORTH
    ]
    singles = {variable for variable in wanted if is_scalar(variable.type)}
    kept = facts.private(singles, block, body) if singles else set()
    named = worth_naming(
        {
            path: uses.weight
            for path, uses in structures.items()
            if not uses.in_one_branch and _is_always_there(path[0], block)
        }
    )
    return Kept(
        [
            (variable, variable not in written_first)
            for variable in wanted
            if variable in kept or variable not in singles
        ],
        [(path, node) for path in named if (node := structures[path].node) is not None],
    )


def _is_always_there(variable: Variable, block: Block) -> bool:
    """True for a structure that a block has from its first statement on."""
    return (
        variable.kind in _KEPT_KINDS
        and variable.address is None
        and not may_be_unconnected(variable, block)
    )


# --- quiet loops ----------------------------------------------------------------------------------

_QUIET_FUNCTIONS = frozenset(
    ("SHL", "SHR", "ROL", "ROR", "SWAP", "MIN", "MAX", "LIMIT", "LIMIT_OR_IN", "SEL", "ABS")
)


def is_quiet(body: Sequence[Statement], interval: tuple[int, int], counter: Variable) -> bool:
    """True if a loop over `counter` cannot stop, be left, or call anything.

    While such a loop runs nobody sees the attributes of `self`, so that what it keeps in locals
    may be written back behind it.
    """
    return all(_is_quiet(node, interval, counter) for node in every_node(body))


def _is_quiet(node: Node, interval: tuple[int, int], counter: Variable) -> bool:
    match node:
        case If() | Branch():
            return True
        case VariableRef():
            variable = node.variable
            is_own = variable.kind not in (VariableKind.GLOBAL, VariableKind.IN_OUT)
            return is_own and variable.address is None
        case IndexRef():
            kind = node.base.type
            if not isinstance(kind, ArrayType) or len(node.indices) != 1:
                return False
            return _is_inside(node.indices[0], kind.bounds[0], interval, counter)
        case _:
            return only_calculates(node)


def only_calculates(node: Node) -> bool:
    """True if a node that is no variable, apart from what is in it, cannot stop or call."""
    match node:
        case Assignment() | Constant() | Unary():
            return True
        case FieldRef():
            return isinstance(node.base.type, StructType)
        case Binary():
            return node.operator not in ("/", "MOD", "**") and node.left.type == node.right.type
        case Convert():
            if isinstance(node.type, Subrange):
                return False
            return all(is_counted(kind) or kind == BOOL for kind in (node.type, node.operand.type))
        case StandardCall():
            return node.name in _QUIET_FUNCTIONS
        case _:
            return False


def _is_inside(
    index: Expression, bounds: tuple[int, int], interval: tuple[int, int], counter: Variable
) -> bool:
    if isinstance(index, Constant):
        return True
    is_counter = isinstance(index, VariableRef) and index.variable is counter
    return is_counter and bounds[0] <= interval[0] and interval[1] <= bounds[1]
