"""`python -m harness.sweep PLANT [--points N] [-j N] [--journal FILE]`: the phase sweep of a plant.

Without `--points` every combination is gone through, and the microseconds between two accesses to
the hardware. The table goes to stdout, the progress to stderr. The status is 1 if a rule broke, 130
after Ctrl-C or SIGTERM: the table is then that of what ran.
"""

import shlex
import signal
import sys
from argparse import ArgumentParser, ArgumentTypeError
from collections.abc import Sequence
from pathlib import Path
from types import FrameType

from fbgen.diagnostics import DiagnosticError
from harness.sweep.conditions import ACCESS_LAYOUTS, Axes, Conditions, between_accesses
from harness.sweep.progress import Progress
from harness.sweep.report import report
from harness.sweep.running import SweepRun

_FINDINGS, _INTERRUPTED = 1, 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run it with these arguments (those of the process if None); the exit status."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    parser = _parser()
    options = parser.parse_args(given)
    run = SweepRun(options.plant, _conditions(options.points), options.processes, options.journal)
    progress = Progress(sys.stderr)
    before = signal.signal(signal.SIGTERM, _as_ctrl_c)
    try:
        result, whole = run.run(progress.show)
    except DiagnosticError as failure:
        print(failure, file=sys.stderr)
        return _FINDINGS
    except OSError as problem:
        print(f"error: {problem.filename}: {problem.strerror}", file=sys.stderr)
        return _FINDINGS
    finally:
        progress.end()
        signal.signal(signal.SIGTERM, before)
    print(report(result), end="")
    if not whole:
        command = shlex.join((*parser.prog.split(), *given))
        print(
            "ended early; without --journal FILE the next one begins anew"
            if run.journal is None
            else f"ended early; go on with: {command}",
            file=sys.stderr,
        )
        return _INTERRUPTED
    return 0 if result.passed else _FINDINGS


def _parser() -> ArgumentParser:
    parser = ArgumentParser(prog="python -m harness.sweep", description=__doc__)
    parser.add_argument("plant", type=Path, help="a plant file with one gateway")
    parser.add_argument(
        "--points",
        type=_count,
        metavar="N",
        help="so many combinations, spread evenly over all",
    )
    parser.add_argument(
        "-j",
        dest="processes",
        type=_count,
        default=1,
        metavar="N",
        help="so many processes; the table is the same",
    )
    parser.add_argument(
        "--journal",
        type=Path,
        metavar="FILE",
        help="note what has run there, and go on from it if it is there already",
    )
    return parser


def _count(text: str) -> int:
    if not text.isascii() or not text.isdigit() or int(text) < 1:
        raise ArgumentTypeError(f"{text!r} is no number from 1 on")
    return int(text)


def _conditions(points: int | None) -> list[Conditions]:
    if points is not None:
        return Axes().spread(points)
    between = [item for access in ACCESS_LAYOUTS for item in between_accesses(access)]
    return [*Axes().every(), *between]


def _as_ctrl_c(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt


if __name__ == "__main__":
    sys.exit(main())
