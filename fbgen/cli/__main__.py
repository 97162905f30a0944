"""`python -m fbgen.cli`, for where the script `fbgen` is not on the path."""

import sys

from fbgen.cli import run

sys.exit(run())
