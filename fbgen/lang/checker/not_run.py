"""What is right in the text and cannot run here: the statement around it stops the run instead.

Pointers count in bytes of a real memory and objects come and go in CODESYS and TwinCAT; here a
reference refers to a variable, and all variables are there from the start.
"""

from fbgen.diagnostics import Diagnostic, Severity
from fbgen.lang.checked import Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.types.literals import erroneous
from fbgen.source import Span

_HELP = "a run stops at this statement; without it the block runs"


def cannot_run(ctx: Context, span: Span, what: str) -> Expression:
    """Take note that the statement around cannot run; what stands for the expression.

    Where there is no statement, as in a declaration, it is an error.
    """
    if ctx.not_run is None:
        ctx.findings.error(
            "FB4054", f"{what} cannot be worked out here", span, "do it in a statement of the block"
        )
        return erroneous(span)
    ctx.not_run.append(what)
    ctx.findings.unclear.append(span)
    ctx.findings.add(
        Diagnostic("FB4142", f"{what} cannot run", span, _HELP, severity=Severity.INFO)
    )
    return erroneous(span)
