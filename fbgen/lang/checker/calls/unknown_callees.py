"""What to say about calls of what does not exist, or cannot be called like that."""

from fbgen.lang import ast
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.namespaces import namespace_help
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.checker.operands.elsewhere import block_help
from fbgen.lang.checker.operands.foreign_names import library_help
from fbgen.lang.checker.operands.name_lookup import may_be_inherited
from fbgen.lang.checker.operands.pointers import RAW_MEMORY, check_raw_memory, has_addresses
from fbgen.lang.checker.supplied.refused_instructions import NOT_SUPPORTED, WRITTEN_OTHERWISE
from fbgen.lang.checker.supplied.routines import MODELLED
from fbgen.lang.checker.supplied.standard_blocks import standard_block
from fbgen.lang.checker.supplied.standard_functions import OPERATORS_BY_NAME, STANDARD_FUNCTIONS
from fbgen.lang.checker.supplied.system_instructions import INSTRUCTIONS
from fbgen.lang.other_languages import language_of

_NOT_RUN = ("__NEW", "__DELETE", "__QUERYINTERFACE", "__QUERYPOINTER")
"""Operators of CODESYS and TwinCAT for memory and interfaces that are made while running."""


def unknown_callee(ctx: Context, node: ast.Call, name: str) -> None:
    """Report the call of something that does not exist."""
    if standard_block(name) is not None:
        without_instance(ctx, node, name)
        return
    if language := language_of(name):
        cannot_run(ctx, node.callee.span, f"a body in {language}")
        return
    if has_addresses(ctx) and _cannot_run(ctx, node, name):
        return
    refused = NOT_SUPPORTED.get(name.upper()) if ctx.rules.dialect == "tia" else None
    if refused is not None:
        message = f"{name} has no model, so this program cannot run"
        ctx.findings.gap(message, node.callee.span, f"to run it, {refused}")
        check_arguments_alone(ctx, node)
        return
    advise = library_help if has_addresses(ctx) else block_help
    if not may_be_inherited(ctx):
        ctx.findings.unknown(
            "FB4004",
            f"there is no function or block '{name}'",
            node.callee.span,
            lambda: (
                namespace_help(ctx.library.namespaces, name)
                or WRITTEN_OTHERWISE.get(name.upper())
                or advise(name, _callable_names(ctx))
            ),
            name if isinstance(node.callee, ast.Name) and node.callee.quoted else "",
        )
    check_arguments_alone(ctx, node)


def _cannot_run(ctx: Context, node: ast.Call, name: str) -> bool:
    """Take note of what CODESYS and TwinCAT can do and a run here cannot."""
    if name.upper() in _NOT_RUN:
        cannot_run(ctx, node.callee.span, name.upper())
    elif name.upper() in RAW_MEMORY:
        check_raw_memory(ctx, node, name)
    else:
        return False
    return True


def _callable_names(ctx: Context) -> list[str]:
    return [
        *ctx.library.block_names(),
        *STANDARD_FUNCTIONS,
        *OPERATORS_BY_NAME,
        *(instruction.name for instruction in INSTRUCTIONS.values()),
        *MODELLED,
    ]


def check_arguments_alone(ctx: Context, node: ast.Call) -> None:
    """The arguments of a call of something unknown: their own mistakes are reported."""
    for argument in node.arguments:
        if argument.value is not None:
            check_expression(ctx, argument.value)


def without_instance(ctx: Context, node: ast.Call, name: str) -> None:
    """Report a function block that is called by its own name."""
    ctx.findings.error(
        "FB4045",
        f"{name} is a function block and is called through an instance",
        node.span,
        f"declare one: inst{name} : {name}; and call inst{name}(...)",
    )
