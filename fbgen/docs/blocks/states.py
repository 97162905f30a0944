"""The state machine of a block, found in its code: the number that it asks for and sets."""

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from fbgen.dataclass import dataclass
from fbgen.docs.blocks.reading import Parameter
from fbgen.docs.usage.places import inside, nodes
from fbgen.lang.checked import (
    Assignment,
    Binary,
    Block,
    Case,
    Constant,
    Expression,
    If,
    Statement,
    Unary,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.types import Elementary, Family

_NAME = re.compile(r"(\d+) ([^,0-9][^,]*)")
_MARK = re.compile(r'(?<![0-9A-Za-z])#|"')
_COMPARE: Mapping[str, Callable[[int, int], bool]] = {
    "=": lambda a, b: a == b,
    "<>": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    ">": lambda a, b: a > b,
    "<=": lambda a, b: a <= b,
    ">=": lambda a, b: a >= b,
}


@dataclass(frozen=True, slots=True)
class Transition:
    """From one of `sources` to `target` when the condition holds, in a line of the canonical text.

    `target` None: a number that the program works out, as `worked_out` says.
    """

    sources: tuple[int, ...]
    target: int | None
    condition: str
    worked_out: str = ""


@dataclass(frozen=True, slots=True)
class StateMachine:
    """The states with their names, as far as the declaration tells them, and the transitions."""

    variable: str
    names: Mapping[int, str]
    transitions: tuple[Transition, ...]

    def name(self, state: int) -> str:
        """`10 send spacer`."""
        return f"{state} {self.names[state]}".strip()

    def is_any(self, transition: Transition) -> bool:
        """Whether it can begin in every state, or in all but the one that it leads to."""
        others = set(self.names) - {transition.target}
        return len(self.names) > 2 and others <= set(transition.sources)


def state_machine(
    block: Block, body: Sequence[Statement], kept: Iterable[Parameter]
) -> StateMachine | None:
    """The machine of the number that the block asks for most; None for a block without one."""
    variable = _state_variable(body)
    if variable is None:
        return None
    comment = next((one.meaning for one in kept if one.name == variable.name), "")
    names = {int(number): text.strip() for number, text in _NAME.findall(comment)}
    states = sorted({*_states(body, variable), *names})
    finder = _Transitions(variable, tuple(states))
    finder.body(body, frozenset(states), ())
    found = tuple(dict.fromkeys(finder.found))
    if len(states) < 3 or len(found) < 3:
        return None
    return StateMachine(variable.name, {state: names.get(state, "") for state in states}, found)


def _state_variable(body: Sequence[Statement]) -> Variable | None:
    asked: Counter[Variable] = Counter()
    assigned: Counter[Variable] = Counter()
    for node in nodes(tuple(body)):
        if isinstance(node, Binary) and node.operator in ("=", "<>"):
            asked.update(_numbered(inside(node.left), inside(node.right)))
        elif isinstance(node, Case):
            asked.update(dict.fromkeys(_numbered(inside(node.selector)), len(node.arms)))
        elif isinstance(node, Assignment) and isinstance(inside(node.value), Constant):
            assigned.update(_numbered(node.target))
    both = [one for one in asked if asked[one] > 1 and assigned[one] > 1]
    return max(both, key=lambda one: (asked[one], one.name), default=None)


def _numbered(*values: object) -> Iterator[Variable]:
    """Variables that are whole numbers and stay from call to call."""
    for value in values:
        if isinstance(value, VariableRef):
            variable, kind = value.variable, value.variable.type
            whole = isinstance(kind, Elementary) and kind.family is Family.SIGNED
            lasting = variable.kind in (VariableKind.STATIC, VariableKind.OUTPUT)
            if whole and lasting:
                yield variable


def _states(body: Sequence[Statement], variable: Variable) -> Iterator[int]:
    for node in nodes(tuple(body)):
        if isinstance(node, Assignment) and _is(node.target, variable):
            value = inside(node.value)
            if isinstance(value, Constant):
                yield _number(value)
        elif isinstance(node, Binary) and node.operator in ("=", "<>"):
            for one, other in ((node.left, node.right), (node.right, node.left)):
                value = inside(other)
                if _is(inside(one), variable) and isinstance(value, Constant):
                    yield _number(value)
        elif isinstance(node, Case) and _is(inside(node.selector), variable):
            for arm in node.arms:
                for first, last in arm.ranges:
                    yield from range(first, min(last, first + 20) + 1)


def _is(place: object, variable: Variable) -> bool:
    return isinstance(place, VariableRef) and place.variable is variable


def _number(value: Constant) -> int:
    assert isinstance(value.value, int)
    return value.value


class _Transitions:
    """Goes through a body with the states in which each statement can be reached."""

    def __init__(self, variable: Variable, states: tuple[int, ...]) -> None:
        self._variable, self._states = variable, states
        self.found: list[Transition] = []

    def body(
        self, body: Sequence[Statement], states: frozenset[int], conditions: tuple[str, ...]
    ) -> None:
        for statement in body:
            if isinstance(statement, Assignment):
                self._assignment(statement, states, conditions)
            elif isinstance(statement, If):
                self._if(statement, states, conditions)
            elif isinstance(statement, Case):
                self._case(statement, states, conditions)

    def _assignment(
        self, statement: Assignment, states: frozenset[int], conditions: tuple[str, ...]
    ) -> None:
        if not _is(statement.target, self._variable):
            return
        value = inside(statement.value)
        shown = list(dict.fromkeys(one for one in conditions if one))
        text = " AND ".join(_bracketed(one, len(shown)) for one in shown) or "always"
        sources = tuple(sorted(states))
        if isinstance(value, Constant):
            target = _number(value)
            begin = tuple(one for one in sources if one != target) or sources
            self.found.append(Transition(begin, target, text))
        else:
            worked_out = _text(statement.value)
            self.found.append(Transition(sources, None, text, worked_out))

    def _if(self, statement: If, states: frozenset[int], conditions: tuple[str, ...]) -> None:
        left = states
        for branch in statement.branches:
            inner = frozenset(one for one in left if self._holds(branch.condition, one) != 0)
            shown = self._shown(branch.condition)
            self.body(branch.body, inner, (*conditions, shown))
            left = frozenset(one for one in left if self._holds(branch.condition, one) != 1)
        self.body(statement.otherwise, left, (*conditions, self._otherwise(statement)))

    def _otherwise(self, statement: If) -> str:
        shown = [self._shown(branch.condition) for branch in statement.branches]
        return "otherwise" if any(shown) else ""

    def _case(self, statement: Case, states: frozenset[int], conditions: tuple[str, ...]) -> None:
        own = _is(inside(statement.selector), self._variable)
        left = set(states)
        for arm in statement.arms:
            inner = states
            shown = ""
            if own:
                inner = frozenset(
                    one for one in states if any(low <= one <= high for low, high in arm.ranges)
                )
                left -= inner
            else:
                labels = ", ".join(
                    str(low) if low == high else f"{low}..{high}" for low, high in arm.ranges
                )
                shown = f"{_text(statement.selector)} = {labels}"
            self.body(arm.body, inner, (*conditions, shown))
        self.body(statement.otherwise, frozenset(left), conditions)

    def _holds(self, value: Expression, state: int) -> int:
        """0 not, 1 yes, 2 nobody knows, in this state."""
        value = inside(value)
        if isinstance(value, Constant):
            return int(bool(value.value))
        if isinstance(value, Unary) and value.operator == "NOT":
            return (1, 0, 2)[self._holds(value.operand, state)]
        if isinstance(value, Binary):
            if value.operator in _COMPARE:
                left, right = inside(value.left), inside(value.right)
                if _is(left, self._variable) and isinstance(right, Constant):
                    return int(_COMPARE[value.operator](state, _number(right)))
                return 2
            both = {self._holds(value.left, state), self._holds(value.right, state)}
            if value.operator in ("AND", "AND_THEN"):
                return 0 if 0 in both else 2 if 2 in both else 1
            if value.operator in ("OR", "OR_ELSE"):
                return 1 if 1 in both else 2 if 2 in both else 0
        return 2

    def _shown(self, condition: Expression) -> str:
        """The condition without what it says about the state."""
        parts = list(_conjuncts(condition))
        shown = [_text(one) for one in parts if not self._is_about_state(one)]
        return " AND ".join(_bracketed(one, len(shown)) for one in shown)

    def _is_about_state(self, value: Expression) -> bool:
        known = [self._holds(value, state) for state in self._states]
        return 2 not in known and len(set(known)) > 1


def _bracketed(text: str, among: int) -> str:
    """Alternatives among other conditions stand in brackets."""
    return f"({text})" if among > 1 and " OR " in text else text


def _conjuncts(value: Expression) -> Iterator[Expression]:
    plain = inside(value)
    if isinstance(plain, Binary) and plain.operator in ("AND", "AND_THEN"):
        yield from _conjuncts(plain.left)
        yield from _conjuncts(plain.right)
    else:
        yield value


def _text(value: Expression) -> str:
    """The source text in one line, without the marks of names."""
    return " ".join(_MARK.sub("", value.span.text).split())
