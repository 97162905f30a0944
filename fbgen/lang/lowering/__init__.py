"""From canonical TIA SCL to another dialect: what one has and the other has not is said otherwise.

    iec = lower_files(files, "iec", Schedule(interval_ns=10_000_000))

All files of a plant go in together, as IEC wants declaration before use, has no data blocks, and
no function that touches global data. What comes out is one tree in an order that compiles: types,
functions, function blocks, programs, configuration. What cannot be said in the other dialect is
refused by name, all findings together. Spans stay those of the source, so origins survive.
"""

from collections.abc import Sequence

from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.ast import File
from fbgen.lang.depth import room_for_depth
from fbgen.lang.dialects import dialect_named
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.plant import PlantText
from fbgen.lang.lowering.schedule import Schedule
from fbgen.lang.lowering.target import TARGETS
from fbgen.lang.lowering.units import lower_units

__all__ = ["Schedule", "lower", "lower_files"]


def lower(file: File, target: str) -> File:
    """One file on its own in the dialect `target`. Raises as `lower_files` does."""
    return lower_files((file,), target)


def lower_files(files: Sequence[File], target: str, schedule: Schedule | None = None) -> File:
    """All files of a plant in the dialect `target`, as one file.

    `schedule` says how often programs run; by default every 10 ms. Raises `DiagnosticError`:
    FB3011 unknown dialect, FB3054 no way from one dialect to the other, FB3050 names, FB3051 what
    has no counterpart, FB3052 types, FB3053 functions that would need global data.
    """
    dialect_named(target)
    if not files:
        raise ValueError("no files to lower")
    dialects = {file.dialect for file in files}
    if dialects == {target} and len(files) == 1:
        return files[0]
    if dialects != {"tia"} or target not in TARGETS:
        raise error(
            "FB3054",
            f"cannot convert from {', '.join(sorted(dialects))} to {target}",
            help="text is written in dialect tia and lowered to " + " or ".join(TARGETS),
        )
    findings = Findings(target)
    plant = PlantText(files)
    with room_for_depth():
        units = lower_units(plant, TARGETS[target], schedule or Schedule(), findings)
    if findings.all:
        raise DiagnosticError(findings.all)
    closing = tuple(trivia for file in files for trivia in file.closing)
    return File(files[0].source, target, units, closing)
