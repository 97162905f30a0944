"""Blocks that handle their own errors: Python's `try` around a statement or a place."""

from collections.abc import Callable
from typing import TypeAlias

from fbgen.lang.checked import Guarded, Statement, Substituted, TakenError
from harness.engine.compiled.code import Code
from harness.engine.compiled.evaluation import Write, value
from harness.engine.compiled.expressions.attempts import nothing_text
from harness.engine.compiled.expressions.places import cell
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits

WriteStatement: TypeAlias = Callable[[Procedure, Statement], None]


def write_guarded(procedure: Procedure, node: Guarded, write: WriteStatement) -> None:
    """Write a statement that is left where a place in it is not there."""
    listing = procedure.listing
    depth, fault = procedure.temporary(), procedure.temporary()
    name = procedure.context.table("guarded", node)
    memory = cell(procedure, node.memory)
    procedure.line(f"{depth} = _cpu.depth")
    procedure.line("try:")
    listing.indent += 4
    write(procedure, node.statement)
    listing.indent -= 4
    procedure.forget_sites()
    procedure.line(f"except Exception as {fault}:")
    procedure.line(f"    _note({fault}, {name}, {memory.text}, {depth})")


def _substituted(procedure: Procedure, node: Substituted) -> Code:
    memory, code = cell(procedure, node.memory), value(procedure, node.place)
    name = procedure.context.table("substituted", node)
    low, high = limits(node.type)
    text = f"_substituted({memory.text}, lambda: {code.text}, {nothing_text(node.type)}, {name})"
    return Code(text, low=low, high=high, depth=code.depth + 2, safe=False, pure=False)


def _taken(procedure: Procedure, node: TakenError) -> Code:
    text = f"_taken({cell(procedure, node.memory).text})"
    return Code(text, low=0, high=0xFFFF, depth=3, safe=False, pure=False)


EXPRESSIONS: dict[type, Write] = {Substituted: _substituted, TakenError: _taken}
"""Which function of this module writes which node."""
