"""Statements."""

from typing import TypeAlias

from fbgen.lang.ast import node
from fbgen.lang.checked.expressions import (
    Expression,
    FunctionCall,
    Place,
    RoutineCall,
    SystemCall,
    VariableRef,
)
from fbgen.lang.checked.variables import AnyBlock, Variable
from fbgen.source import Span


@node
class Assignment:
    """`target := value`. Structures and arrays are copied. Types are equal.

    An assignment whose target is an output of a call has been moved into the call.
    """

    span: Span
    target: Place
    value: Expression


@node
class Evaluate:
    """A function called for its side effects; the result is dropped."""

    span: Span
    call: FunctionCall | SystemCall | RoutineCall


@node
class InstanceCall:
    """A call of a function block instance. Inputs that are not given keep their value.

    `block` is mostly the block of the instance; it may also be one that this extends, or an action,
    which have the same variables, or the first of them.
    """

    span: Span
    instance: Place
    block: AnyBlock
    inputs: tuple[tuple[Variable, Expression], ...]
    in_outs: tuple[tuple[Variable, Place], ...]
    outputs: tuple[tuple[Variable, Place], ...]


@node
class Branch:
    """A condition and what is done when it holds."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]


@node
class If:
    """The first branch whose condition holds, else `otherwise`."""

    span: Span
    branches: tuple[Branch, ...]
    otherwise: tuple["Statement", ...]


@node
class CaseArm:
    """Statements for the values in any of the inclusive ranges."""

    span: Span
    ranges: tuple[tuple[int, int], ...]
    body: tuple["Statement", ...]


@node
class Case:
    """The first arm that has the selector's value, else `otherwise`."""

    span: Span
    selector: Expression
    arms: tuple[CaseArm, ...]
    otherwise: tuple["Statement", ...]


@node
class For:
    """Counts `variable` from `first` to `last`, both converted to its type, inclusive.

    `last` and `step` are evaluated once. After the last pass the variable is one step further
    (FOR i := 0 TO 7 leaves 8) unless EXIT ended it; if that step leaves the range of the type the
    loop ends and the variable wraps around.
    """

    span: Span
    variable: Place
    first: Expression
    last: Expression
    step: Expression
    body: tuple["Statement", ...]


@node
class While:
    """As long as the condition holds."""

    span: Span
    condition: Expression
    body: tuple["Statement", ...]


@node
class Repeat:
    """At least once, until the condition holds."""

    span: Span
    body: tuple["Statement", ...]
    condition: Expression


@node
class Try:
    """`body` up to a fault that can be caught; then the number of the fault goes to `exception`, if
    there is one, and `catch` is done. `final` is done in any case, on the way of a jump too; no
    jump leads out of it. No label is inside.

    `catches` is False without __CATCH: then a fault stops the program, behind `final`.
    """

    span: Span
    body: tuple["Statement", ...]
    catches: bool
    exception: Place | None
    catch: tuple["Statement", ...]
    final: tuple["Statement", ...]


@node
class Guarded:
    """A statement that is left where a place in it cannot be reached; as far as it came is done.

    That is noted in `memory`, a DWORD, unless that has noted something already. What goes wrong in
    a block that is called stops the program as ever.
    """

    span: Span
    statement: Assignment | Evaluate | InstanceCall
    memory: VariableRef


@node
class Exit:
    """Leave the innermost loop."""

    span: Span


@node
class Continue:
    """Go on with the next pass of the innermost loop."""

    span: Span


@node
class Return:
    """Leave the block."""

    span: Span


@node
class Stop:
    """A statement that is right and cannot run: a run that comes here ends; `what` says why."""

    span: Span
    what: str


@node
class Label:
    """A place in a list of statements that `Goto` can go on at; `name` is casefolded."""

    span: Span
    name: str


@node
class Goto:
    """Go on behind the `Label` with that name.

    The label stands in the same block, in the lists around the jump or inside of an IF or CASE in
    one of them, but never inside of a loop that the jump is not in. `backward`: the label stands
    before the jump in the text; such a jump counts as a pass of a loop.
    """

    span: Span
    label: str
    backward: bool


Statement: TypeAlias = (
    Assignment
    | Evaluate
    | InstanceCall
    | If
    | Case
    | For
    | While
    | Repeat
    | Try
    | Guarded
    | Exit
    | Continue
    | Return
    | Stop
    | Label
    | Goto
)
