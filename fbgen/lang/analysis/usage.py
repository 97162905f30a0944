"""Declarations that nobody uses, variables that only get or only give values, unset results."""

from collections.abc import Iterable, Set
from typing import TYPE_CHECKING

from fbgen.lang.analysis.flow import Flow
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import IN_OUTS, Block, Variable, VariableKind
from fbgen.lang.life_cycle import is_life_cycle, is_method
from fbgen.lang.start_information import start_places
from fbgen.lang.types import BOOL, Elementary, StringType

if TYPE_CHECKING:
    from fbgen.lang.checker.context import Context
    from fbgen.lang.checker.symbols import Entry

_INNER = (VariableKind.STATIC, VariableKind.TEMP)
_RESULTS = (VariableKind.RESULT, VariableKind.OUTPUT)
_PARAMETERS = (VariableKind.INPUT, *IN_OUTS)


def check_usage(
    flow: Flow, ctx: "Context", members_written: Set[tuple[str, str]], silent: Set[Block]
) -> None:
    """FB4101, FB4201, FB4202, FB4203, FB4205 for one block.

    The temporaries and inputs of an organization block are what the controller hands to it.

    `members_written` are (block, variable) that somebody writes from outside, casefolded; `silent`
    are functions whose result says nothing.
    """
    if is_action(flow, ctx):
        return  # it has the names of its block
    inherited = inherited_names(ctx)
    is_open = ctx.library.objects.is_open(ctx.owner or flow.block)
    for entry in ctx.scope.entries.values():
        if entry in inherited or entry in ctx.library.linked or entry in ctx.library.receivers:
            continue
        if is_open and entry not in ctx.scope.read_only:
            continue
        if not isinstance(entry, Variable):
            if entry not in ctx.used:
                _unused(flow, "constant", entry)
        elif entry.kind in _INNER:
            if entry in ctx.used or entry.address is not None:
                _one_way(flow, ctx, entry, members_written, silent)
            elif flow.block.kind is not BlockKind.ORGANIZATION_BLOCK and (
                entry.overlay is not None or entry not in flow.program.byte_memory
            ):
                _unused(flow, "variable", entry)
        elif flow.block.kind is not BlockKind.ORGANIZATION_BLOCK and flow.block.syntax.body:
            _parameter(flow, ctx, entry)


def is_action(flow: Flow, ctx: "Context") -> bool:
    """True for an action, which has no variables of its own."""
    is_block = flow.block.kind is BlockKind.FUNCTION_BLOCK
    return is_block and ctx.owner is not None and ctx.owner is not flow.block


def inherited_names(ctx: "Context") -> Set[object]:
    """What the scope of a block has from its base."""
    objects = ctx.library.objects
    base = None if ctx.owner is None or ctx.method else objects.base_of(ctx.owner)
    return set() if base is None else set(ctx.library.context_of(base).scope.entries.values())


def _unused(flow: Flow, what: str, entry: "Entry") -> None:
    flow.report.warning(
        "FB4101",
        f"{what} '{entry.name}' of {flow.block.name} is never used",
        entry.span,
        "remove it",
        about=entry if isinstance(entry, Variable) else None,
    )


def _parameter(flow: Flow, ctx: "Context", entry: Variable) -> None:
    if entry.kind in _PARAMETERS:
        if entry not in ctx.used and not is_life_cycle(flow.block):
            flow.report.warning(
                "FB4201",
                f"{entry.kind.value} '{entry.name}' of {flow.block.name} is never used",
                entry.span,
                "remove it, or use it",
                about=entry,
            )
    elif (
        entry.kind is VariableKind.OUTPUT
        and entry.initial is None
        and entry not in flow.facts.written
        and not any(written.overlay is entry for written in flow.facts.written)
    ):
        flow.report.warning(
            "FB4202",
            f"nothing writes output '{entry.name}' of {flow.block.name}",
            entry.span,
            "assign it, or remove it",
            about=entry,
        )


def _one_way(
    flow: Flow,
    ctx: "Context",
    entry: Variable,
    members_written: Set[tuple[str, str]],
    silent: Set[Block],
) -> None:
    facts = flow.facts
    if entry in facts.touched or entry.address is not None or ctx.is_read_only(entry):
        return
    if entry in flow.program.byte_memory:
        return
    if any(entry is handed for handed, _ in start_places(flow.block)):
        return
    written, read = entry in facts.written, entry in facts.read
    hidden = entry.kind is VariableKind.TEMP or (
        not ctx.rules.statics_visible and flow.block.kind is BlockKind.FUNCTION_BLOCK
    )
    if written and not read and hidden:
        if _takes_what_says_nothing(flow, entry, silent):
            return
        flow.report.warning(
            "FB4203",
            f"variable '{entry.name}' of {flow.block.name} gets a value that nobody reads",
            facts.written[entry],
            "use the value, or remove the variable",
            about=entry,
        )
    elif (
        read
        and not written
        and entry not in flow.bits
        and entry.initial is None
        and isinstance(entry.type, Elementary | StringType)
        and (flow.block.name.casefold(), entry.name.casefold()) not in members_written
    ):
        flow.report.warning(
            "FB4205",
            f"variable '{entry.name}' of {flow.block.name} is read, but nothing writes it",
            entry.span,
            "assign it, give it an initial value, or make it an input",
            about=entry,
        )


def _takes_what_says_nothing(flow: Flow, entry: Variable, silent: Set[Block]) -> bool:
    """IEC 61131-3 calls functions in expressions only: what says nothing has to go somewhere."""
    taken = [call for variable, call in flow.facts.kept if variable is entry]
    written = sum(1 for variable, _, _ in flow.writes if variable is entry)
    return len(taken) == written and all(call.function in silent for call in taken)


def check_results(flow: Flow) -> None:
    """FB4102 and FB4204: what a function hands back and does not set, or not on every path."""
    block = flow.block
    if block.kind is not BlockKind.FUNCTION or not flow.alive:
        return
    for variable in _results(flow):
        if variable not in flow.facts.written:
            if variable is block.result and not _may_stay_unset(flow, variable):
                flow.report.warning(
                    "FB4102",
                    f"{block.name} never sets its result",
                    variable.span,
                    f"assign it: {block.name} := ...;",
                    about=variable,
                )
        elif variable in flow.bits and not flow.must & flow.bits[variable]:
            flow.report.warning(
                "FB4204",
                f"{block.name} does not set its {variable.kind.value}"
                f"{'' if variable is block.result else f' {variable.name!r}'} on every path",
                variable.span,
                "set it at the beginning, or in every branch",
                about=variable,
            )


def _may_stay_unset(flow: Flow, result: Variable) -> bool:
    """Methods and, in CODESYS and TwinCAT, BOOL functions often have a result for form's sake."""
    on_s7 = flow.program.dialect in ("tia", "step7")
    return not on_s7 and (is_method(flow.block) or result.type == BOOL)


def _results(flow: Flow) -> Iterable[Variable]:
    return (one for one in flow.block.variables if one.kind in _RESULTS)
