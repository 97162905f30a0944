"""Statement, branch and MC/DC coverage of PLC text.

    coverage = Coverage()
    program = load_program(["conveyor.scl"], probes=[coverage])
    ...                                           # run it
    print(together(united(coverage)).statement.percent)
    write(coverage, "coverage.html")

`docs/reference/coverage.md` says what is counted and how.
"""

from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.derived import catalogue_of
from harness.verify.coverage.limits import parse_limits, too_little
from harness.verify.coverage.reports import Target, contents, parse_target, write
from harness.verify.coverage.storing import as_text, from_text, load, summary
from harness.verify.coverage.table import CATALOGUE_HEADINGS, HEADINGS, catalogue_rows, rows
from harness.verify.coverage.totals import Count, Totals
from harness.verify.coverage.uniting import together, totals_of, united
from harness.verify.coverage.watching import watch

__all__ = [
    "CATALOGUE_HEADINGS",
    "HEADINGS",
    "catalogue_of",
    "catalogue_rows",
    "watch",
    "Target",
    "rows",
    "summary",
    "Count",
    "Coverage",
    "as_text",
    "from_text",
    "Totals",
    "contents",
    "load",
    "parse_limits",
    "parse_target",
    "together",
    "too_little",
    "totals_of",
    "united",
    "write",
]
