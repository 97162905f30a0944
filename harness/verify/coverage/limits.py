"""How much coverage somebody demands: `statement=90,branch=80,mcdc=70,catalogue=60`."""

from collections.abc import Iterator, Mapping

from fbgen.diagnostics import Diagnostic, error
from fbgen.nearest import nearest
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.derived import catalogue_of
from harness.verify.coverage.items import KINDS
from harness.verify.coverage.totals import Count
from harness.verify.coverage.uniting import together, united

CATALOGUE = "catalogue"
DEMANDED = (*KINDS, CATALOGUE)


def parse_limits(text: str) -> Mapping[str, float]:
    """The least percentage of each kind. Raises DiagnosticError FB8051.

    A number alone stands for statements.
    """
    limits: dict[str, float] = {}
    for part in text.split(","):
        kind, sign, number = (piece.strip() for piece in part.rpartition("="))
        kind = kind if sign else KINDS[0]
        if kind not in DEMANDED:
            raise error("FB8051", f"'{kind}' is no kind of coverage", help=nearest(kind, DEMANDED))
        try:
            least = float(number)
        except ValueError:
            least = -1.0
        if not 0 <= least <= 100:
            raise error(
                "FB8051",
                f"'{number}' is no percentage",
                help="write a number from 0 to 100, such as statement=90,branch=80",
            )
        limits[kind] = least
    return limits


def too_little(coverage: Coverage, limits: Mapping[str, float]) -> Iterator[Diagnostic]:
    """FB8052 for each kind of which there is less than demanded."""
    counts: dict[str, Count] = together(united(coverage))._asdict()
    if CATALOGUE in limits:
        counts[CATALOGUE] = catalogue_of(coverage).total()
    for kind, least in limits.items():
        count = counts[kind]
        if not count.total and least and (kind == CATALOGUE or not counts[KINDS[0]].total):
            yield Diagnostic(
                "FB8052",
                f"there is no {kind} coverage: nothing was counted",
                help="scenarios with engine: compiled are counted",
            )
        elif count.percent < least:
            reached = f"{count.percent:.1f} % ({count.reached} of {count.total})"
            yield Diagnostic(
                "FB8052",
                f"the {kind} coverage is {reached}, at least {least:g} % are demanded",
                help="--coverage html=FILE shows what no test has reached",
            )
