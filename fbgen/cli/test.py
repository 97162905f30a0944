"""`fbgen test`: runs scenario files on simulated plants."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.examples import examples
from fbgen.cli.layers import JsonOption
from fbgen.cli.output import report, result, result_json, say

if TYPE_CHECKING:
    from harness.scenario import ScenarioReport, ScenarioResult

NS_PER_S = 1_000_000_000


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        "test",
        epilog=examples(
            "fbgen test",
            "fbgen test scenarios/start.yaml",
            "fbgen test scenarios -k 'start and not reverse'",
            "fbgen test scenarios --seed 7 --json",
        ),
    )(run_scenarios)


def run_scenarios(
    paths: Annotated[
        list[Path] | None,
        typer.Argument(metavar="[PATHS]...", help="Scenario files or folders with them."),
    ] = None,
    select: Annotated[
        str, typer.Option("-k", metavar="EXPR", help="Only scenarios whose names fit.")
    ] = "",
    seed: Annotated[
        int, typer.Option("--seed", metavar="N", help="Seed of all that is random.")
    ] = 0,
    as_json: JsonOption = False,
) -> None:
    """Run scenario files on simulated plants.

    Each generates its plant, simulates it, does its steps and checks what they expect. The same
    seed gives the same run. Exit status 1 if a scenario fails.
    """
    from harness.scenario import run_paths

    done = run_paths(paths or [Path()], seed=seed, select=select)
    if as_json:
        result_json(_as_json(done, seed))
    else:
        for scenario in done.results:
            _show(scenario)
    failed = sum(not scenario.passed for scenario in done.results)
    say(f"{len(done.results) - failed} passed, {failed} failed")
    if failed:
        raise typer.Exit(FINDINGS)


def _show(scenario: "ScenarioResult") -> None:
    state = "passed" if scenario.passed else "FAILED"
    result(f"{state}  {scenario.virtual_ns / NS_PER_S:8.3f} s  {scenario.file}  {scenario.name}")
    report(scenario.failures)


def _as_json(done: "ScenarioReport", seed: int) -> dict[str, object]:
    return {
        "seed": seed,
        "scenarios": [
            {
                "name": scenario.name,
                "file": str(scenario.file),
                "passed": scenario.passed,
                "virtual_ns": scenario.virtual_ns,
                "failures": [failure.as_json() for failure in scenario.failures],
            }
            for scenario in done.results
        ],
    }
