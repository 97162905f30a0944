"""`fbgen run`: calls one block cycle by cycle and prints what it does."""

import csv
import io
from collections.abc import Iterable, Iterator
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.dialects import DialectOption
from fbgen.cli.examples import examples
from fbgen.cli.output import report, result, result_json, say
from fbgen.cli.sources.plc_files import dialect_of, expand
from fbgen.cli.sources.project_data import (
    ConstantsOption,
    NumbersOption,
    TagsOption,
    read_constants,
    read_numbers,
)
from fbgen.cli.table import table

if TYPE_CHECKING:
    from fbgen.diagnostics import DiagnosticError
    from harness.trial import Row, Trial

_NS_PER_MS = 1_000_000


class Format(Enum):
    """How the rows are printed."""

    TABLE = "table"
    CSV = "csv"
    JSON = "json"


class EngineName(Enum):
    """Which engine runs the text."""

    COMPILED = "compiled"
    REFERENCE = "reference"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        "run",
        epilog=examples(
            "fbgen run pump.scl --set start=1 --watch running --watch speed",
            "fbgen run out/TOS_TriggerCounter.scl --cycles 5 --set advance=1",
            "fbgen run ramp.st --block Ramp --every 100ms --set target=50.0@3 --changes",
            "fbgen run scaling.scl --block HzToWord --set hz=50.0 --cycles 1",
            "fbgen run pump.scl --cycles 1000 --format csv > pump.csv",
            'fbgen run blocks --block Main --constant MAX_PUMPS=8 --tags "PLC tags.xml"',
        ),
    )(run)


def run(
    files: Annotated[
        list[Path],
        typer.Argument(
            metavar="FILES",
            help="Files, patterns or folders with the block, and whatever it calls or declares.",
        ),
    ],
    block: Annotated[
        str,
        typer.Option(
            "--block", metavar="B", help="The block to call; needed if there are several."
        ),
    ] = "",
    cycles: Annotated[
        int, typer.Option("--cycles", metavar="N", min=1, help="How often it is called.")
    ] = 10,
    every: Annotated[
        str, typer.Option("--every", metavar="TIME", help="The cycle time, on the virtual clock.")
    ] = "10ms",
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE[@WHEN]",
            help="Sets a variable before the first cycle, before cycle 3 (@3) or once 200 ms are "
            "over (@200ms); it keeps the value. Values as in PLC text: 16#FF, T#2s, 'text', TRUE.",
        ),
    ] = None,
    watch: Annotated[
        list[str] | None,
        typer.Option("--watch", metavar="NAME", help="Shows a variable; else all outputs."),
    ] = None,
    changes: Annotated[
        bool, typer.Option("--changes", help="Only cycles in which something changed.")
    ] = False,
    output: Annotated[Format, typer.Option("--format", help="How rows are printed.")] = (
        Format.TABLE
    ),
    dialect: DialectOption = None,
    engine: Annotated[
        EngineName, typer.Option("--engine", help="reference is slow and defines what is right.")
    ] = EngineName.COMPILED,
    constants: ConstantsOption = None,
    tags: TagsOption = None,
    numbers: NumbersOption = None,
) -> None:
    """Call a block cycle by cycle and print what it does.

    Works for function blocks, functions, PROGRAMs and organization blocks. The first line shows
    what the first call left behind. Exit status 1 if the text has errors, or a fault stops it; the
    rows up to the fault are printed.
    """
    from fbgen.diagnostics import DiagnosticError
    from harness.engine.loading import load_program
    from harness.trial import Trial, read_duration, read_setting

    paths = expand(files)
    every_ns = read_duration(every)
    wanted = [read_setting(text) for text in settings or ()]
    program = load_program(
        paths,
        dialect or dialect_of(paths),
        engine.value,
        db_numbers=read_numbers(numbers),
        constants=read_constants(constants),
        tags=tags or (),
    )
    trial = Trial(program, block, wanted, watch or ())
    ends: list[DiagnosticError | KeyboardInterrupt] = []
    rows = _until_stopped(trial.rows(cycles, every_ns), ends)
    _WRITERS[output](trial, _changed(rows) if changes else rows)
    for end in ends:
        if isinstance(end, KeyboardInterrupt):
            raise end
        report(end.diagnostics)
        say("the rows above end in front of the fault")
        raise typer.Exit(FINDINGS)


def _until_stopped(
    rows: Iterator["Row"], ends: list["DiagnosticError | KeyboardInterrupt"]
) -> Iterator["Row"]:
    """The rows up to a fault of the program, or to Ctrl-C: what has been done is not lost."""
    from fbgen.diagnostics import DiagnosticError

    try:
        yield from rows
    except (DiagnosticError, KeyboardInterrupt) as end:
        ends.append(end)


def _changed(rows: Iterable["Row"]) -> Iterator["Row"]:
    last = None
    for row in rows:
        if row.values != last:
            yield row
        last = row.values


def _ms(now_ns: int) -> str:
    """Every digit: the column has to tell any two cycles apart."""
    whole, rest = divmod(now_ns, _NS_PER_MS)
    return f"{whole}.{rest:06}".rstrip("0").rstrip(".")


def _table(trial: "Trial", rows: Iterable["Row"]) -> None:
    headings = ("cycle", "ms", *trial.watched)
    lines = [(str(row.cycle), _ms(row.now_ns), *trial.texts(row)) for row in list(rows)]
    result(table(headings, lines))


def _csv(trial: "Trial", rows: Iterable["Row"]) -> None:
    result(_csv_line(("cycle", "ms", *trial.watched)))
    for row in rows:
        result(_csv_line((str(row.cycle), _ms(row.now_ns), *trial.texts(row))))


def _csv_line(cells: Iterable[str]) -> str:
    line = io.StringIO()
    csv.writer(line, lineterminator="").writerow(cells)
    return line.getvalue()


def _json(trial: "Trial", rows: Iterable["Row"]) -> None:
    result_json(
        {
            "watched": list(trial.watched),
            "rows": [
                {"cycle": row.cycle, "ns": row.now_ns, "values": list(row.values)} for row in rows
            ],
        }
    )


_WRITERS = {Format.TABLE: _table, Format.CSV: _csv, Format.JSON: _json}
