"""__TRY: a fault inside goes on behind __CATCH. Python's own `try` does it."""

from collections.abc import Callable, Sequence
from typing import TypeAlias

from fbgen.lang.checked import Statement, Try
from harness.engine.compiled.code import Code
from harness.engine.compiled.expressions.places import assign
from harness.engine.compiled.procedure import Procedure

WriteBody: TypeAlias = Callable[[Procedure, Sequence[Statement]], None]


def write_try(procedure: Procedure, node: Try, write_body: WriteBody) -> None:
    """Write a statement with __TRY. What is known of values does not outlive a part of it."""
    listing = procedure.listing
    if node.final:
        procedure.line("try:")
        listing.indent += 4
    if node.catches:
        depth, fault = procedure.temporary(), procedure.temporary()
        procedure.line(f"{depth} = _cpu.depth")
        procedure.line("try:")
        write_body(procedure, node.body)
        procedure.line(f"except Exception as {fault}:")
        listing.indent += 4
        code = f"_caught({fault}, {depth})"
        if node.exception is None:
            procedure.line(code)
        else:
            number = Code(code, low=0, high=0xFFFF_FFFF, safe=False, pure=False)
            assign(procedure, node.exception, number, node.exception.type)
        listing.indent -= 4
        write_body(procedure, node.catch)
    else:
        write_body(procedure, node.body)
    if node.final:
        listing.indent -= 4
        procedure.line("finally:")
        write_body(procedure, node.final)
