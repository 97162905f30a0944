"""FOR, WHILE and REPEAT, and the watchdog that counts their passes.

All passes of one call from outside are counted in `_cpu.passes`, downwards; not at all if no call
can come near the limit, and all at once for a FOR in which nothing can happen but calculating.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from fbgen.lang.checked import (
    Constant,
    Exit,
    Expression,
    For,
    Repeat,
    Statement,
    VariableRef,
    While,
)
from fbgen.lang.types import Elementary
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.evaluation import condition, value
from harness.engine.compiled.expressions.places import assign, pinned, place
from harness.engine.compiled.procedure import Loop, Procedure
from harness.engine.compiled.shortening.caching import is_quiet
from harness.engine.compiled.shortening.ranges import wrapped
from harness.engine.compiled.walk import every_node
from harness.engine.compiled.watching.probes import Moment, Probed
from harness.engine.compiled.watching.write_notes import note_write

MOST_WRITTEN_OUT = 16
"""Passes up to which the numbers are a constant: cheaper than making a range at each start."""

WriteBody = Callable[[Procedure, Sequence[Statement], Probed | None], None]


def count_passes(procedure: Procedure, passes: str) -> None:
    """Write the counting of passes that begin now, if the watchdog could ever bark."""
    if not procedure.context.facts.counts_loops:
        return
    procedure.line(f"_cpu.passes -= {passes}")
    procedure.line("if _cpu.passes < 0: _runaway()")


def _body(
    procedure: Procedure,
    node: For | While | Repeat,
    before_continue: Callable[[Procedure], None] | None,
    write_body: WriteBody,
    counted: bool,
) -> None:
    """The inside of a loop, whose head has been written."""
    if counted:
        procedure.listing.indent += 4
        count_passes(procedure, "1")
        procedure.listing.indent -= 4
    procedure.loops.append(Loop(before_continue))
    write_body(procedure, node.body, node)
    procedure.loops.pop()


def write_while(procedure: Procedure, node: While, write_body: WriteBody) -> None:
    """WHILE."""
    procedure.listing.span = node.condition.span
    procedure.line(f"while {condition(procedure, node.condition)}:")
    procedure.listing.span = node.span
    _body(procedure, node, None, write_body, counted=True)


def write_repeat(procedure: Procedure, node: Repeat, write_body: WriteBody) -> None:
    """REPEAT; CONTINUE goes to the condition."""

    def until(procedure: Procedure) -> None:
        span, procedure.listing.span = procedure.listing.span, node.condition.span
        text = condition(procedure, node.condition)
        if procedure.probed(node, Moment.ENDED):
            procedure.line(f"if {text}:")
            procedure.listing.indent += 4
            procedure.probe(node, Moment.ENDED)
            procedure.line("break")
            procedure.listing.indent -= 4
        else:
            procedure.line(f"if {text}: break")
        procedure.listing.span = span

    procedure.line("while True:")
    _body(procedure, node, until, write_body, counted=True)
    procedure.listing.indent += 4
    until(procedure)
    procedure.listing.indent -= 4


def write_for(procedure: Procedure, node: For, write_body: WriteBody) -> None:
    """FOR: with Python's own counting where nothing else changes the variable."""
    variable = node.variable
    if (
        isinstance(variable, VariableRef)
        and isinstance(node.step, Constant)
        and node.step.value != 0
        and not procedure.has_cell(variable.variable)
        and procedure.context.facts.keeps(variable.variable, node.body)
    ):
        _write_range(procedure, node, variable, int(node.step.value), write_body)
    else:
        _write_counting(procedure, node, write_body)


class _Range(NamedTuple):
    """The passes of a FOR as Python iterates them, how many they are, and between what."""

    passes: str
    number: str
    interval: tuple[int, int]


def _write_range(
    procedure: Procedure, node: For, variable: VariableRef, step: int, write_body: WriteBody
) -> None:
    kind = variable.type
    assert isinstance(kind, Elementary)
    text = procedure.text_of(variable.variable)
    first, last = node.first, node.last
    if isinstance(first, Constant) and isinstance(last, Constant):
        start, end = int(first.value), int(last.value)
        passes = range(start, end + (1 if step > 0 else -1), step)
        if not passes:
            procedure.line(f"{text} = {start}")
            note_write(procedure, text, kind)
            return
        interval = (min(passes[0], passes[-1]), max(passes[0], passes[-1]))
        behind = passes[-1] + step
        after = Code(str((behind - kind.minimum) % (1 << kind.bits) + kind.minimum))
        loop = _Range(_range(passes), str(len(passes)), interval)
    else:
        first_code = value(procedure, first)
        procedure.line(f"{text} = {first_code.text}")
        last_code = value(procedure, last)
        name = procedure.temporary()
        # `last` may name the variable: it has its first value by now.
        beyond = f"{last_code.at(Level.SUM)} {'+ 1' if step > 0 else '- 1'}"
        tail = "" if step == 1 else f", {step}"
        procedure.line(f"{name} = range({text}, {beyond}{tail})")
        if step > 0:
            interval = (first_code.low, max(first_code.low, last_code.high))
        else:
            interval = (min(first_code.high, last_code.low), first_code.high)
        low, high = min(interval[0], interval[0] + step), max(interval[1], interval[1] + step)
        factor = "" if step == 1 else f" * {step}"
        behind_code = Code(f"{name}.start + len({name}){factor}", Level.SUM, low, high, depth=3)
        after = wrapped(behind_code, kind, procedure.temporary)
        loop = _Range(name, f"len({name})", interval)
    _write_range_loop(procedure, node, loop, write_body)
    if any(isinstance(one, Exit) for one in every_node(node.body)):
        procedure.line("else:")
        procedure.listing.indent += 4
        procedure.line(f"{text} = {after.text}")
        note_write(procedure, text, kind)
        procedure.listing.indent -= 4
    else:
        procedure.line(f"{text} = {after.text}")
        note_write(procedure, text, kind)


def _range(passes: range) -> str:
    if 1 < len(passes) <= MOST_WRITTEN_OUT:
        return str(tuple(passes))
    tail = "" if passes.step == 1 else f", {passes.step}"
    return f"range({passes.start}, {passes.stop}{tail})"


def _write_range_loop(
    procedure: Procedure,
    node: For,
    loop: _Range,
    write_body: WriteBody,
) -> None:
    variable = node.variable
    assert isinstance(variable, VariableRef)
    text = procedure.text_of(variable.variable)
    is_local = "." not in text
    local = text if is_local else procedure.temporary()
    quiet = is_quiet(node.body, loop.interval, variable.variable)
    if quiet:
        # Nobody can tell whether the watchdog barks before the loop or in the middle of it.
        count_passes(procedure, loop.number)
    procedure.line(f"for {local} in {loop.passes}:")
    if quiet and not procedure.context.framed:
        procedure.unwritten = {}
    if not is_local and procedure.unwritten is None:
        procedure.listing.indent += 4
        procedure.line(f"{text} = {local}")
        note_write(procedure, text, variable.type)
        procedure.listing.indent -= 4
    known, aliases = procedure.known, procedure.aliases
    procedure.known = {**known, variable.variable: loop.interval}
    if not is_local:
        procedure.aliases = {**aliases, variable.variable: local}
    _body(procedure, node, None, write_body, counted=not quiet)
    procedure.known, procedure.aliases = known, aliases
    procedure.listing.span = node.span
    if procedure.unwritten is not None:
        for attribute, name in procedure.unwritten.items():
            procedure.line(f"{attribute} = {name}")
        procedure.unwritten = None


class Counting:
    """FOR as the standard describes it, for variables that the body may change.

    Making one writes the start of the loop.
    """

    __slots__ = ("_current", "_kind", "_last", "_node", "_procedure", "_step", "_target")

    def __init__(self, procedure: Procedure, node: For) -> None:
        self._procedure = procedure
        self._node = node
        self._target = pinned(procedure, node.variable)
        kind = self._target.type
        assert isinstance(kind, Elementary)
        self._kind = kind
        assign(procedure, self._target, value(procedure, node.first), kind)
        self._last = _kept(procedure, node.last)
        self._step = _kept(procedure, node.step)
        if not isinstance(node.step, Constant):
            procedure.line(f"if {self._step.text} == 0: _no_step()")
        self._current = place(procedure, self._target)

    @property
    def goes_on(self) -> str:
        """The condition under which there is another pass."""
        current, last, step = self._current, self._last, self._step
        if isinstance(self._node.step, Constant):
            sign = "<=" if step.low > 0 else ">="
            return f"{current.at(Level.BIT_OR)} {sign} {last.text}"
        up = f"{current.at(Level.BIT_OR)} <= {last.text}"
        down = f"{current.at(Level.BIT_OR)} >= {last.text}"
        return f"{up} if {step.text} > 0 else {down}"

    def advance(self, leave: Callable[[], None]) -> None:
        """Write the step to the next pass; `leave` writes how the loop ends if there is none."""
        procedure, kind, step = self._procedure, self._kind, self._step
        span, procedure.listing.span = procedure.listing.span, self._node.span
        name = procedure.temporary()
        current = place(procedure, self._target)
        procedure.line(f"{name} = {current.at(Level.SUM)} + {step.at(Level.SIGN)}")
        low, high = kind.minimum + min(step.low, 0), kind.maximum + max(step.high, 0)
        code = Code(name, low=low, high=high, simple=True)
        inside = f"{kind.minimum} <= {name} <= {kind.maximum}"
        procedure.line(f"if not {inside}:")
        procedure.listing.indent += 4
        assign(procedure, self._target, wrapped(code, kind, procedure.temporary), kind)
        leave()
        procedure.listing.indent -= 4
        assign(procedure, self._target, code.within(kind.minimum, kind.maximum), kind)
        procedure.listing.span = span


def _write_counting(procedure: Procedure, node: For, write_body: WriteBody) -> None:
    counting = Counting(procedure, node)
    procedure.line(f"while {counting.goes_on}:")

    def advance(procedure: Procedure) -> None:
        counting.advance(lambda: procedure.line("break"))

    _body(procedure, node, advance, write_body, counted=True)
    procedure.listing.indent += 4
    advance(procedure)
    procedure.listing.indent -= 4


def _kept(procedure: Procedure, node: Expression) -> Code:
    """A value that is calculated once and kept."""
    code = value(procedure, node)
    if isinstance(node, Constant):
        return code
    name = procedure.temporary()
    procedure.line(f"{name} = {code.text}")
    return code._replace(text=name, level=Level.ATOM, depth=1, simple=True, safe=True, pure=True)
