"""`fbgen test`: runs scenario files on simulated plants.

A report that somebody asks for by an option is a `ReportWriter`: its module has the option and
makes the writer; here it is only named.
"""

from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from fbgen.cli import FINDINGS, INTERRUPTED, READER_GONE
from fbgen.cli.dialects import PlantDialectOption
from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import (
    Unread,
    going_on_unread,
    on_error_terminal,
    report,
    result,
    result_json,
    say,
)
from fbgen.cli.ports.hardware import HardwarePortOption, RealOption, YesOption, hardware_writer
from fbgen.cli.progress import Progress
from fbgen.cli.reports.coverage_report import CoverageOption, FailUnderOption, coverage_writer
from fbgen.cli.reports.failure_annotations import AnnotationsOption, AnnotationWriter, CodeHost
from fbgen.cli.reports.html_report import HtmlOption, HtmlWriter, asked_for
from fbgen.cli.reports.junit_report import JunitOption, JunitWriter
from fbgen.cli.reports.trace_reports import TraceOption, VcdOption, trace_writers

if TYPE_CHECKING:
    from collections.abc import Sequence

    from fbgen.diagnostics import Diagnostic, DiagnosticError
    from harness.scenario import ReportWriter, ScenarioReport, ScenarioResult

NS_PER_S = 1_000_000_000


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        "test",
        epilog=examples(
            "fbgen test",
            "fbgen test scenarios/start.scenario.yaml",
            "fbgen test scenarios -k 'start and not reverse' -j 4",
            "fbgen test scenarios --dialect step7",
            "fbgen test scenarios --seed 7 --json",
            "fbgen test scenarios --temporaries undefined",
            "fbgen test scenarios --junit results.xml --annotations github",
            "fbgen test scenarios --catalog our_catalog",
            "fbgen test scenarios --html report.html",
            "fbgen test scenarios --trace runs.jsonl --vcd waves",
            "fbgen test scenarios --coverage coverage.html --fail-under statement=90,branch=80",
            "fbgen test start.scenario.yaml --port COM3 --real pump     in real time",
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
    jobs: Annotated[
        int,
        typer.Option("-j", "--jobs", metavar="N", min=1, help="Processes: one scenario each."),
    ] = 1,
    dialect: PlantDialectOption = None,
    temporaries: Annotated[
        Literal["initial", "undefined"] | None,
        typer.Option(
            "--temporaries",
            help="What temporary variables hold before they are written, whatever the files say: "
            "their defaults, or anything, as on an S7.",
        ),
    ] = None,
    catalog: CatalogOption = None,
    junit: JunitOption = None,
    html: HtmlOption = None,
    annotations: AnnotationsOption = None,
    trace: TraceOption = None,
    vcd: VcdOption = None,
    coverage: CoverageOption = None,
    fail_under: FailUnderOption = "",
    port: HardwarePortOption = None,
    real: RealOption = None,
    yes: YesOption = False,
    as_json: JsonOption = False,
) -> None:
    """Run scenario files on simulated plants.

    Each generates its plant, reads that text, simulates the plant, does its steps and checks what
    they expect. The same seed gives the same run, with however many processes. With --port, real
    inverters take the place of simulated ones. Exit status 1 if a scenario fails, 130 after Ctrl-C.
    """
    from harness.scenario import RunOptions, run_paths

    if as_json and annotations is CodeHost.GITHUB:
        raise typer.BadParameter("--json and --annotations github both print on standard output")
    with hardware_writer(port, real, jobs, yes=yes) as hardware:
        asked: list[ReportWriter | None] = [
            hardware,
            JunitWriter(junit) if junit else None,
            HtmlWriter(html, asked_for(seed, select, dialect, temporaries)) if html else None,
            AnnotationWriter(annotations) if annotations else None,
            coverage_writer(coverage, fail_under, prints=not as_json),
        ]
        writers = [*(writer for writer in asked if writer is not None), *trace_writers(trace, vcd)]
        observers = tuple(dict.fromkeys(one for writer in writers for one in writer.observers))
        session = _Session()
        # Reports are written although nobody reads the terminal any more, as behind `| head`.
        with going_on_unread() if writers else nullcontext(Unread()) as unread:
            done = run_paths(
                paths or [Path()],
                RunOptions(
                    *(seed, select, dialect, jobs, observers, temporaries, tuple(catalog or ())),
                ),
                planned=session.planned,
                finished=session.counted if as_json else session.shown,
            )
            if not done.results and not done.interrupted:
                raise _nothing_selected(select)
            findings = [found for writer in writers for found in _written(writer, done)]
            if as_json:
                result_json({"scenarios": [scenario.as_json() for scenario in done.results]})
            report(findings)
            say(session.summary(done))
    if done.interrupted:
        raise typer.Exit(INTERRUPTED)
    if findings or not done.passed:
        raise typer.Exit(FINDINGS)
    if unread.gone:
        raise typer.Exit(READER_GONE)


def _written(writer: "ReportWriter", done: "ScenarioReport") -> "Sequence[Diagnostic]":
    """Write a report. One that cannot be written keeps no other from being written."""
    from fbgen.diagnostics import DiagnosticError

    try:
        return writer.write(done)
    except DiagnosticError as wrong:
        return wrong.diagnostics


def _nothing_selected(select: str) -> "DiagnosticError":
    from fbgen.diagnostics import error

    return error(
        "FB9006",
        f"no scenario fits -k '{select}'",
        help="without -k all run, each with its title",
    )


class _Session:
    """Shows how far it is and what came of each scenario, as soon as that is known."""

    def __init__(self) -> None:
        self._progress = Progress(0, shown=False)
        self._total = 0

    def planned(self, total: int) -> None:
        self._total = total
        self._progress = Progress(total, shown=on_error_terminal())

    def counted(self, scenario: "ScenarioResult") -> None:
        self._progress.step(scenario.name)

    def shown(self, scenario: "ScenarioResult") -> None:
        self._progress.end()
        _show(scenario)
        self.counted(scenario)

    def summary(self, done: "ScenarioReport") -> str:
        self._progress.end()
        failed = sum(not scenario.passed for scenario in done.results)
        counts = f"{len(done.results) - failed} passed, {failed} failed"
        if done.interrupted:
            return f"stopped by Ctrl-C: {counts}, {self._total - len(done.results)} not run"
        return counts


def _show(scenario: "ScenarioResult") -> None:
    result(
        f"{_state(scenario)}  {scenario.virtual_ns / NS_PER_S:8.3f} s  "
        f"{scenario.file}  {scenario.name}"
    )
    report(scenario.warnings)
    if not scenario.passed:
        report(scenario.failures)
        say(f"run it again: {scenario.replay}\n")


def _state(scenario: "ScenarioResult") -> str:
    if scenario.passed and scenario.expected_failure is not None:
        return f"failed as expected ({scenario.expected_failure})"
    return "passed" if scenario.passed else "FAILED"
