"""`python -m harness.sweep PLANT [--points N]`: the phase sweep of a plant with one gateway.

Without `--points` every combination is gone through, and the microseconds between two accesses to
the hardware. The table goes to stdout, the progress to stderr; the status is 1 if a rule broke.
"""

import sys
from argparse import ArgumentParser
from pathlib import Path

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import load_plant
from harness.sweep.conditions import ACCESS_LAYOUTS, Axes, between_accesses
from harness.sweep.report import report
from harness.sweep.sweeping import Sweep

_SHOWN_EVERY = 50


def main() -> int:
    """Run it; the exit status."""
    parser = ArgumentParser(prog="python -m harness.sweep", description=__doc__)
    parser.add_argument("plant", type=Path, help="a plant file with one gateway")
    parser.add_argument("--points", type=int, help="so many combinations, spread evenly over all")
    arguments = parser.parse_args()
    conditions = list(Axes().every()) if arguments.points is None else None
    if conditions is None:
        conditions = Axes().spread(arguments.points)
    else:
        conditions += [item for access in ACCESS_LAYOUTS for item in between_accesses(access)]
    total = len(conditions)

    def progress(runs: int) -> None:
        if runs % _SHOWN_EVERY == 0 or runs == total:
            print(f"\r{runs} of {total}", end="" if runs < total else "\n", file=sys.stderr)

    catalog = load_catalog()
    try:
        sweep = Sweep(load_plant(arguments.plant, catalog), catalog)
        result = sweep.through(conditions, progress)
    except DiagnosticError as failure:
        print(failure, file=sys.stderr)
        return 1
    print(report(result), end="")
    return 0 if result.passed else 1


if __name__ == "__main__":
    sys.exit(main())
