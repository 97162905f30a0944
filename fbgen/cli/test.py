"""`fbgen test`: runs scenario files on simulated plants."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.dialects import PlantDialectOption
from fbgen.cli.examples import examples
from fbgen.cli.layers import JsonOption
from fbgen.cli.output import report, result, result_json, say

if TYPE_CHECKING:
    from harness.scenario import ScenarioResult

NS_PER_S = 1_000_000_000


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        "test",
        epilog=examples(
            "fbgen test",
            "fbgen test scenarios/start.scenario.yaml",
            "fbgen test scenarios -k 'start and not reverse'",
            "fbgen test scenarios --dialect step7",
            "fbgen test scenarios --seed 7 --json",
        ),
    )(run_scenarios)


def run_scenarios(
    paths: Annotated[
        list[Path] | None,
        typer.Argument(
            metavar="PATHS",
            help="Scenario files, or folders with files *.scenario.yaml; else this folder.",
        ),
    ] = None,
    select: Annotated[
        str,
        typer.Option(
            "-k",
            metavar="EXPR",
            help="Only scenarios whose title, file, variation or a tag contains this word; "
            "and, or, not and parentheses combine words.",
        ),
    ] = "",
    seed: Annotated[
        int | None,
        typer.Option("--seed", metavar="N", min=0, help="This seed instead of the files' own."),
    ] = None,
    dialect: PlantDialectOption = None,
    as_json: JsonOption = False,
) -> None:
    """Run scenario files on simulated plants.

    Each generates its plant, reads that text, simulates the plant, does its steps and checks what
    they expect. The same seed gives the same run. Exit status 1 if a scenario fails.
    """
    from fbgen.diagnostics import error
    from harness.scenario import run_paths

    done = run_paths(
        paths or [Path()],
        seed=seed,
        select=select,
        dialect=dialect,
        finished=(lambda _: None) if as_json else _show,
    )
    if not done.results:
        raise error(
            "FB9006",
            f"no scenario fits -k '{select}'",
            help="without -k all run, each with its title",
        )
    failed = sum(not scenario.passed for scenario in done.results)
    if as_json:
        result_json({"scenarios": [scenario.as_json() for scenario in done.results]})
    say(f"{len(done.results) - failed} passed, {failed} failed")
    if failed:
        raise typer.Exit(FINDINGS)


def _show(scenario: "ScenarioResult") -> None:
    state = "passed" if scenario.passed else "FAILED"
    result(f"{state}  {scenario.virtual_ns / NS_PER_S:8.3f} s  {scenario.file}  {scenario.name}")
    if not scenario.passed:
        report(scenario.failures)
        say(f"run it again: {scenario.replay}\n")
