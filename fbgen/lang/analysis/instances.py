"""Timers, counters and edges: called once in a cycle, in every cycle.

Sources: IEC 61131-3 third edition, tables 43 to 46 (each call is one step of the block); TIA Portal
help, "Calling timers" (a timer is brought up to date by its call), "TON: Generate on-delay" (and at
an access to Q or ET).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from fbgen.diagnostics import Note
from fbgen.lang.analysis.effects import Effects, PlaceKey, key_of
from fbgen.lang.analysis.report import Report
from fbgen.lang.checked import Constant, FieldRef, InstanceCall, StandardBlock

if TYPE_CHECKING:
    from fbgen.lang.analysis.flow import Flow

_ONE_STEP_A_CALL = ("TON", "TOF", "TP", "TONR", "CTU", "CTD", "CTUD", "R_TRIG", "F_TRIG")
_STARTS = ("IN", "CU", "CD", "CLK")
_RESETS = ("R", "LD", "RESET")


def counts_its_calls(block: StandardBlock) -> bool:
    """True for blocks that depend on when and how often they are called."""
    return block.name.partition("_L")[0].startswith(_ONE_STEP_A_CALL)


def resets(call: InstanceCall) -> bool:
    """True for a call that only puts the block back: another one may come before or after it."""
    for variable, value in call.inputs:
        if isinstance(value, Constant) and (
            (variable.name.upper() in _STARTS and value.value is False)
            or (variable.name.upper() in _RESETS and value.value is True)
        ):
            return True
    return False


def starts_anew(call: InstanceCall) -> bool:
    """True for a call after which the block is as if nobody had called it yet.

    TOF and TP go on for their time after IN, a counter keeps its count, TONR its time.
    """
    kind = call.block.name.partition("_")[0]
    begins = ("IN",) if kind == "TON" else ("CLK",) if kind == "R" else ()
    return any(
        isinstance(value, Constant)
        and (
            (variable.name.upper() in begins and value.value is False)
            or (variable.name.upper() in _RESETS and value.value is True)
        )
        for variable, value in call.inputs
    )


def check_own_end(
    report: Report, node: InstanceCall, key: PlaceKey, read_before: Sequence[FieldRef]
) -> None:
    """FB4225: IN reads Q, which brings the timer up to date, so nobody sees its end."""
    if not node.block.name.startswith("TON"):
        return
    effects = Effects()
    for variable, value in node.inputs:
        if variable.name.upper() == "IN":
            effects.value(value)
    own = next((one for one in effects.members if _is_own(one, key)), None)
    if own is None or any(_is_own(one, key) for one in read_before):
        return
    report.warning(
        "FB4225",
        f"'{node.instance.span.text}' resets itself before anybody sees its Q: reading Q for IN"
        " brings it up to date, and this call sets it back",
        own.span,
        f"read it once in front of the call: done := {own.span.text}; and use that everywhere",
    )


def _is_own(member: FieldRef, key: PlaceKey) -> bool:
    return member.name.upper() == "Q" and key_of(member.base) == key


def _is_another_kind(calls: Sequence[tuple[InstanceCall, int]], node: InstanceCall) -> bool:
    """True for what FB4226 says better: TON and TOF of one instance."""
    return bool(calls) and calls[0][0].block is not node.block


class InstanceTracker:
    """The calls of the instances of a block, path by path."""

    __slots__ = ("_bits", "_calls", "_report")

    def __init__(self, report: Report) -> None:
        self._report = report
        self._bits: dict[PlaceKey, int] = {}
        self._calls: dict[PlaceKey, list[tuple[InstanceCall, int]]] = {}

    def called(self, flow: "Flow", node: InstanceCall, key: PlaceKey, *, in_loop: bool) -> None:
        """FB4221: twice on one path, or in a loop."""
        if not isinstance(node.block, StandardBlock) or not counts_its_calls(node.block):
            return
        calls = self._calls.setdefault(key, [])
        bit = self._bits.setdefault(key, 1 << (len(flow.bits) + len(self._bits)))
        if in_loop:
            self._report.warning(
                "FB4221",
                f"'{node.instance.span.text}' is called in a loop, so it takes several steps in"
                " one cycle",
                node.span,
                "call it once outside of the loop, or use an array of instances",
            )
        elif flow.may & bit and not resets(node) and not _is_another_kind(calls, node):
            self._report.warning(
                "FB4221",
                f"'{node.instance.span.text}' is called a second time in the same cycle",
                node.span,
                "call it once and use its outputs, or declare an instance for each call",
                notes=(Note("the first call is here", calls[0][0].span),) if calls else (),
            )
        calls.append((node, flow.depth))
        if starts_anew(node):
            flow.may &= ~bit
        elif not resets(node):
            flow.may |= bit

    def report_conditional(self) -> None:
        """FB4220: the only call of an instance stands under a condition."""
        for calls in self._calls.values():
            node, depth = calls[0]
            if len(calls) > 1 or depth == 0:
                continue
            self._report.warning(
                "FB4220",
                f"'{node.instance.span.text}' is called under a condition only: while that does"
                f" not hold, the {node.block.name} stands still",
                node.span,
                "call it in every cycle and put the condition into its input",
            )
