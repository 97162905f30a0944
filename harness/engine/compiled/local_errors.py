"""Blocks that handle their own errors: Python's `try` around a statement or a place."""

from collections.abc import Callable
from typing import Any, TypeAlias

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Guarded, Statement, Substituted, TakenError
from fbgen.lang.types import Scalar
from harness.engine.compiled.attempts import attempts, nothing_text
from harness.engine.compiled.cells import Cell
from harness.engine.compiled.code import Code
from harness.engine.compiled.evaluation import Write, value
from harness.engine.compiled.places import cell
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.ranges import limits
from harness.engine.local_errors import local_error

WriteStatement: TypeAlias = Callable[[Procedure, Statement], None]


def going_on(
    cpu: Any, stopped_by: Callable[[Exception], Exception]
) -> dict[str, Callable[..., Any]]:
    """What generated code calls to go on behind a fault; `cpu` counts how deep blocks are nested.

    Those of `attempts` are among them.
    """

    def note(fault: Exception, node: Substituted | Guarded, memory: Cell, depth: int) -> None:
        stop = stopped_by(fault)
        number = local_error(stop, node) if isinstance(stop, DiagnosticError) else None
        if number is None:
            raise fault
        cpu.depth = depth
        if not memory.value:
            memory.value = number

    def substituted(
        memory: Cell, read: Callable[[], Scalar], nothing: Scalar, node: Substituted
    ) -> Scalar:
        depth = cpu.depth
        try:
            return read()
        except Exception as fault:
            note(fault, node, memory, depth)
        return nothing

    def taken(memory: Cell) -> int:
        noted = memory.value
        memory.value = 0
        assert isinstance(noted, int)
        return noted & 0xFFFF

    return {
        **attempts(cpu, stopped_by),
        "_note": note,
        "_substituted": substituted,
        "_taken": taken,
    }


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
