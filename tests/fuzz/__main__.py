"""`python -m tests.fuzz [TARGET]... [--seconds N]`: until the time is over or something breaks.

An input that breaks something is written to `fuzz-TARGET-SEED.bin` in the working directory.
"""

import argparse
import sys
from pathlib import Path
from time import monotonic

from tests.fuzz.campaign import Breakage, fuzz
from tests.fuzz.targets import targets


def main() -> int:
    """The exit status: 1 if something broke."""
    known = targets()
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("target", nargs="*", help=f"one of {', '.join(known)}; default all")
    parser.add_argument("--seconds", type=float, default=60, help="for each target")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    for name in options.target or known:
        end = monotonic() + options.seconds
        try:
            count = fuzz(known[name], options.seed, lambda _, end=end: monotonic() < end)
        except Breakage as broken:
            path = Path(f"fuzz-{name}-{broken.seed}.bin")
            path.write_bytes(broken.data)
            print(f"{name}: {broken.reason}\n  input kept in {path}", file=sys.stderr)
            return 1
        print(f"{name}: {count} inputs, nothing broke", flush=True)
    return 0


sys.exit(main())
