"""What commands print: results on standard output, findings and everything else on standard error.

Colours appear on a terminal only, and never if NO_COLOR is set.
"""

import json
import os
import sys
import traceback
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

import typer

from fbgen import __version__
from fbgen.cli import READER_GONE
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity, render

_COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.INFO: "blue"}


def counted(number: int, what: str) -> str:
    """So many of something: `1 line`, `2 lines`."""
    return f"{number} {what}{'' if number == 1 else 's'}"


def result(text: str) -> None:
    """The result of a command, for a person or for another program."""
    _echo(text, err=False)


def result_bytes(data: bytes) -> None:
    """The content of a file, in the encoding that it has."""
    _echo(data, err=False)


def result_json(data: object) -> None:
    """The result of a command as JSON, in ASCII."""
    result(json.dumps(data, indent=2))


def say(text: str) -> None:
    """What a person may want to know beside the result."""
    _echo(text, err=True)


def report(diagnostics: Iterable[Diagnostic]) -> None:
    """Findings with their places and help, separated by empty lines."""
    for index, diagnostic in enumerate(diagnostics):
        head, line_end, rest = render(diagnostic).partition("\n")
        label, colon, message = head.partition(":")
        colour = _COLOURS[diagnostic.severity]
        head = typer.style(label, fg=colour, bold=True) + typer.style(colon + message, bold=True)
        say(("\n" if index else "") + head + line_end + rest)


def report_inaccessible(problem: OSError) -> None:
    """FB9002: a file or folder that the operating system refuses."""
    reason = problem.strerror or type(problem).__name__
    place = f"{problem.filename} cannot be used: " if problem.filename else ""
    report([Diagnostic("FB9002", f"{place}{reason}", help="check the path and its permissions")])


def report_defect(defect: Exception) -> None:
    """An error of fbgen itself. FBGEN_TRACEBACK=1 shows where it happened."""
    import platform

    if os.environ.get("FBGEN_TRACEBACK") == "1":
        say("".join(traceback.format_exception(defect)).rstrip())
    what = str(defect).partition("\n")[0]
    name = type(defect).__name__
    say(
        f"{typer.style('defect', fg='red', bold=True)}: {name}{': ' if what else ''}{what}\n"
        "This is a defect in fbgen, not in your input. Please report it with your files, the\n"
        "command and what it prints with FBGEN_TRACEBACK=1 set in the environment.\n"
        f"fbgen {__version__}, Python {platform.python_version()}, {platform.platform()}"
    )


def _echo(text: str | bytes, *, err: bool) -> None:
    colour = False if os.environ.get("NO_COLOR") else None
    try:
        typer.echo(text, err=err, color=colour, nl=isinstance(text, str))
    except BrokenPipeError:
        if not _UNREAD:
            raise typer.Exit(READER_GONE) from None
        _UNREAD[-1].gone = True
        # Whatever else is printed there goes nowhere, what is still in the buffer too.
        stream = sys.stderr if err else sys.stdout
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


@dataclass(slots=True)
class Unread:
    """Whether the reader of what was printed has gone away."""

    gone: bool = False


_UNREAD: list[Unread] = []
"""The commands that go on without their reader: one, or none."""


@contextmanager
def going_on_unread() -> Iterator[Unread]:
    """Inside, nothing ends because nobody reads what is printed: there is more to do than that."""
    _UNREAD.append(Unread())
    try:
        yield _UNREAD[-1]
    finally:
        _UNREAD.pop()


def on_error_terminal() -> bool:
    """Whether a person looks at standard error."""
    return sys.stderr.isatty()


def on_terminal() -> bool:
    """Whether a person looks at standard output."""
    return sys.stdout.isatty()
