"""`fbgen test --trace` and `--vcd`: what each run leaves, for programs and for wave viewers."""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.dataclass import dataclass

if TYPE_CHECKING:
    from fbgen.diagnostics import Diagnostic
    from harness.results import ScenarioReport
    from harness.scenario import ObserverMaker, ReportWriter

_SUFFIX = ".vcd"

TraceOption = Annotated[
    Path | None,
    typer.Option(
        "--trace",
        metavar="FILE",
        help="Write what each run leaves as JSON Lines, all runs into one file.",
    ),
]
VcdOption = Annotated[
    Path | None,
    typer.Option(
        "--vcd",
        metavar="PATH",
        help="Write it for wave viewers: a file .vcd for one scenario, a folder for several.",
    ),
]


def trace_writers(trace: Path | None, vcd: Path | None) -> Iterator["ReportWriter"]:
    """What has been asked for. Raises DiagnosticError FB8041 if a package is missing."""
    if trace is not None:
        yield TraceFile(trace)
    if vcd is not None:
        from harness.trace.vcd import need_pyvcd

        need_pyvcd()
        yield VcdFiles(vcd)


@dataclass(frozen=True, slots=True)
class TraceFile:
    """One file with the traces of all runs, one behind the other."""

    path: Path

    @property
    def observers(self) -> Sequence["ObserverMaker"]:
        """Who records the runs."""
        return _observers()

    def write(self, report: "ScenarioReport") -> Sequence["Diagnostic"]:
        """Write the file. Raises DiagnosticError FB9002 if it cannot be written."""
        from fbgen.cli.files import write_file
        from harness.trace import Trace, trace_text

        traces = [
            trace for result in report.results if (trace := result.observed(Trace)) is not None
        ]
        write_file(self.path, trace_text(traces), overwrite=True)
        return ()


@dataclass(frozen=True, slots=True)
class VcdFiles:
    """A file for one run, or a folder with one for each, called like its scenario."""

    path: Path

    @property
    def observers(self) -> Sequence["ObserverMaker"]:
        """Who records the runs."""
        return _observers()

    def write(self, report: "ScenarioReport") -> Sequence["Diagnostic"]:
        """Write the files. FB8042 for several runs and one file; FB9002 as DiagnosticError."""
        from fbgen.cli.files import write_files
        from fbgen.diagnostics import Diagnostic
        from harness.trace import Trace
        from harness.trace.vcd import vcd_text

        traces = [
            (result, trace)
            for result in report.results
            if (trace := result.observed(Trace)) is not None
        ]
        if self.path.suffix != _SUFFIX:
            names = file_names([f"{_stem(result.file)} {result.changes}" for result, _ in traces])
            paths = [self.path / name for name in names]
        elif len(traces) > 1:
            message = f"{len(traces)} scenarios ran, and {self.path} can hold one of them"
            advice = f"name a folder, such as --vcd {self.path.with_suffix('').as_posix()}"
            return [Diagnostic("FB8042", message, help=advice)]
        else:
            paths = [self.path]
        texts = {
            path: vcd_text(trace).encode() for path, (_, trace) in zip(paths, traces, strict=False)
        }
        write_files(texts, overwrite=True)
        return ()


def _observers() -> Sequence["ObserverMaker"]:
    from harness.scenario.tracing import TraceObserver

    return (TraceObserver,)


def _stem(file: str) -> str:
    return Path(file).name.removesuffix(".yaml").removesuffix(".scenario")


def file_names(titles: Sequence[str]) -> list[str]:
    """A file name for each title, none of them twice, the same for the same titles."""
    names: list[str] = []
    for title in titles:
        stem = re.sub(r"[^A-Za-z0-9._=-]+", "_", title).strip("_")
        name, number = f"{stem}{_SUFFIX}", 1
        while name.casefold() in {taken.casefold() for taken in names}:
            number += 1
            name = f"{stem}-{number}{_SUFFIX}"
        names.append(name)
    return names
