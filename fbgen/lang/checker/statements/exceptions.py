"""__TRY, __CATCH, __FINALLY: what is done where a fault would stop the program.

Source: TwinCAT 3 help and CODESYS online help, "__TRY, __CATCH, __FINALLY, __ENDTRY" and "Data type
__SYSTEM.ExceptionCode".
"""

from collections.abc import Callable, Sequence

from fbgen.lang import ast, checked
from fbgen.lang.checked import Place, Statement
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.types.coercion import spelled
from fbgen.lang.types import Elementary, Enumeration, Type
from fbgen.lang.walk import walk

_CODES = ("UDINT", "ULINT", "DWORD", "LWORD")
"""What holds the number of any exception."""

CheckBody = Callable[[Context, Sequence[ast.Statement]], tuple[Statement, ...]]


def check_try(ctx: Context, node: ast.Try, check_body: CheckBody) -> Sequence[Statement]:
    """The three lists of statements, and the variable for the exception."""
    _refuse_jumps(ctx, node)
    body = check_body(ctx, node.body)
    exception: Place | None = None
    catch: tuple[Statement, ...] = ()
    if node.catch is not None:
        if node.catch.exception is not None:
            exception = _variable(ctx, node.catch.exception)
        catch = check_body(ctx, node.catch.body)
    final = () if node.final is None else check_body(ctx, node.final.body)
    return (checked.Try(node.span, body, node.catch is not None, exception, catch, final),)


def _variable(ctx: Context, node: ast.Expression) -> Place | None:
    place = check_target(ctx, node, "__CATCH")
    if place is None or _holds_codes(place.type):
        return place
    ctx.findings.error(
        "FB4010",
        f"__CATCH gives the code of an exception, and '{node.span.text}' is {spelled(place.type)}",
        node.span,
        "declare it as __SYSTEM.ExceptionCode",
    )
    return None


def _holds_codes(kind: Type) -> bool:
    if isinstance(kind, Enumeration):
        return kind.name.casefold().rpartition(".")[2] == "exceptioncode"
    return isinstance(kind, Elementary) and kind.name in _CODES


def _refuse_jumps(ctx: Context, node: ast.Try) -> None:
    for inner in walk(node.body + (() if node.catch is None else node.catch.body)):
        if isinstance(inner, ast.Goto | ast.Label):
            _refuse(ctx, inner, "JMP and labels inside of __TRY")
    for inner in walk(() if node.final is None else node.final.body):
        if isinstance(inner, ast.Goto | ast.Label | ast.Jump):
            _refuse(ctx, inner, "JMP, EXIT, CONTINUE and RETURN inside of __FINALLY")


def _refuse(ctx: Context, node: ast.Goto | ast.Label | ast.Jump, what: str) -> None:
    help_text = "set a variable and ask it behind __ENDTRY"
    ctx.findings.error("FB4054", f"{what} are not supported", node.span, help_text)
