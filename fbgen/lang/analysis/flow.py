"""The paths through one block: IF, CASE, loops, EXIT, CONTINUE, RETURN and jumps to labels.

Each statement is looked at once, in text order, so the time grows with the size of the block. On
the way two sets are carried (as bits of a whole number): the variables that every path to this
place has set, and those that at least one has. A block with backward jumps is gone over again
until the sets at its labels stay as they are.
"""

from typing import Any

from fbgen.lang import checked
from fbgen.lang.analysis import loops, statements
from fbgen.lang.analysis.comparisons import CopiedTexts, check_comparison
from fbgen.lang.analysis.conditions import (
    check_case,
    check_condition,
    check_repeated_conditions,
)
from fbgen.lang.analysis.effects import Effects, key_of, root_of
from fbgen.lang.analysis.facts import BlockFacts, CalledInstance
from fbgen.lang.analysis.instances import InstanceTracker, check_own_end
from fbgen.lang.analysis.report import Report
from fbgen.lang.analysis.unset import UnsetReads, tracked_variables
from fbgen.lang.checked import (
    AddressRef,
    Block,
    Constant,
    Expression,
    FieldRef,
    Place,
    Program,
    Statement,
    Variable,
    VariableRef,
)
from fbgen.lang.types import BlockType
from fbgen.source import Span

_EVERYTHING = -1
_MOST_ROUNDS = 50
"""Rounds for the labels of one block; each but the last takes away at least one bit."""


class _Loop:
    """A loop that is being followed, and what is set where EXIT and CONTINUE go.

    `is_left`: an EXIT of its own leaves it; `ways_out` are the RETURN and GOTO before it.
    """

    __slots__ = ("after", "first_write", "is_left", "next_pass", "ways_out")

    def __init__(self, first_write: int, ways_out: int) -> None:
        self.after: tuple[int, int] | None = None
        self.next_pass: tuple[int, int] | None = None
        self.first_write = first_write
        self.is_left = False
        self.ways_out = ways_out


class Flow:
    """Follows all paths through one block and reports what it sees on the way.

    `must` has the bits of what every path here has set, `may` of what some path has; `alive` is
    False where no path comes.
    """

    def __init__(self, block: Block, program: Program, vague: frozenset[Variable]) -> None:
        self.block = block
        self.program = program
        self.report = Report(vague)
        self.facts = BlockFacts(block)
        self.bits = tracked_variables(block, program)
        self.effects = Effects()
        self.copied = CopiedTexts()
        self.unset = UnsetReads(self.report)
        self.instances = InstanceTracker(self.report)
        self.must = 0
        self.may = 0
        self.alive = True
        self.depth = 0
        self.writes: list[tuple[Variable, Span, bool]] = []
        self.loops: list[_Loop] = []
        self.ways_out = 0
        self.ends: tuple[int, int] | None = None
        self.labels: dict[str, tuple[int, int]] = {}
        self.jumped: set[str] = set()
        self.places: dict[str, Span] = {}
        self.passed: dict[str, tuple[int, int] | None] = {}

    def run(self, body: tuple[Statement, ...]) -> None:
        """Follow the paths; afterwards `must`, `may` and `alive` are those at the end."""
        self.body(body)
        if self.alive:
            self.ends = _joined(self.ends, (self.must, self.may))
        self.alive = self.ends is not None
        self.must, self.may = self.ends or (_EVERYTHING, 0)

    @property
    def labels_are_settled(self) -> bool:
        """False if a jump backwards brought less to a label than was counted on."""
        return all(self.passed.get(name, state) == state for name, state in self.labels.items())

    # --- statements ---------------------------------------------------------------------------

    def body(self, statements_: tuple[Statement, ...]) -> None:
        """The statements of a list."""
        reported = False
        for statement in statements_:
            kind = type(statement)
            if not self.alive and kind not in _ARRIVALS:
                if not reported:
                    reported = True
                    statements.report_unreachable(self.report, statement)
                self.alive, self.must = True, _EVERYTHING
                _STEPS.get(kind, Flow._other)(self, statement)
                self.alive = False
            else:
                _STEPS.get(kind, Flow._other)(self, statement)

    def _assignment(self, node: checked.Assignment) -> None:
        self.effects.value(node.value)
        self.effects.target(node.target)
        statements.check_assignment(self.report, node)
        if type(node.value) in _COPIES:
            self.copied.copy(node.target.span.text, node.value.span.text)
        if isinstance(node.target, VariableRef):
            variable, value = node.target.variable, node.value
            if isinstance(value, checked.FunctionCall):
                self.facts.kept.append((variable, value))
            elif variable is self.block.result and isinstance(value, Constant):
                self.facts.always_true += value.value is True
        self._settle()

    def _evaluate(self, node: checked.Evaluate) -> None:
        if isinstance(node.call, checked.FunctionCall):
            self.effects.outside = True
            self.effects.arguments(node.call)
            self.facts.dropped.append(node.call)
        else:
            self.effects.value(node.call)
        self._settle()

    def _instance_call(self, node: checked.InstanceCall) -> None:
        key = key_of(node.instance)
        if key is not None and self.program.dialect == "tia":
            check_own_end(self.report, node, key, self.facts.members_read)
        self.effects.value(node.instance)
        self.effects.arguments(node)
        self.facts.instances.append(CalledInstance(node, key, self.depth))
        self._settle()
        if isinstance(node.block, checked.StandardBlock) and key is not None:
            self.instances.called(self, node, key, in_loop=bool(self.loops))

    def _if(self, node: checked.If) -> None:
        check_repeated_conditions(self.report, node.branches)
        after: tuple[int, int] | None = None
        self.depth += 1
        for branch in node.branches:
            self._condition(branch.condition)
            before = (self.must, self.may)
            self.body(branch.body)
            after = self._joined_here(after)
            self._at(before)
        self.body(node.otherwise)
        self.depth -= 1
        self._at(self._joined_here(after))

    def _case(self, node: checked.Case) -> None:
        self.effects.value(node.selector)
        self._settle()
        check_case(self.report, node)
        before = (self.must, self.may)
        after: tuple[int, int] | None = None
        self.depth += 1
        for arm in node.arms:
            self._at(before)
            self.body(arm.body)
            after = self._joined_here(after)
        self._at(before)
        self.body(node.otherwise)
        self.depth -= 1
        self._at(self._joined_here(after))

    def _for(self, node: checked.For) -> None:
        self.effects.value(node.first)
        self.effects.target(node.variable)
        self._settle()
        self.effects.value(node.last)
        self.effects.value(node.step)
        self._settle()
        if isinstance(node.variable, VariableRef):
            self.facts.read.add(node.variable.variable)
        before = (self.must, self.may)
        loop = self._enter()
        self.body(node.body)
        end = self._joined_here(loop.next_pass)
        loops.check_counter(self.report, node, self.writes[loop.first_write :])
        self._leave()
        runs = loops.surely_runs(node)
        after = end if runs else _joined(end, before)
        self._at(_joined(after, loop.after))

    def _while(self, node: checked.While) -> None:
        loop = self._enter()
        watched = self._loop_condition(node.condition)
        endless = loops.is_always(node.condition, True)
        before = None if endless else (self.must, self.may)
        self.body(node.body)
        end = self._joined_here(loop.next_pass)
        self._check_end(node, loop, watched)
        self._leave()
        after = None if endless else _joined(end, before)
        self._at(_joined(after, loop.after))

    def _repeat(self, node: checked.Repeat) -> None:
        loop = self._enter()
        self.body(node.body)
        self._at(self._joined_here(loop.next_pass))
        reached = self.alive
        watched = self._loop_condition(node.condition)
        endless = loops.is_always(node.condition, False)
        if reached:
            self._check_end(node, loop, watched)
        self._leave()
        after = (self.must, self.may) if reached and not endless else None
        self._at(_joined(after, loop.after))

    def _try(self, node: checked.Try) -> None:
        before = (self.must, self.may)
        self.depth += 1
        self.body(node.body)
        after = self._joined_here(None)
        self._at((before[0], self.may))
        if node.exception is not None:
            self.effects.target(node.exception)
            self._settle()
        self.body(node.catch)
        if node.catches:
            after = self._joined_here(after)
        self.depth -= 1
        self._at(after if node.final == () or after is not None else before)
        self.body(node.final)
        self._at(after and self._joined_here(None))

    def _exit(self, _node: checked.Exit) -> None:
        if self.loops:
            self.loops[-1].after = _joined(self.loops[-1].after, (self.must, self.may))
            self.loops[-1].is_left = True
        self.alive = False

    def _continue(self, _node: checked.Continue) -> None:
        if self.loops:
            self.loops[-1].next_pass = _joined(self.loops[-1].next_pass, (self.must, self.may))
        self.alive = False

    def _return(self, _node: checked.Return) -> None:
        self.ends = _joined(self.ends, (self.must, self.may))
        self.ways_out += 1
        self.alive = False

    def _stop(self, _node: checked.Stop) -> None:
        """What it would do is not known; a run on a controller goes on behind it."""

    def _goto(self, node: checked.Goto) -> None:
        key = node.label
        self.jumped.add(key)
        state = _joined(self.labels.get(key), (self.must, self.may))
        assert state is not None
        self.labels[key] = state
        self.ways_out += 1
        self.alive = False

    def _label(self, node: checked.Label) -> None:
        key = node.name
        self.places[key] = node.span
        known = self.labels.get(key)
        state = self._joined_here(known)
        if state is not None:
            self.labels[key] = state
        self.passed[key] = state
        self._at(state)

    def _other(self, node: Any) -> None:
        self.effects.value(node)
        self._settle()

    # --- conditions and loops -----------------------------------------------------------------

    def _condition(self, condition: Expression) -> None:
        self.effects.value(condition)
        check_condition(self.report, condition)
        self._settle()

    def _loop_condition(self, condition: Expression) -> frozenset[Variable] | None:
        """The variables that a condition depends on; None if something outside can change it."""
        self.effects.value(condition)
        watched = loops.watched_variables(self.effects)
        self._settle()
        return watched

    def _check_end(
        self,
        node: checked.While | checked.Repeat,
        loop: _Loop,
        watched: frozenset[Variable] | None,
    ) -> None:
        if not loop.is_left and self.ways_out == loop.ways_out:
            loops.check_end(self.report, node, watched, self.writes[loop.first_write :])

    def _enter(self) -> _Loop:
        loop = _Loop(len(self.writes), self.ways_out)
        self.loops.append(loop)
        self.unset.enter_loop()
        self.depth += 1
        return loop

    def _leave(self) -> None:
        loop = self.loops.pop()
        self.depth -= 1
        self.unset.leave_loop({variable for variable, _, _ in self.writes[loop.first_write :]})

    # --- what is set where --------------------------------------------------------------------

    def _joined_here(self, state: tuple[int, int] | None) -> tuple[int, int] | None:
        return _joined(state, (self.must, self.may)) if self.alive else state

    def _at(self, state: tuple[int, int] | None) -> None:
        self.alive = state is not None
        self.must, self.may = state if state is not None else (_EVERYTHING, self.may)

    def _settle(self) -> None:
        """Take over what the last expressions did."""
        effects, facts, bits = self.effects, self.facts, self.bits
        for ref in effects.reads:
            variable = ref.variable
            facts.read.add(variable)
            bit = bits.get(variable)
            if bit is not None and not self.must & bit:
                self.unset.read(variable, ref.span, bool(self.may & bit))
        for field in effects.members:
            facts.members_read.append(field)
        for comparison in effects.comparisons:
            check_comparison(self.report, comparison, self.copied)
        for division in effects.divisions:
            statements.report_division(self.report, division)
        for place in effects.writes:
            self._written(place)
        facts.uses_outside |= effects.outside
        for ref in effects.touched:
            facts.touched.add(ref.variable)
        effects.clear()

    def _written(self, place: Place) -> None:
        facts = self.facts
        if isinstance(place, VariableRef):
            variable: Variable | None = place.variable
        else:
            variable = root_of(place)
            node: Any = place
            while isinstance(node, FieldRef | checked.IndexRef | checked.SliceRef):
                if isinstance(node, FieldRef) and isinstance(node.base.type, BlockType):
                    facts.members_written.append(node)
                node = node.base
            if isinstance(node, AddressRef):
                facts.addresses_written.append(node)
        if variable is None:
            return
        facts.written.setdefault(variable, place.span)
        self.writes.append((variable, place.span, isinstance(place, VariableRef)))
        bit = self.bits.get(variable)
        if bit is not None:
            self.must |= bit
            self.may |= bit


def _joined(one: tuple[int, int] | None, other: tuple[int, int] | None) -> tuple[int, int] | None:
    """What is set where two paths meet; None is no path."""
    if one is None:
        return other
    if other is None:
        return one
    return one[0] & other[0], one[1] | other[1]


def follow(
    block: Block, body: tuple[Statement, ...], program: Program, vague: frozenset[Variable]
) -> Flow:
    """All paths through a block, followed to their ends."""
    flow = Flow(block, program, vague)
    flow.run(body)
    for _ in range(_MOST_ROUNDS):
        if flow.labels_are_settled:
            break
        again = Flow(block, program, vague)
        again.labels = flow.labels
        again.run(body)
        flow = again
    for key, place in flow.places.items():
        if key not in flow.jumped:
            statements.report_label(flow.report, place)
    flow.copied.report(flow.report)
    flow.instances.report_conditional()
    flow.unset.report_all()
    return flow


_ARRIVALS = (checked.Label,)
_COPIES = (VariableRef, FieldRef, checked.IndexRef, Constant)
_STEPS: dict[type, Any] = {
    checked.Assignment: Flow._assignment,
    checked.Evaluate: Flow._evaluate,
    checked.InstanceCall: Flow._instance_call,
    checked.If: Flow._if,
    checked.Case: Flow._case,
    checked.For: Flow._for,
    checked.While: Flow._while,
    checked.Repeat: Flow._repeat,
    checked.Try: Flow._try,
    checked.Exit: Flow._exit,
    checked.Continue: Flow._continue,
    checked.Return: Flow._return,
    checked.Stop: Flow._stop,
    checked.Goto: Flow._goto,
    checked.Label: Flow._label,
}
