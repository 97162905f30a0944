"""Calls of instructions with several outputs, and of what a stub of the user stands for.

In Python each is a call of `_routine`, which gives the result and the outputs in their order; None
for an output that is not written. `routines` carries the call out.
"""

from fbgen.lang.checked import RoutineCall
from harness.engine.compiled.code import Code
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.evaluation import Write, value
from harness.engine.compiled.expressions.places import assign, place
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits
from harness.engine.compiled.watching.write_notes import note_write


def routine_statement(procedure: Procedure, node: RoutineCall) -> Code:
    """Write a call with everything that it writes; gives its result."""
    texts = [procedure.context.table("routine", node)]
    texts.append("None" if node.instance is None else place(procedure, node.instance).text)
    texts += [value(procedure, argument).text for _, argument in node.inputs]
    results = procedure.temporary()
    call = f"_routine({', '.join(texts)})"
    procedure.site(call, node)
    procedure.line(f"{results} = {call}")
    for number, (_, target) in enumerate(node.outputs, 1):
        given = f"{results}[{number}]"
        procedure.line(f"if {given} is not None:")
        procedure.listing.indent += 4
        if is_scalar(target.type):
            low, high = limits(target.type)
            assign(procedure, target, Code(given, low=low, high=high), target.type)
        else:
            table = procedure.context.table("place", target)
            text = place(procedure, target).text
            procedure.line(f"_fill({table}, {text}, {given})")
            note_write(procedure, text, target.type)
        procedure.listing.indent -= 4
    low, high = limits(node.type)
    return Code(f"{results}[0]", low=low, high=high)


def _expression(procedure: Procedure, node: RoutineCall) -> Code:
    """A call inside of an expression: in a function of its own, because it may write."""
    part = procedure.start_part("call")
    code = routine_statement(part, node)
    part.line(f"return {code.text}")
    return code._replace(text=procedure.finish_part(part), safe=False, pure=False)


EXPRESSIONS: dict[type, Write] = {RoutineCall: _expression}
"""Which function of this module writes which node."""
