"""All warnings of a checked program."""

from bisect import bisect_left
from typing import TYPE_CHECKING

from fbgen.lang.analysis.flow import Flow, follow
from fbgen.lang.analysis.names import check_names
from fbgen.lang.analysis.outputs import check_outputs
from fbgen.lang.analysis.program_rules import (
    check_dropped_results,
    check_shared_instances,
    check_timer_kinds,
    check_uncalled,
    functions_that_say_nothing,
    written_from_outside,
)
from fbgen.lang.analysis.usage import check_results, check_usage
from fbgen.lang.analysis.vague import vague_variables
from fbgen.lang.checked import Program
from fbgen.source import Source

if TYPE_CHECKING:
    from fbgen.lang.checker.findings import Findings
    from fbgen.lang.checker.library import Library


def analyse(program: Program, library: "Library", findings: "Findings") -> None:
    """Report every warning. Statements with errors are missing in the program: what these may
    have done to their variables is not guessed.
    """
    errors: dict[Source, list[int]] = {}
    for place in findings.error_places():
        errors.setdefault(place.source, []).append(place.start)
    for offsets in errors.values():
        offsets.sort()
    flows: list[Flow] = []
    for block, body in program.bodies.items():
        if library.objects.is_promise(block) or block in library.starts.bodies:
            continue
        ctx = library.context_of(block)
        span = block.syntax.span
        offsets = errors.get(span.source, [])
        inside = offsets[bisect_left(offsets, span.start) : bisect_left(offsets, span.end)]
        unclear = inside or block.syntax.members
        vague = vague_variables(ctx, block.syntax, inside) if unclear else frozenset()
        flows.append(follow(block, body, program, vague))
    members_written = written_from_outside(flows)
    silent = functions_that_say_nothing(flows)
    for flow in flows:
        ctx = library.context_of(flow.block)
        check_usage(flow, ctx, members_written, silent)
        check_results(flow)
        check_names(flow, ctx)
    check_uncalled(flows)
    check_shared_instances(flows)
    check_timer_kinds(flows)
    check_dropped_results(flows, silent)
    check_outputs(flows)
    for flow in flows:
        for warned in flow.report.found:
            findings.add(warned.diagnostic)
