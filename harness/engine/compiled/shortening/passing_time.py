"""A timer that was called a moment ago shows what it shows now: it need not be asked once more.

On S7-1200 and S7-1500 a timer brings Q and ET up to date when they are read. Time passes in a scan
only while hardware is accessed or another block runs, which may do so. Nearly all timers are read
in the statements right behind their call.
"""

from fbgen.lang.checked import (
    Assignment,
    Binary,
    Constant,
    Convert,
    Expression,
    FieldRef,
    If,
    IndexRef,
    InstanceCall,
    Statement,
    Unary,
    Variable,
    VariableRef,
)
from harness.engine.compiled.library.timers import METHODS
from harness.engine.compiled.walk import every_node, root_of

_TIMELESS = (Assignment, Binary, Constant, Convert, FieldRef, IndexRef, Unary)
"""What can be worked out without anything else happening meanwhile."""


def timer_behind(timer: Variable | None, statement: Statement) -> Variable | None:
    """The timer that is up to date behind a statement: the one that it calls, or the one that was
    so before if no time can pass in it."""
    if isinstance(statement, InstanceCall):
        instance = statement.instance
        is_timer = statement.block.name.removesuffix("_LTIME") in METHODS
        return instance.variable if is_timer and isinstance(instance, VariableRef) else None
    return timer_inside(timer, statement) if isinstance(statement, Assignment) else None


def timer_inside(timer: Variable | None, statement: Statement) -> Variable | None:
    """The timer that was up to date before, where it is when a statement reads it: in an assignment
    and in the condition of an IF, if no time can pass in them."""
    match statement:
        case Assignment() if root_of(statement.target) is not timer:
            read: Assignment | Expression = statement
        case If():
            read = statement.branches[0].condition
        case _:
            return None
    return timer if timer is not None and all(map(_is_timeless, every_node([read]))) else None


def _is_timeless(node: object) -> bool:
    if isinstance(node, VariableRef):
        return node.variable.address is None
    return isinstance(node, _TIMELESS)
