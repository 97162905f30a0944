"""What of the catalogue follows from the statements that ran: status codes, steps of sequences."""

import re
from collections.abc import Iterable, Iterator

from harness.verify.coverage.catalogue import CODES, STEPS, CatalogueCoverage
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.counts import BlockCounts

_CODE = re.compile(r":=\s*(?:WORD#)?16#(8[0-9A-F]{3})\s*;?$", re.IGNORECASE)
"""An assignment of an error code; 8000 alone is a mask."""
_STEP_NUMBER = "stepnumber"
"""What a sequence chooses its step by."""
_SEQUENCE = re.compile(r"_Seq_(\w+)$")


def catalogue_of(coverage: Coverage) -> CatalogueCoverage:
    """What the runs have seen, together with what follows from the statements."""
    whole = CatalogueCoverage()
    whole.merge([coverage.catalogue.items, *_derived(coverage.blocks())])
    return whole


def _derived(blocks: Iterable[BlockCounts]) -> Iterator[dict[str, dict[str, bool]]]:
    for block in blocks:
        if block.plants:
            yield {CODES: dict(_codes(block)), STEPS: dict(_steps(block))}


def _codes(block: BlockCounts) -> Iterator[tuple[str, bool]]:
    lines = block.file.text.split("\n")
    seen: dict[str, bool] = {}
    for place, hits in block.statements():
        found = _CODE.search(lines[place.end_line - 1][: place.end_column - 1])
        if found is not None and found[1] != "8000":
            name = f"{block.places.name} 16#{found[1].upper()}"
            seen[name] = seen.get(name, False) or hits > 0
    yield from sorted(seen.items())


def _steps(block: BlockCounts) -> Iterator[tuple[str, bool]]:
    """The arms of the last CASE over the step number: there the steps are begun."""
    sequence = _SEQUENCE.search(block.places.name)
    if sequence is None:
        return
    lines = block.file.text.split("\n")
    found = [
        (branching, taken)
        for branching, taken in block.branchings()
        if branching.kind == "CASE" and _STEP_NUMBER in lines[branching.place.line - 1].lower()
    ]
    for branching, taken in found[-1:]:
        for outcome, hits in zip(branching.outcomes, taken, strict=True):
            if outcome.name.startswith("CASE "):
                yield f"{sequence[1]} step {outcome.name.removeprefix('CASE ')}", hits > 0
