"""The way from an expression of the checked program to Python: which function writes which node.

The modules for places, operators and calls say it in `EXPRESSIONS`, `blocks` enters them here.
"""

from collections.abc import Callable
from typing import Any

from fbgen.lang.checked import Constant, Expression, FieldRef, IndexRef, SliceRef, VariableRef
from fbgen.lang.types import Elementary
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.data.initials import scalar_text
from harness.engine.compiled.procedure import DEEPEST_EXPRESSION, Procedure
from harness.engine.compiled.shortening.ranges import is_counted, wrapped

Write = Callable[[Procedure, Any], Code]

PLACES = (VariableRef, FieldRef, IndexRef, SliceRef)
"""What is remembered to be shown if the statement stops the program."""

_WRITERS: dict[type, Write] = {}


def enter(writers: dict[type, Write]) -> None:
    """Say which functions write which nodes."""
    _WRITERS.update(writers)


def expression(procedure: Procedure, node: Expression) -> Code:
    """The Python for an expression; a whole number may still have to be wrapped around."""
    writer = _WRITERS[type(node)]
    procedure.enter(node.span)
    code = writer(procedure, node)
    procedure.nesting -= 1
    if code.pure and isinstance(node, PLACES):
        procedure.reads(node, code.text)
    if code.depth > DEEPEST_EXPRESSION:
        return procedure.split_off(code)
    return code


def value(procedure: Procedure, node: Expression) -> Code:
    """The Python for an expression, with its value inside of its type."""
    code = expression(procedure, node)
    kind = node.type
    if isinstance(kind, Elementary) and is_counted(kind):
        return wrapped(code, kind, procedure.temporary)
    return code


def condition(procedure: Procedure, node: Expression) -> str:
    """The text of a condition; Python tests a whole number for zero by itself."""
    code = value(procedure, node)
    return code.text.removesuffix(" != 0") if code.level is Level.COMPARISON else code.text


def stored(code: Code) -> Code:
    """A value that is to be stored: a comparison is faster when it is asked than when kept."""
    if code.level is not Level.COMPARISON or " is " in code.text:
        return code
    text = f"True if {code.text.removesuffix(' != 0')} else False"
    return code._replace(text=text, level=Level.CONDITIONAL)


def named(procedure: Procedure, code: Code) -> tuple[str, str]:
    """A text that has the value and keeps it, and a text for using it again behind that."""
    if code.simple:
        return code.text, code.text
    name = procedure.temporary()
    return f"({name} := {code.text})", name


def constant(node: Constant) -> Code:
    """A constant."""
    kind, content = node.type, node.value
    text = scalar_text(content, kind)
    level = Level.SIGN if text.startswith("-") else Level.ATOM
    if isinstance(content, int) and is_counted(kind):
        return Code(text, level, content, content, simple=True)
    return Code(text, level, simple=True)


enter({Constant: lambda _, node: constant(node)})
