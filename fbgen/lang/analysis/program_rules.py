"""Rules over all blocks: instances that several blocks call or nobody calls, dropped results."""

from collections.abc import Sequence, Set

from fbgen.diagnostics import Note
from fbgen.lang.analysis.effects import PlaceKey, root_of
from fbgen.lang.analysis.facts import CalledInstance
from fbgen.lang.analysis.flow import Flow
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import AnyBlock, Block, FunctionCall, Variable, VariableKind
from fbgen.lang.life_cycle import is_method
from fbgen.lang.types import BOOL, BlockType

_TIMERS = ("TON", "TOF", "TP", "TONR")
_OWN = (VariableKind.STATIC, VariableKind.TEMP, VariableKind.GLOBAL)


def check_uncalled(flows: Sequence[Flow]) -> None:
    """FB4222: outputs of an instance are read, and nothing calls it."""
    served: set[Variable] = set()
    for flow in flows:
        served |= flow.facts.touched
        for called in flow.facts.instances:
            root = root_of(called.call.instance)
            if root is not None:
                served.add(root)
    for flow in flows:
        reported: set[Variable] = set()
        for member in flow.facts.members_read:
            root = root_of(member.base)
            if root is None or root in served or root in reported or root.kind not in _OWN:
                continue
            kind = member.base.type
            assert isinstance(kind, BlockType)
            block = flow.program.block_of(kind.name)
            if is_program(block):
                continue  # the controller calls it
            if not any(
                one.kind is VariableKind.OUTPUT and one.name == member.name
                for one in block.variables
            ):
                continue
            reported.add(root)
            flow.report.warning(
                "FB4222",
                f"output '{member.name}' of '{root.name}' is read, but nothing calls it",
                member.span,
                f"call it: {root.name}(...);",
                about=root,
            )


def is_program(block: AnyBlock) -> bool:
    """True for a PROGRAM, which is its own instance."""
    return isinstance(block, Block) and block.kind is BlockKind.PROGRAM


def check_shared_instances(flows: Sequence[Flow]) -> None:
    """FB4223: one instance in the hands of two blocks mixes up the states of both."""
    first: dict[PlaceKey, tuple[Flow, CalledInstance]] = {}
    for flow in flows:
        reported: set[PlaceKey] = set()
        for called in flow.facts.instances:
            root = root_of(called.call.instance)
            if called.key is None or root is None or root.kind is not VariableKind.GLOBAL:
                continue
            if is_program(called.call.block):
                continue  # it is there once, and all know it
            other, earlier = first.setdefault(called.key, (flow, called))
            if other is flow or called.key in reported:
                continue
            reported.add(called.key)
            flow.report.warning(
                "FB4223",
                f"'{called.call.instance.span.text}' is called by {other.block.name} too",
                called.call.span,
                "call it in one block only, or give each block an instance of its own",
                notes=(Note("the first call is here", earlier.call.span),),
            )


def check_timer_kinds(flows: Sequence[Flow]) -> None:
    """FB4226: one instance of a timer is called as two kinds."""
    first: dict[PlaceKey, CalledInstance] = {}
    for flow in flows:
        for called in flow.facts.instances:
            name = called.call.block.name.partition("_")[0]
            if called.key is None or name not in _TIMERS:
                continue
            earlier = first.setdefault(called.key, called).call
            before = earlier.block.name.partition("_")[0]
            if before != name:
                flow.report.warning(
                    "FB4226",
                    f"'{called.call.instance.span.text}' is called as {name} here and as {before}"
                    " elsewhere: each change starts it anew",
                    called.call.span,
                    "declare an instance for each",
                    notes=(Note("the other call is here", earlier.span),),
                )


def functions_that_say_nothing(flows: Sequence[Flow]) -> set[Block]:
    """Functions with a BOOL for form's sake: nothing sets it, or it is TRUE and nothing else."""
    return {
        flow.block
        for flow in flows
        if flow.block.result is not None
        and flow.block.result.type == BOOL
        and flow.facts.always_true
        == sum(1 for variable, _, _ in flow.writes if variable is flow.block.result)
    }


def check_dropped_results(flows: Sequence[Flow], silent: Set[Block]) -> None:
    """FB4234 and FB4235: a function is called and its result goes nowhere."""
    by_block = {flow.block: flow for flow in flows}
    for flow in flows:
        for call in flow.facts.dropped:
            callee = by_block.get(call.function)
            result = call.function.result
            if callee is None or result is None:
                continue
            if _does_nothing_else(call, callee):
                flow.report.warning(
                    "FB4234",
                    f"the result of {call.function.name} is dropped, and it does nothing else",
                    call.span,
                    f"use the result: x := {call.function.name}(...);",
                )
            elif call.type == BOOL and call.function not in silent and not is_method(call.function):
                flow.report.warning(
                    "FB4235",
                    f"the answer of {call.function.name} is dropped",
                    call.span,
                    f"ask for it: IF {call.function.name}(...) THEN",
                )


def _does_nothing_else(call: FunctionCall, callee: Flow) -> bool:
    facts = callee.facts
    return not (
        call.in_outs
        or call.outputs
        or facts.uses_outside
        or facts.addresses_written
        or facts.instances
        or facts.dropped
        or any(variable.kind is VariableKind.GLOBAL for variable in facts.written)
        or not callee.block.syntax.body
    )


def written_from_outside(flows: Sequence[Flow]) -> set[tuple[str, str]]:
    """(block, variable), casefolded, of what other blocks write in instances."""
    found = set()
    for flow in flows:
        for member in flow.facts.members_written:
            kind = member.base.type
            found.add((kind.name.casefold(), member.name.casefold()))
    return found
