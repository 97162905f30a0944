"""What a run of the unchanged program could notice of each mutant.

In front of every statement with mutants stands a question: would it do something else if it were
changed? A run that answers none of a mutant's questions with yes goes on exactly like the run of
the mutant, so that one need not be run. Where the question cannot be asked without side effects, or
costs more than it is worth, a statement that is reached counts as changed.
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce

from fbgen.lang.checked import (
    Assignment,
    Binary,
    Branch,
    Case,
    Constant,
    Convert,
    Expression,
    FieldRef,
    For,
    If,
    IndexRef,
    InstanceCall,
    Repeat,
    SliceRef,
    StandardCall,
    Statement,
    Try,
    Unary,
    VariableRef,
    While,
)
from fbgen.lang.types import BOOL, VOID, Elementary, Family, StringType, Subrange
from harness.engine.compiled.walk import every_node
from harness.engine.compiled.watching.probes import Moment, Probe, Probed
from harness.verify.mutation.mutant import Change, Exchange, Mutant, Operator
from harness.verify.mutation.places import read_by
from harness.verify.mutation.rebuilding import Node, with_nodes

REACHED, CHANGED = 1, 2
"""What a run says of a mutant: its statement was run; it would have done something else."""

_SEEN = "_seen_of_mutants"


class Watch:
    """Statements of a block that note which of some mutants a run would notice.

    They write a number for each mutant into `seen`: `REACHED`, `CHANGED`, both or 0.
    """

    def __init__(
        self, body: Sequence[Statement], mutants: Sequence[Mutant], seen: bytearray
    ) -> None:
        self._seen = seen
        self._lines: dict[tuple[int, Moment], str] = {}
        self._questions: dict[Statement, list[If]] = {}
        for number, mutant in enumerate(mutants):
            question = self._question(number, mutant.change)
            self._questions.setdefault(mutant.change.statement, []).append(question)
        self.body = self._asking(body)

    def _question(self, number: int, change: Change) -> If:
        span = change.statement.span
        answer = Branch(span, _differs(change) or Constant(span, True, BOOL), ())
        question = If(span, (answer,), ())
        self._lines[id(question), Moment.BEFORE] = f"{_SEEN}[{number}] |= {REACHED}"
        self._lines[id(answer), Moment.INSIDE] = f"{_SEEN}[{number}] |= {CHANGED}"
        return question

    def _asking(self, body: Sequence[Statement]) -> tuple[Statement, ...]:
        """The statements, the questions in front of each."""
        asking: list[Statement] = []
        for statement in body:
            asking += self._questions.get(statement, ())
            asking.append(self._inside(statement))
        return tuple(asking)

    def _inside(self, statement: Statement) -> Statement:
        match statement:
            case If():
                branches = tuple(
                    replace(one, body=self._asking(one.body)) for one in statement.branches
                )
                otherwise = self._asking(statement.otherwise)
                return replace(statement, branches=branches, otherwise=otherwise)
            case Case():
                arms = tuple(replace(one, body=self._asking(one.body)) for one in statement.arms)
                return replace(statement, arms=arms, otherwise=self._asking(statement.otherwise))
            case For() | While() | Repeat():
                return replace(statement, body=self._asking(statement.body))
            case Try():
                return replace(
                    statement,
                    body=self._asking(statement.body),
                    catch=self._asking(statement.catch),
                    final=self._asking(statement.final),
                )
            case _:
                return statement

    def _line(self, node: Probed, moment: Moment) -> str:
        return self._lines.get((id(node), moment), "")

    @property
    def probe(self) -> Probe:
        """What the engine needs to run the questions."""
        return Probe(self._line, {_SEEN: self._seen})


# --- questions ------------------------------------------------------------------------------------


def _differs(change: Change) -> Expression | None:
    """What is TRUE where the change matters; None if that cannot be asked."""
    statement, exchange = change.statement, change.exchanges[0]
    if change.operator is Operator.DROP:
        if not isinstance(statement, Assignment):
            return None
        old, new = statement.value, statement.target
        return _unequal(old, new) if _can_be_asked(old, new, known=(old, new)) else None
    if len(change.exchanges) > 1 or isinstance(statement, For | While | Repeat):
        return None
    if isinstance(statement, If):
        return _another_branch(statement, exchange)
    if isinstance(statement, Assignment):
        return _another_value(statement.value, exchange)
    if isinstance(statement, Case | InstanceCall):
        for value in read_by(statement):
            if (asked := _another_value(value, exchange)) is not None:
                return asked
    return None


def _another_value(value: Expression, exchange: Exchange) -> Expression | None:
    new = _changed(value, exchange)
    if new is value or not _can_be_asked(value, new, known=(value,)):
        return None
    return _unequal(value, new)


def _another_branch(statement: If, exchange: Exchange) -> Expression | None:
    """TRUE if no earlier branch is taken and this condition changes."""
    before: list[Expression] = []
    statement_reads = (statement.branches[0].condition,)
    for branch in statement.branches:
        old = branch.condition
        new = _changed(old, exchange)
        if new is not old:
            if not _can_be_asked(*before, old, new, known=statement_reads):
                return None
            asked = (*(Unary(one.span, "NOT", one, BOOL) for one in before), _unequal(old, new))
            return reduce(lambda one, two: Binary(one.span, "AND_THEN", one, two, BOOL), asked)
        before.append(old)
    return None


def _changed(value: Expression, exchange: Exchange) -> Expression:
    if value is exchange.old:
        return exchange.new[0]  # type: ignore[return-value]
    (new,) = with_nodes((value,), {exchange.old: exchange.new})  # type: ignore[arg-type]
    return new  # type: ignore[return-value]


def _unequal(old: Expression, new: Expression) -> Expression:
    return Binary(old.span, "<>", old, new, BOOL)


_COUNTED = (Family.BITS, Family.SIGNED, Family.UNSIGNED, Family.DURATION, Family.BOOL)
_HARMLESS = ("SHL", "SHR", "ROL", "ROR", "SWAP", "MIN", "MAX", "LIMIT", "SEL", "ABS")


def _can_be_asked(*values: Expression, known: tuple[Expression, ...]) -> bool:
    """True if reading the values has no effect and cannot stop the program.

    `known` are those that the statement itself reads in any case, so places in them are there.
    """
    if not all(isinstance(one.type, Elementary | StringType) for one in values):
        return False
    if any(one.type == VOID for one in values):
        return False
    there = {id(node) for node in every_node(known)}
    return all(_is_harmless(node, there) for node in every_node(values))


def _is_harmless(node: Node, there: set[int]) -> bool:
    match node:
        case VariableRef():
            return node.variable.address is None
        case Constant() | FieldRef() | SliceRef() | Unary():
            return True
        case Binary():
            return node.operator not in ("/", "MOD", "**")
        case Convert():
            return not isinstance(node.type, Subrange) and all(
                isinstance(kind, Elementary) and kind.family in _COUNTED
                for kind in (node.type, node.operand.type)
            )
        case StandardCall():
            return node.name in _HARMLESS
        case IndexRef():
            return id(node) in there or all(isinstance(one, Constant) for one in node.indices)
        case _:
            return False
