"""Which blocks are meant by the files that a user names: plant files, and PLC texts of his own."""

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

from fbgen.diagnostics import error
from harness.verify.mutation.stage import Stage

Homes: TypeAlias = Mapping[int, Collection[str] | None]
"""The cases that mutants are taken from, each with the names of the blocks, None for all."""

_PLANTS = (".yaml", ".yml")


def homes_of(stage: Stage, files: Sequence[Path]) -> Homes:
    """The cases with one of these plants, or with one of these texts among their sources.

    Raises DiagnosticError FB8066 for a file that no scenario has.
    """
    homes: dict[int, Collection[str] | None] = {}
    for file in files:
        whole = file.suffix.lower() in _PLANTS
        found = _with_plant(stage, file) if whole else _with_text(stage, file)
        if not found:
            what, key = ("plant", "plant") if whole else ("PLC text", "sources")
            message = f"no scenario has the {what} {file.as_posix()}"
            advice = f"name its scenarios with --scenarios; their key {key}: says which it is"
            raise error("FB8066", message, help=advice)
        for case, names in found.items():
            before = homes.get(case, ())
            homes[case] = None if names is None or before is None else {*before, *names}
    return homes


def _with_plant(stage: Stage, file: Path) -> Homes:
    return {
        number: None
        for number, case in enumerate(stage.cases)
        if case.plant is not None and case.plant.resolve() == file.resolve()
    }


def _with_text(stage: Stage, file: Path) -> Homes:
    """Only the blocks of the text itself: other sources of the scenario are not meant."""
    found: dict[int, set[str]] = {}
    for number, case in enumerate(stage.cases):
        if case.scenario.sources:
            for block in stage.program(number).bodies:
                if Path(block.span.source.name).resolve() == file.resolve():
                    found.setdefault(number, set()).add(block.name)
    return found
