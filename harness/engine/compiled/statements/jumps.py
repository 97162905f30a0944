"""Bodies with GOTO: a loop around numbered segments.

Branches with a label and loops with a label or a jump are taken apart: they become jumps between
segments; everything else is written as ever. A segment runs if its number is not below `at`, so
that one segment falls through to the next, and a jump only sets `at`.
"""

from collections.abc import Callable, Sequence
from typing import Protocol

from fbgen.lang.checked import (
    Branch,
    Case,
    CaseArm,
    Continue,
    Exit,
    For,
    Goto,
    If,
    Label,
    Repeat,
    Statement,
    While,
)
from harness.engine.compiled.evaluation import condition, value
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.statements.loops import Counting, count_passes
from harness.engine.compiled.statements.selection import arm_condition, write_case, write_if
from harness.engine.compiled.walk import Node, children, nodes_of
from harness.engine.compiled.watching.probes import Moment, Probed

DEEPEST_IN_PLACE = 40
"""Nodes inside each other up to which a branch with jumps is written in its place."""


_JUMPS = frozenset((Label, Goto))


def has_jumps(body: Sequence[Statement]) -> bool:
    """True if there is a label or a GOTO anywhere inside."""
    return next(nodes_of(_JUMPS, body), None) is not None


def _stays(statement: If | Case) -> bool:
    """True if nothing jumps into the branches, and Python can nest them."""
    waiting: list[tuple[Node, int]] = [(statement, 1)]
    while waiting:
        node, depth = waiting.pop()
        if isinstance(node, Label) or depth > DEEPEST_IN_PLACE:
            return False
        if isinstance(node, For | While | Repeat) and has_jumps((node,)):
            return False
        waiting += [(child, depth + 1) for child in children(node)]
    return True


class WritePlain(Protocol):
    """Writes statements without labels and jumps, one after the other."""

    def __call__(self, procedure: Procedure, body: Sequence[Statement]) -> None: ...


class _Loop:
    """A loop that was taken apart: where EXIT and CONTINUE go."""

    __slots__ = ("exit_label", "next_label")

    def __init__(self, exit_label: str, next_label: str) -> None:
        self.exit_label = exit_label
        self.next_label = next_label


class Dispatcher:
    """Writes one body with jumps."""

    __slots__ = (
        *("_at", "_count", "_jumped", "_jumps", "_loops", "_numbers", "_plain"),
        *("_procedure", "_segments", "_start"),
    )

    def __init__(self, procedure: Procedure, plain: WritePlain) -> None:
        self._procedure = procedure
        self._plain = plain
        self._at = procedure.context.names.give("at")
        self._numbers: dict[str, int] = {}
        self._jumps: list[tuple[int, str]] = []
        self._loops: list[_Loop] = []
        self._segments = 0
        self._start = 0
        self._count = 0
        self._jumped = False

    def write(self, body: Sequence[Statement]) -> None:
        """The whole body."""
        procedure = self._procedure
        procedure.line(f"{self._at} = 0")
        procedure.line("while True:")
        procedure.listing.indent += 4
        procedure.line(f"if {self._at} == 0:")
        procedure.listing.indent += 4
        self._start = len(procedure.listing.lines)
        self._statements(body)
        if self._is_empty:
            procedure.line("pass")
        procedure.listing.indent -= 4
        procedure.line("break")
        procedure.listing.indent -= 4
        lines = procedure.listing.lines
        for line, label in self._jumps:
            lines[line] = lines[line].replace("?", str(self._numbers[label]))

    # --- segments -----------------------------------------------------------------------------

    def _new_label(self) -> str:
        """A label that no PLC text can have."""
        self._count += 1
        return f"#{self._count}"

    def _land(self, label: str) -> None:
        """A new segment begins here."""
        procedure = self._procedure
        self._jumped = False
        if not self._is_empty:
            procedure.listing.indent -= 4
            self._segments += 1
            procedure.line(f"if {self._at} <= {self._segments}:")
            procedure.listing.indent += 4
            self._start = len(procedure.listing.lines)
        self._numbers[label] = self._segments

    @property
    def _is_empty(self) -> bool:
        """True while the present segment has no lines."""
        return len(self._procedure.listing.lines) == self._start

    def _jump(self, label: str) -> None:
        """Go on at a label; not written where a jump stands directly before."""
        if self._jumped:
            return
        self._jumped = True
        procedure = self._procedure
        self._jumps.append((len(procedure.listing.lines), label))
        procedure.line(f"{self._at} = ?")
        procedure.line("continue")

    def _jump_if(self, text: str, label: str) -> None:
        procedure = self._procedure
        procedure.line(f"if {text}:")
        procedure.listing.indent += 4
        self._jump(label)
        procedure.listing.indent -= 4
        self._jumped = False

    # --- statements ---------------------------------------------------------------------------

    def _statements(self, body: Sequence[Statement]) -> None:
        plain: list[Statement] = []
        for statement in body:
            write = self._writer(statement)
            if write is None:
                plain.append(statement)
                continue
            self._whole(plain)
            plain = []
            self._procedure.enter(statement.span)
            self._begin(statement)
            write(statement)
            if isinstance(statement, If | Case | For | While | Repeat):
                self._probe(statement, Moment.AFTER)
            self._procedure.nesting -= 1
        self._whole(plain)

    def _whole(self, body: Sequence[Statement]) -> None:
        """Statements that nothing jumps into or out of."""
        if body:
            self._jumped = False
            self._plain(self._procedure, body)

    def _nested(
        self, procedure: Procedure, body: Sequence[Statement], owner: Probed | None = None
    ) -> None:
        """A branch that stays where it is: jumps lead out of it, but not into it."""
        listing = procedure.listing
        listing.indent += 4
        before = len(listing.lines)
        self._jumped = False
        if owner is not None:
            self._probe(owner, Moment.INSIDE)
        self._statements(body)
        if len(listing.lines) == before:
            procedure.line("pass")
        self._jumped = False
        listing.indent -= 4

    def _begin(self, statement: Statement) -> None:
        procedure = self._procedure
        procedure.listing.span = statement.span
        procedure.forget_sites()
        if not isinstance(statement, Label):
            self._probe(statement, Moment.BEFORE)

    def _probe(self, node: Probed, moment: Moment) -> None:
        if self._procedure.probed(node, moment):
            self._procedure.listing.span = node.span
            self._procedure.probe(node, moment)
            self._jumped = False

    def _writer(self, statement: Statement) -> Callable[..., None] | None:
        """How a statement is taken apart; None for one that stays whole."""
        if isinstance(statement, Exit | Continue):
            return self._leave
        if isinstance(statement, Label):
            return self._label
        if isinstance(statement, Goto):
            return self._goto
        if not (has_jumps((statement,)) or self._leaves(statement)):
            return None
        apart: dict[type, Callable[..., None]] = {
            If: self._if,
            Case: self._case,
            For: self._for,
            While: self._while,
            Repeat: self._repeat,
        }
        if isinstance(statement, If | Case) and _stays(statement):
            return self._in_place
        return apart.get(type(statement))

    def _in_place(self, node: If | Case) -> None:
        if isinstance(node, If):
            write_if(self._procedure, node, self._nested)
        else:
            write_case(self._procedure, node, self._nested)

    def _leaves(self, statement: Statement) -> bool:
        """True if an EXIT or CONTINUE inside belongs to a loop that was taken apart."""
        if not self._loops or isinstance(statement, For | While | Repeat):
            return False
        stack: list[Statement | Branch | CaseArm] = [statement]
        while stack:
            match node := stack.pop():
                case Exit() | Continue():
                    return True
                case If():
                    stack += [*node.branches, *node.otherwise]
                case Case():
                    stack += [*node.arms, *node.otherwise]
                case Branch() | CaseArm():
                    stack += node.body
                case _:
                    pass
        return False

    def _label(self, node: Label) -> None:
        self._land(node.name)

    def _goto(self, node: Goto) -> None:
        if node.backward:
            count_passes(self._procedure, "1")
            self._jumped = False
        self._jump(node.label)

    def _leave(self, node: Exit | Continue) -> None:
        loop = self._loops[-1]
        self._jump(loop.exit_label if isinstance(node, Exit) else loop.next_label)

    def _condition(self, branch: Branch | While | Repeat) -> str:
        procedure = self._procedure
        procedure.forget_sites()
        procedure.listing.span = branch.condition.span
        return condition(procedure, branch.condition)

    def _if(self, node: If) -> None:
        end = self._new_label()
        for branch in node.branches:
            other = self._new_label()
            self._jump_if(f"not ({self._condition(branch)})", other)
            self._probe(branch, Moment.INSIDE)
            self._statements(branch.body)
            self._jump(end)
            self._land(other)
        self._probe(node, Moment.INSIDE)
        self._statements(node.otherwise)
        self._land(end)

    def _case(self, node: Case) -> None:
        procedure = self._procedure
        procedure.listing.span = node.selector.span
        name = procedure.temporary()
        procedure.line(f"{name} = {value(procedure, node.selector).text}")
        end, labels = self._new_label(), [self._new_label() for _ in node.arms]
        for arm, label in zip(node.arms, labels, strict=True):
            procedure.listing.span = arm.span
            self._jump_if(arm_condition(name, arm), label)
        self._probe(node, Moment.INSIDE)
        self._statements(node.otherwise)
        for arm, label in zip(node.arms, labels, strict=True):
            self._jump(end)
            self._land(label)
            self._probe(arm, Moment.INSIDE)
            self._statements(arm.body)
        self._land(end)

    # --- loops --------------------------------------------------------------------------------

    def _body(self, node: For | While | Repeat, exit_label: str, next_label: str) -> None:
        self._loops.append(_Loop(exit_label, next_label))
        count_passes(self._procedure, "1")
        self._probe(node, Moment.INSIDE)
        self._statements(node.body)
        self._loops.pop()

    def _while(self, node: While) -> None:
        end, top = self._new_label(), self._new_label()
        self._land(top)
        self._jump_if(f"not ({self._condition(node)})", end)
        self._procedure.listing.span = node.span
        self._body(node, end, top)
        self._jump(top)
        self._land(end)

    def _repeat(self, node: Repeat) -> None:
        end, top, until = self._new_label(), self._new_label(), self._new_label()
        self._land(top)
        self._body(node, end, until)
        self._land(until)
        self._jump_if(f"not ({self._condition(node)})", top)
        self._probe(node, Moment.ENDED)
        self._land(end)

    def _for(self, node: For) -> None:
        procedure = self._procedure
        end, top, following = self._new_label(), self._new_label(), self._new_label()
        counting = Counting(procedure, node)
        self._land(top)
        self._jump_if(f"not ({counting.goes_on})", end)
        self._body(node, end, following)
        self._land(following)
        counting.advance(lambda: self._jump(end))
        self._jumped = False
        self._jump(top)
        self._land(end)
