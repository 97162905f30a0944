"""The statements of a block, read into terms."""

from collections.abc import Sequence

import z3

from fbgen.lang.checked import (
    Assignment,
    Block,
    Case,
    CaseArm,
    Constant,
    Continue,
    Evaluate,
    Exit,
    FieldRef,
    For,
    FunctionCall,
    If,
    IndexRef,
    InstanceCall,
    Repeat,
    Return,
    StandardBlock,
    Statement,
    VariableKind,
    VariableRef,
    While,
)
from fbgen.lang.types import StringType
from harness.engine.compiled.walk import every_node, root_of, written_places
from harness.verify.mutation.proof import terms
from harness.verify.mutation.proof.expressions import Part, Reader, apply
from harness.verify.mutation.proof.loops import run_loop
from harness.verify.mutation.proof.terms import Term, UnknownError, is_single

_MOST_PASSES = 128
_PLACES = (VariableRef, FieldRef, IndexRef)


class Execution(Reader):
    """Carries statements out, in terms."""

    def run(self, body: Sequence[Statement]) -> None:
        """Statements one after the other."""
        for statement in body:
            self._statement(statement)

    def _statement(self, statement: Statement) -> None:
        memory = self.memory
        match statement:
            case Assignment():
                self._assign(statement)
            case If():
                self._if(statement, 0)
            case Case():
                self._case(self.value(statement.selector), statement, 0)
            case For():
                self._for(statement)
            case While() | Repeat():
                run_loop(self, statement)
            case InstanceCall():
                self._instance(statement)
            case Evaluate() if isinstance(statement.call, FunctionCall):
                self.function(statement.call)
            case Return():
                memory.returned = z3.Or(memory.returned, memory.runs)
            case Exit():
                memory.left = z3.Or(memory.left, memory.runs)
            case Continue():
                memory.next = z3.Or(memory.next, memory.runs)
            case _:
                raise UnknownError(f"a statement such as {type(statement).__name__}")

    def _assign(self, statement: Assignment) -> None:
        value = statement.value
        if isinstance(value.type, StringType) and value.type != statement.target.type:
            raise UnknownError("a text that may be cut")
        if is_single(value.type):
            self.write(statement.target, self.value(value))
        elif isinstance(value, _PLACES) and isinstance(statement.target, _PLACES):
            source = self.parts(value)
            target = self.parts(statement.target)
            for (_, _, term), (key, indices, _) in zip(source, target, strict=True):
                self.write_at(key, indices, term)
        else:
            raise UnknownError(f"a value of type {value.type}")

    # --- branches -----------------------------------------------------------------------------

    def _both(self, condition: Term, yes: Sequence[Statement]) -> "_Branches":
        return _Branches(self, condition, yes)

    def _if(self, statement: If, number: int) -> None:
        if number == len(statement.branches):
            self.run(statement.otherwise)
            return
        branch = statement.branches[number]
        condition = self.value(branch.condition)
        with self._both(condition, branch.body):
            self._if(statement, number + 1)

    def _case(self, selector: Term, statement: Case, number: int) -> None:
        if number == len(statement.arms):
            self.run(statement.otherwise)
            return
        arm = statement.arms[number]
        with self._both(self._chosen(selector, statement, arm), arm.body):
            self._case(selector, statement, number + 1)

    def _chosen(self, selector: Term, statement: Case, arm: CaseArm) -> Term:
        kind = statement.selector.type
        inside = []
        for first, last in arm.ranges:
            low, high = terms.constant(first, kind), terms.constant(last, kind)
            inside.append(
                z3.And(
                    terms.compare(">=", selector, low, kind),
                    terms.compare("<=", selector, high, kind),
                )
            )
        return z3.Or(*inside)

    # --- loops --------------------------------------------------------------------------------

    def _for(self, statement: For) -> None:
        ends = (statement.first, statement.last, statement.step)
        numbers = [int(end.value) for end in ends if isinstance(end, Constant)]
        place = statement.variable
        if len(numbers) < len(ends) or not numbers[2] or not isinstance(place, VariableRef):
            run_loop(self, statement)
            return
        first, last, step = numbers
        passes = range(first, last + (1 if step > 0 else -1), step)
        if len(passes) > _MOST_PASSES or self._writes(statement.body, place):
            run_loop(self, statement)
            return
        memory = self.memory
        kept = memory.left, memory.next, memory.held
        memory.held = z3.Or(memory.held, memory.left, memory.next)
        memory.left = memory.next = z3.BoolVal(False)
        for number in passes:
            self.write(place, terms.constant(number, place.type))
            self.run(statement.body)
            memory.next = z3.BoolVal(False)
        behind = passes[-1] + step if passes else first
        self.write(place, terms.constant(behind, place.type))
        memory.left, memory.next, memory.held = kept

    def _writes(self, body: Sequence[Statement], place: VariableRef) -> bool:
        return any(
            root_of(written) is place.variable
            for node in every_node(body)
            for written in written_places(node)
        )

    # --- instances ----------------------------------------------------------------------------

    def _instance(self, statement: InstanceCall) -> None:
        block, instance = statement.block, statement.instance
        if any(variable.kind is not VariableKind.IN_OUT for variable, _ in statement.in_outs):
            raise UnknownError("an in-out that is copied")
        given = [(variable, self.given(value)) for variable, value in statement.inputs]
        in_outs = [part for _, place in statement.in_outs for part in self.parts(place)]
        for variable, values in given:
            place = FieldRef(statement.span, instance, variable.name, variable.type)
            for (key, indices, _), value in zip(self.parts(place), values, strict=True):
                self.write_at(key, indices, value)
        name = f"FUNCTION_BLOCK {block.name}"
        if isinstance(block, StandardBlock):
            self.happen(name, instance, ())
        else:
            self._user_block(name, block, [*self.parts(instance), *in_outs])
        for variable, target in statement.outputs:
            place = FieldRef(statement.span, instance, variable.name, variable.type)
            key, indices = self.find(place)
            self.write(target, self._value(key, indices))

    def _user_block(self, name: str, block: Block, places: Sequence[Part]) -> None:
        called = self.call(name, block, [value for _, _, value in places])
        for number, (key, indices, value) in enumerate(places):
            self.write_at(key, indices, apply(f"{name}: part {number}", value.sort(), called))


class _Branches:
    """Two branches: one is carried out at once, the other one inside of the context."""

    def __init__(self, execution: Execution, condition: Term, yes: Sequence[Statement]) -> None:
        self._execution = execution
        self._condition = condition
        self._memory = execution.memory
        self._no = execution.memory.copy()
        execution.memory = self._yes = execution.memory.copy()
        execution.run(yes)
        execution.memory = self._no

    def __enter__(self) -> None:
        return None

    def __exit__(self, *_: object) -> None:
        self._execution.memory = self._memory
        self._memory.become(self._condition, self._yes, self._no)
