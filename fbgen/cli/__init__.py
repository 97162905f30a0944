"""The command line `fbgen`: one module per command.

How a process ends: status 0 when done, 1 for findings (every error a user can mend is a diagnostic
on standard error), 2 for wrong usage, 70 for a defect of fbgen itself, 130 after Ctrl-C, 141 when
the reader of standard output goes away early (`fbgen ... | head`), which is no error and quiet.
The result of a command goes to standard output, everything else to standard error.

Only this package imports the harness, and only inside the commands that need it. Nothing here is
imported before `main` runs, so that `fbgen --help` is fast and Ctrl-C never shows a traceback.
"""

import atexit
import errno
import gc
import io
import os
import sys
from collections.abc import Callable, Sequence

FINDINGS, DEFECT, INTERRUPTED, READER_GONE = 1, 70, 130, 141

_NEW_OBJECTS = 300_000
"""How many objects come into being before Python looks for garbage among them. Modules, models and
trees stay as long as the process; Python's usual 700 costs a tenth of a short command, and to look
once through what `fbgen test` has read by then a seventh."""

_ROOM = 40_000
"""Words: 320 KB, for which Python takes 512 KB. What is left is for other calls."""


def run() -> int:
    """Run the command of this process, which then ends; the exit status."""
    # What a command has made goes with its process. Python would look for garbage in all of it
    # first, which takes a quarter of a short command.
    atexit.register(gc.freeze)
    return _with_room(main)


def _with_room(action: Callable[[], int]) -> int:
    """Call it with memory for all that is called from there.

    Python takes memory for calls in pieces of 16 KB, and gives a piece back as soon as nothing is
    in it. A loop that calls a function where a piece ends does so a thousand times. A frame that
    seems to be large makes the piece large that all further ones are in.
    """

    def call() -> int:
        return action()

    call.__code__ = call.__code__.replace(co_stacksize=_ROOM)
    return call()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command with these arguments (those of the process if None); the exit status."""
    gc.set_threshold(_NEW_OBJECTS)
    # fbgen's own models need no plugins, and to look for some means to read what is installed.
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    try:
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, io.TextIOWrapper):
                stream.reconfigure(errors="backslashreplace")
        status = _run(arguments)
        sys.stdout.flush()
    except KeyboardInterrupt:
        return INTERRUPTED
    except OSError as problem:
        if problem.errno != errno.EPIPE:
            raise
        # What is still in the buffer must not fail once more when the interpreter ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return READER_GONE
    return status


def _run(arguments: Sequence[str] | None) -> int:
    from fbgen.cli.output import report, report_defect, report_inaccessible
    from fbgen.cli.program import program_for
    from fbgen.diagnostics import DiagnosticError

    try:
        given = sys.argv[1:] if arguments is None else arguments
        program_for(given)(args=given, prog_name="fbgen")
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0
    except DiagnosticError as failure:
        report(failure.diagnostics)
        return FINDINGS
    except OSError as problem:
        report_inaccessible(problem)
        return FINDINGS
    except Exception as defect:
        report_defect(defect)
        return DEFECT
    return 0
