"""The page with the annotated source: one HTML file with everything in it, for any browser.

It holds the coverage as JSON; the script draws what is looked at, so thousands of lines open fast.
"""

import json

from harness.engine.compiled.decisions import Results
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.derived import catalogue_of
from harness.verify.coverage.masking import shown_by
from harness.verify.coverage.missing import missing_in, wanted
from harness.verify.coverage.model import DecisionPlace
from harness.verify.coverage.page_script import SCRIPT
from harness.verify.coverage.page_style import STYLE
from harness.verify.coverage.totals import together, totals_of

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Coverage of the PLC text</title>
<style>{style}</style>
</head>
<body>
<header><h1>Coverage of the PLC text</h1>
<button id="theme" type="button">light / dark</button></header>
<main><noscript>This page needs JavaScript.</noscript></main>
<script id="data" type="application/json">{data}</script>
<script>{script}</script>
</body>
</html>
"""


def page(coverage: Coverage) -> str:
    """The whole page."""
    blocks = list(coverage.blocks())
    data: dict[str, object] = {
        "totals": together(blocks)._asdict(),
        "blocks": [_block(block) for block in blocks],
        "catalogue": None,
    }
    catalogue = catalogue_of(coverage)
    if catalogue.total().total:
        groups = [group._asdict() for group in catalogue.groups()]
        data["catalogue"] = {"total": catalogue.total(), "groups": groups}
    # A "<" inside of a script could end it.
    text = json.dumps(data, separators=(",", ":")).replace("<", "\\u003c")
    return _PAGE.format(style=STYLE, data=text, script=SCRIPT)


def _block(block: BlockCounts) -> dict[str, object]:
    return {
        "name": block.places.name,
        "kind": block.places.kind,
        "dialect": block.file.dialect,
        "file": block.file.name,
        "plants": sorted(block.plants),
        **totals_of(block)._asdict(),
        "first": block.places.place.line,
        "text": block.lines,
        "statements": [(place.line, place.end_line, hits) for place, hits in block.statements()],
        "missing": [(one.place.line, one.kind, one.what) for one in missing_in(block)],
        "decisions": [_decision(place, vectors) for place, vectors in block.decisions()],
    }


def _decision(place: DecisionPlace, vectors: Results) -> dict[str, object]:
    count = len(place.conditions)
    seen = sorted(vectors)
    conditions = []
    for number, condition in enumerate(place.conditions):
        pair = shown_by(place.tree, number, count, seen)
        conditions.append(
            {
                "text": condition.text,
                "excluded": condition.excluded,
                "shown": pair
                and (seen.index(pair.true) + 1, seen.index(pair.false) + 1, pair.unique),
                "wanted": wanted(place, number, seen),
            }
        )
    return {
        "line": place.place.line,
        "conditions": conditions,
        "vectors": [(_values(vector, count), _letter(vectors[vector])) for vector in seen],
    }


def _values(vector: int, count: int) -> str:
    return "".join(
        "-" if vector >> (count + number) & 1 else _letter(bool(vector >> number & 1))
        for number in range(count)
    )


def _letter(value: bool) -> str:
    return "T" if value else "F"
