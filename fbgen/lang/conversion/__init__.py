"""From one dialect of the PLC language to another.

    step7 = convert([parse(source, "tia")], "step7")

Text goes from dialect to dialect in steps, each of which is a module here or next door in
`lowering`; every dialect has a way to and from `tia`. What the other dialect cannot say is refused
by name, all findings together. Comments, layout and spans survive.
"""

from collections import deque
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import TypeAlias

from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.ast import File
from fbgen.lang.conversion.between_iec import iec_to_twincat, twincat_to_iec
from fbgen.lang.conversion.crossed_limits import with_same_limits
from fbgen.lang.conversion.falling_edges import with_own_falling_edges
from fbgen.lang.conversion.first_dates import with_same_dates
from fbgen.lang.conversion.from_step7 import from_step7
from fbgen.lang.conversion.handed_on import with_copies
from fbgen.lang.conversion.iec_to_tia import iec_to_tia
from fbgen.lang.conversion.to_step7 import to_step7
from fbgen.lang.depth import room_for_depth
from fbgen.lang.dialects import dialect_named
from fbgen.lang.lowering import Schedule, lower_files
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.other_languages import foreign_bodies

__all__ = ["Schedule", "convert", "way", "with_copies"]

Step: TypeAlias = Callable[[Sequence[File], Findings, Schedule | None], list[File]]

_STEPS: dict[tuple[str, str], Step] = {
    ("tia", "step7"): lambda files, findings, _: to_step7(files, findings),
    ("step7", "tia"): lambda files, findings, _: from_step7(files, findings),
    ("tia", "iec"): lambda files, _, schedule: [lower_files(files, "iec", schedule)],
    ("iec", "tia"): lambda files, findings, _: iec_to_tia(files, findings),
    ("twincat", "tia"): lambda files, findings, _: iec_to_tia(files, findings),
    ("iec", "twincat"): lambda files, findings, _: iec_to_twincat(files, findings),
    ("twincat", "iec"): lambda files, findings, _: twincat_to_iec(files, findings),
    ("tia", "twincat"): lambda files, _, schedule: [lower_files(files, "twincat", schedule)],
}


def way(source: str, target: str) -> tuple[str, ...]:
    """The dialects on the shortest way, both ends included; empty if there is none."""
    ways: deque[tuple[str, ...]] = deque([(source,)])
    seen = {source}
    while ways:
        so_far = ways.popleft()
        if so_far[-1] == target:
            return so_far
        for first, second in _STEPS:
            if first == so_far[-1] and second not in seen:
                seen.add(second)
                ways.append((*so_far, second))
    return ()


def convert(files: Sequence[File], target: str, schedule: Schedule | None = None) -> list[File]:
    """The files in the dialect `target`; they are one program and of one dialect.

    Dialects `iec` and `twincat` come as one file, in an order that compiles; `schedule` says how
    often programs of `iec` run, by default every 10 ms. Raises `DiagnosticError`: FB3011
    unknown dialect, FB3054 no way between the dialects, FB3050 names, FB3051 what has no
    counterpart, FB3052 types, FB3053 functions that would need global data.
    """
    dialect_named(target)
    sources = sorted({file.dialect for file in files})
    if len(sources) != 1:
        raise error(
            "FB3054",
            f"the files are in different dialects: {', '.join(sources)}",
            help="convert those of each dialect on their own",
        )
    dialects = way(sources[0], target)
    if not dialects:
        raise error(
            "FB3054",
            f"there is no way from dialect {sources[0]} to {target}",
            help="choose another target: " + ", ".join(_reachable(sources[0])),
        )
    refused = Findings(target)
    for span, language in foreign_bodies(files):
        refused.refuse(f"a body in {language}", span, "write it in structured text first")
    if refused.all:
        raise DiagnosticError(refused.all)
    result = with_same_limits(with_own_falling_edges(files, target), target, refused)
    result = with_same_dates(result, target, refused)
    if refused.all:
        raise DiagnosticError(refused.all)
    for first, second in pairwise(dialects):
        findings = Findings(second)
        with room_for_depth():
            result = _STEPS[first, second](result, findings, schedule)
        if findings.all:
            raise DiagnosticError(findings.all)
    return result


def _reachable(source: str) -> list[str]:
    targets = dict.fromkeys(second for _, second in _STEPS)
    return [target for target in targets if target != source and way(source, target)]
