"""`fbgen mutate`: would the scenarios notice a mistake in the PLC text?"""

import sys
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS, INTERRUPTED
from fbgen.cli.examples import examples
from fbgen.cli.output import on_error_terminal, report, result, say

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from harness.scenario.model import Variation
    from harness.verify.mutation.equivalents import Equivalents
    from harness.verify.mutation.mutant import Operator
    from harness.verify.mutation.session import MutationRun
    from harness.verify.mutation.stage import Stage
    from harness.verify.mutation.work import Cases


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        "mutate",
        epilog=examples(
            "fbgen mutate plant.yaml --scenarios scenarios",
            "fbgen mutate plant.yaml --block TOS_Telegram -j 4 --html mutants.html",
            "fbgen mutate --operators bits,byte_order --fail-under 95",
            "fbgen mutate own.scl --scenarios scenarios",
            "fbgen mutate --mutant TOS_Handshake:44:mask:1",
        ),
    )(mutate)


def mutate(
    files: Annotated[
        list[Path] | None,
        typer.Argument(
            metavar="FILES",
            help="Plant files and PLC texts whose blocks are changed; else those of all the "
            "scenarios.",
        ),
    ] = None,
    scenarios: Annotated[
        list[Path] | None,
        typer.Option(
            "--scenarios",
            metavar="PATHS",
            help="Scenario files, or folders with them; else this folder. May be given again.",
        ),
    ] = None,
    block: Annotated[
        list[str] | None,
        typer.Option("--block", metavar="NAME", help="Only this block. May be given again."),
    ] = None,
    operators: Annotated[
        str,
        typer.Option("--operators", metavar="LIST", help="Only these kinds of changes: a,b,..."),
    ] = "",
    mutant: Annotated[
        list[str] | None,
        typer.Option("--mutant", metavar="ID", help="Only this mutant, with what killed it."),
    ] = None,
    most: Annotated[
        int | None,
        typer.Option("--max", metavar="N", min=1, help="At most so many mutants, drawn by --seed."),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", min=0, help="For --max.")] = 0,
    variations: Annotated[
        bool,
        typer.Option("--variations", help="All variations of a scenario, not only the first."),
    ] = False,
    jobs: Annotated[
        int | None,
        typer.Option(
            "-j", "--jobs", metavar="N", min=1, help="Processes that work; else all processors."
        ),
    ] = None,
    prove: Annotated[
        bool,
        typer.Option("--prove", help="Look for proofs that survivors are equivalent; takes z3."),
    ] = False,
    equivalents: Annotated[
        Path | None,
        typer.Option(
            "--equivalents",
            metavar="FILE",
            help="Reasons why mutants are equivalent; else mutation-equivalents.yaml beside the "
            "scenarios.",
        ),
    ] = None,
    log: Annotated[
        Path | None,
        typer.Option("--log", metavar="FILE", help="Go on from there after Ctrl-C."),
    ] = None,
    json_file: Annotated[
        Path | None, typer.Option("--json", metavar="FILE", help="Write everything as JSON.")
    ] = None,
    html_file: Annotated[
        Path | None, typer.Option("--html", metavar="FILE", help="Write a page for people.")
    ] = None,
    fail_under: Annotated[
        float,
        typer.Option("--fail-under", metavar="PERCENT", min=0, max=100, help="The least score."),
    ] = 0.0,
) -> None:
    """Change the PLC text in small ways and see whether a scenario notices.

    Each mutant differs from the text in one place: another comparison, a bit moved, a statement
    left out. Those that no check notices are listed. Exit status 1 if the score is too low.
    """
    from harness.verify.mutation import report as found
    from harness.verify.mutation.explained import wrong_reasons
    from harness.verify.mutation.homes import homes_of
    from harness.verify.mutation.session import Wanted, run_mutants
    from harness.verify.mutation.subjects import targets_of
    from harness.verify.mutation.work import stage_of

    kinds = _operators(operators)
    if prove:
        _need_solver()
    paths = scenarios or [Path()]
    reasons = _reasons(equivalents, paths)
    cases = _cases(paths, every=variations)
    stage = stage_of(cases)
    homes = homes_of(stage, files) if files else None
    targets = targets_of(stage, block or _blocks_in(mutant or ()), homes)
    wanted = Wanted(
        kinds, most, seed, tuple(mutant or ()), jobs or _processors(), prove, log, reasons
    )
    shown = _Shown()
    run = run_mutants(cases, targets, wanted, began=shown.began, finished=shown.finished)
    shown.end()
    for one in run.tried if mutant else found.survivors(run.tried):
        result("\n".join(found.described(one)) + "\n")
    if mutant:
        _show_checks(stage, run)
    result(found.table(run))
    _write(json_file, html_file, run)
    if run.interrupted:
        say(f"stopped by Ctrl-C: {run.planned - len(run.tried)} mutants not tried")
        raise typer.Exit(INTERRUPTED)
    findings = [*wrong_reasons(run, stage, reasons), *found.too_low(run, fail_under)]
    if findings:
        report(findings)
        raise typer.Exit(FINDINGS)


def _processors() -> int:
    import os

    return os.cpu_count() or 1


def _need_solver() -> None:
    from importlib.util import find_spec

    from fbgen.diagnostics import error

    if find_spec("z3") is None:
        raise error(
            "FB8067",
            "proofs need the package z3-solver, which is not there",
            help="pip install fbgen[proof]",
        )


def _operators(text: str) -> "Collection[Operator]":
    from fbgen.diagnostics import error
    from fbgen.nearest import nearest
    from harness.verify.mutation.finding import ALL
    from harness.verify.mutation.mutant import Operator

    names = [name.strip() for name in text.split(",") if name.strip()]
    known = {operator.value: operator for operator in Operator}
    for name in names:
        if name not in known:
            message = f"there is no kind of changes '{name}'"
            raise error("FB8065", message, help=nearest(name, tuple(known)))
    return [known[name] for name in names] or ALL


def _cases(paths: "Sequence[Path]", *, every: bool) -> "Cases":
    """The cases of these scenarios; of each row the first variation, or every one."""
    from harness.scenario import find_scenarios, scenario_cases
    from harness.verify.mutation.work import CaseName

    found: list[CaseName] = []
    for path in find_scenarios(paths):
        first: dict[str, Variation] = {}
        for number, case in enumerate(scenario_cases(path)):
            variation = first.setdefault(case.row, case.variation)
            if (every or case.variation == variation) and case.scenario.expect_failure is None:
                found.append(CaseName(path, number))
    return tuple(found)


def _reasons(file: Path | None, paths: "Sequence[Path]") -> "Equivalents":
    """The file of reasons that is named, or the one that lies beside the scenarios."""
    from harness.verify.mutation.equivalents import FILE_NAME, NO_REASONS, load_equivalents

    folders = [path if path.is_dir() else path.parent for path in paths]
    there = [folder / FILE_NAME for folder in folders if (folder / FILE_NAME).is_file()]
    chosen = file or next(iter(there), None)
    return NO_REASONS if chosen is None else load_equivalents(chosen)


def _blocks_in(mutants: "Sequence[str]") -> list[str]:
    """The blocks that ids of mutants name."""
    return list(dict.fromkeys(name.rpartition("/")[2].partition(":")[0] for name in mutants))


def _show_checks(stage: "Stage", run: "MutationRun") -> None:
    """The check that has noticed each mutant, in full."""
    for one in run.tried:
        for case, known in enumerate(stage.cases):
            if known.name == one.verdict.scenario:
                other = stage.mutant(one.target.subject.block.name, one.number)
                report(stage.run(case, other).failures)
                break


def _write(json_file: Path | None, html_file: Path | None, run: "MutationRun") -> None:
    import json

    from fbgen.cli.files import write_file
    from harness.verify.mutation.html import page
    from harness.verify.mutation.report import as_json

    if json_file is not None:
        write_file(json_file, json.dumps(as_json(run), indent=1) + "\n", overwrite=True)
    if html_file is not None:
        write_file(html_file, page(run), overwrite=True)


class _Shown:
    """How far it is, with the rate, on a terminal."""

    def __init__(self) -> None:
        self._what = ""
        self._total = self._done = 0
        self._begin = monotonic()

    def began(self, what: str, total: int) -> None:
        self.end()
        self._what, self._total, self._done, self._begin = what, total, 0, monotonic()

    def finished(self, what: str) -> None:
        self._done += 1
        if on_error_terminal():
            rate = self._done / max(monotonic() - self._begin, 0.001)
            text = f"{self._done} of {self._total} {self._what}, {rate:.1f} a second: {what}"
            sys.stderr.write(f"\r\x1b[K{text}")
            sys.stderr.flush()

    def end(self) -> None:
        """Clear the line."""
        if self._done and on_error_terminal():
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
