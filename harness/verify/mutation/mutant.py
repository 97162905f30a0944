"""One small change of a block: what is exchanged in its checked tree, and in its text."""

from collections.abc import Sequence
from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Block, Expression, Statement
from fbgen.source import Span
from harness.verify.mutation.rebuilding import Node, with_nodes


class Operator(Enum):
    """The kinds of changes; `value` is the name on the command line and in the id of a mutant."""

    RELATIONAL = "relational"
    LOGICAL = "logical"
    ARITHMETIC = "arithmetic"
    CONSTANT = "constant"
    MASK = "mask"
    BITS = "bits"
    BYTE_ORDER = "byte_order"
    NEGATE = "negate"
    DROP = "drop"
    CASE = "case"
    TIMER = "timer"
    EDGE = "edge"

    @property
    def description(self) -> str:
        """What it does, for a person."""
        return _DESCRIPTIONS[self]


_DESCRIPTIONS = {
    Operator.RELATIONAL: "another comparison",
    Operator.LOGICAL: "AND for OR, OR for AND, a NOT left out",
    Operator.ARITHMETIC: "another operation, a sign left out",
    Operator.CONSTANT: "a number off by one, TRUE for FALSE",
    Operator.MASK: "a bit of a mask cleared, AND for OR between words",
    Operator.BITS: "a bit of a word moved to another place",
    Operator.BYTE_ORDER: "high and low byte exchanged",
    Operator.NEGATE: "a condition negated",
    Operator.DROP: "a statement left out",
    Operator.CASE: "the labels of two branches of a CASE exchanged",
    Operator.TIMER: "another time",
    Operator.EDGE: "a level where an edge is asked for",
}


@dataclass(frozen=True, slots=True)
class Edit:
    """A piece of text and what stands there instead."""

    span: Span
    text: str


@dataclass(frozen=True, slots=True)
class Exchange:
    """A node of the tree and what is there instead: nothing for a statement that is left out."""

    old: Node
    new: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Change:
    """What an operator proposes: exchanges in the tree, and the same in the text.

    `statement` is the innermost statement around it: who does not reach that never notices.
    """

    operator: Operator
    statement: Statement
    exchanges: tuple[Exchange, ...]
    edits: tuple[Edit, ...]


@dataclass(frozen=True, slots=True)
class Mutant:
    """A change with a name that stays the same as long as the text does.

    The id is `BLOCK:LINE:OPERATOR:N`: the line in the file of the block, and the number among the
    mutants of that operator in that line, from 1.
    """

    id: str
    block: Block
    change: Change

    @property
    def operator(self) -> Operator:
        """The kind of change."""
        return self.change.operator

    @property
    def place(self) -> Span:
        """Where the text changes first."""
        return self.change.edits[0].span

    def body(self, statements: Sequence[Statement]) -> tuple[Statement, ...]:
        """The statements of the block with the change."""
        return with_nodes(statements, {one.old: one.new for one in self.change.exchanges})


def exchanged(
    operator: Operator, statement: Statement, old: Expression, new: Expression, *edits: Edit
) -> Change:
    """A change of one expression."""
    return Change(operator, statement, (Exchange(old, (new,)),), edits)
