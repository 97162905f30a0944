"""What statements do, and the watchdog over their loops."""

from collections.abc import Callable, Iterator, Sequence
from enum import Enum, auto
from functools import partial

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import (
    Assignment,
    Case,
    Continue,
    Evaluate,
    Exit,
    For,
    FunctionCall,
    Goto,
    Guarded,
    If,
    InstanceCall,
    Label,
    Place,
    Repeat,
    Return,
    RoutineCall,
    Statement,
    Stop,
    Try,
    While,
)
from fbgen.lang.types import Elementary
from fbgen.source import Span
from harness.engine.exception_codes import exception_code
from harness.engine.fault_values import places_of, with_values
from harness.engine.faults import cannot_run, endless_loop, step_is_zero
from harness.engine.interface import Value
from harness.engine.reference.arithmetic import wrap
from harness.engine.reference.expressions import Expressions
from harness.engine.reference.frames import Frame
from harness.engine.reference.places import Places


class Flow(Enum):
    """How a statement ended."""

    NEXT = auto()
    CONTINUE = auto()
    EXIT = auto()
    RETURN = auto()
    GOTO = auto()


_LEAVING = (Flow.EXIT, Flow.RETURN, Flow.GOTO)
"""What ends a loop."""


def _branches(statement: Statement) -> list[Sequence[Statement]]:
    """The lists inside a statement that a jump can lead into."""
    if isinstance(statement, If):
        return [*(branch.body for branch in statement.branches), statement.otherwise]
    if isinstance(statement, Case):
        return [*(arm.body for arm in statement.arms), statement.otherwise]
    return []


class Watchdog:
    """Counts the loop passes of one call from outside."""

    __slots__ = ("_limit", "passes")

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self.passes = 0

    def restart(self) -> None:
        """A new call from outside begins."""
        self.passes = 0

    def begin_pass(self, loop: Span) -> None:
        """A loop begins a pass. Raises FB6004."""
        self.passes += 1
        if self.passes > self._limit:
            raise endless_loop(loop, self._limit)


class Statements:
    """Carries out the statements of one program."""

    __slots__ = (
        *("_call_function", "_call_instance", "_call_routine", "_expressions", "_goal"),
        *("_places", "_watchdog"),
    )

    def __init__(
        self,
        expressions: Expressions,
        places: Places,
        watchdog: Watchdog,
        *,
        call_function: Callable[[FunctionCall, Frame], Value | None],
        call_instance: Callable[[InstanceCall, Frame], None],
        call_routine: Callable[[RoutineCall, Frame], Value | None],
    ) -> None:
        self._expressions = expressions
        self._places = places
        self._watchdog = watchdog
        self._call_function = call_function
        self._call_instance = call_instance
        self._call_routine = call_routine
        self._goal = ""

    def run(self, statements: Sequence[Statement], frame: Frame) -> Flow:
        """One statement after the other, until one leaves the list."""
        return self._follow(statements, frame, self._from(statements, 0, frame))

    def _from(self, statements: Sequence[Statement], start: int, frame: Frame) -> Flow:
        for statement in statements[start:]:
            try:
                flow = self._one(statement, frame)
            except DiagnosticError as failure:
                if failure.diagnostics[0].notes:
                    raise
                raise with_values(failure, self._values(statement, failure, frame)) from None
            if flow is not Flow.NEXT:
                return flow
        return Flow.NEXT

    def _values(
        self, statement: Statement, failure: DiagnosticError, frame: Frame
    ) -> Iterator[tuple[Place, Callable[[], Value]]]:
        """How to read the places that stand in what failed."""
        failed = failure.diagnostics[0].span
        if failed is not None:
            for place in places_of(statement, failed):
                yield place, partial(self._read, place, frame)

    def _read(self, place: Place, frame: Frame) -> Value:
        return self._places.find(place, frame).read()

    def _follow(self, statements: Sequence[Statement], frame: Frame, flow: Flow) -> Flow:
        """Go on in this list while jumps lead into it."""
        while flow is Flow.GOTO:
            landing = next((i for i, one in enumerate(statements) if self._leads_to(one)), None)
            if landing is None:
                return flow
            flow = self._enter(statements[landing], frame)
            if flow is Flow.NEXT:
                flow = self._from(statements, landing + 1, frame)
        return flow

    def _leads_to(self, statement: Statement) -> bool:
        """True for the label of the present jump, and for the IF or CASE around it."""
        if isinstance(statement, Label):
            return statement.name == self._goal
        return any(self._leads_to(one) for body in _branches(statement) for one in body)

    def _enter(self, statement: Statement, frame: Frame) -> Flow:
        """Land on a label, or in the branch that has it; its condition is not asked."""
        for body in _branches(statement):
            if any(self._leads_to(one) for one in body):
                return self._follow(body, frame, Flow.GOTO)
        return Flow.NEXT

    def _one(self, statement: Statement, frame: Frame) -> Flow:
        match statement:
            case Assignment():
                value = self._expressions.value(statement.value, frame)
                self._places.find(statement.target, frame).write(value)
            case Evaluate():
                if isinstance(statement.call, FunctionCall):
                    self._call_function(statement.call, frame)
                elif isinstance(statement.call, RoutineCall):
                    self._call_routine(statement.call, frame)
                else:
                    self._expressions.system_call(statement.call, frame)
            case InstanceCall():
                self._call_instance(statement, frame)
            case If():
                return self._if(statement, frame)
            case Case():
                return self._case(statement, frame)
            case For():
                return self._for(statement, frame)
            case While():
                return self._while(statement, frame)
            case Repeat():
                return self._repeat(statement, frame)
            case Try():
                return self._try(statement, frame)
            case Guarded():
                return self._guarded(statement, frame)
            case Exit():
                return Flow.EXIT
            case Continue():
                return Flow.CONTINUE
            case Return():
                return Flow.RETURN
            case Stop():
                raise cannot_run(statement.span, statement.what)
            case Label():
                pass
            case Goto():
                if statement.backward:
                    self._watchdog.begin_pass(statement.span)
                self._goal = statement.label
                return Flow.GOTO
        return Flow.NEXT

    def _guarded(self, statement: Guarded, frame: Frame) -> Flow:
        try:
            return self._one(statement.statement, frame)
        except DiagnosticError as stop:
            self._expressions.note(stop, statement, frame)
        return Flow.NEXT

    def _try(self, statement: Try, frame: Frame) -> Flow:
        try:
            return self._caught(statement, frame)
        finally:
            self.run(statement.final, frame)

    def _caught(self, statement: Try, frame: Frame) -> Flow:
        try:
            return self.run(statement.body, frame)
        except DiagnosticError as stop:
            code = exception_code(stop) if statement.catches else None
            if code is None:
                raise
        if statement.exception is not None:
            self._places.find(statement.exception, frame).write(code)
        return self.run(statement.catch, frame)

    def _if(self, statement: If, frame: Frame) -> Flow:
        for branch in statement.branches:
            if self._expressions.scalar(branch.condition, frame):
                return self.run(branch.body, frame)
        return self.run(statement.otherwise, frame)

    def _case(self, statement: Case, frame: Frame) -> Flow:
        selector = self._expressions.integer(statement.selector, frame)
        for arm in statement.arms:
            if any(first <= selector <= last for first, last in arm.ranges):
                return self.run(arm.body, frame)
        return self.run(statement.otherwise, frame)

    def _for(self, statement: For, frame: Frame) -> Flow:
        """The variable is set before `last` and `step` are worked out."""
        variable = self._places.find(statement.variable, frame)
        kind = variable.kind
        assert isinstance(kind, Elementary)
        variable.write(self._expressions.integer(statement.first, frame))
        last = self._expressions.integer(statement.last, frame)
        step = self._expressions.integer(statement.step, frame)
        if step == 0:
            raise step_is_zero(statement.span)
        while True:
            counter = variable.read()
            assert isinstance(counter, int)
            if counter > last if step > 0 else counter < last:
                return Flow.NEXT
            self._watchdog.begin_pass(statement.span)
            flow = self.run(statement.body, frame)
            if flow in _LEAVING:
                return Flow.NEXT if flow is Flow.EXIT else flow
            counter = variable.read()
            assert isinstance(counter, int)
            variable.write(wrap(kind, counter + step))
            if not kind.minimum <= counter + step <= kind.maximum:
                return Flow.NEXT

    def _while(self, statement: While, frame: Frame) -> Flow:
        while self._expressions.scalar(statement.condition, frame):
            self._watchdog.begin_pass(statement.span)
            flow = self.run(statement.body, frame)
            if flow in _LEAVING:
                return Flow.NEXT if flow is Flow.EXIT else flow
        return Flow.NEXT

    def _repeat(self, statement: Repeat, frame: Frame) -> Flow:
        while True:
            self._watchdog.begin_pass(statement.span)
            flow = self.run(statement.body, frame)
            if flow in _LEAVING:
                return Flow.NEXT if flow is Flow.EXIT else flow
            if self._expressions.scalar(statement.condition, frame):
                return Flow.NEXT
