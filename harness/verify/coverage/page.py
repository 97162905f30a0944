"""The page with the annotated source: one HTML file with everything in it, for any browser.

It holds the coverage as JSON; the script draws what is looked at, so thousands of lines open fast.
"""

import json
from collections.abc import Sequence

from harness.engine.compiled.expressions.decisions import Results
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.derived import catalogue_of
from harness.verify.coverage.items import STATEMENT, items_of, wanted
from harness.verify.coverage.masking import shown_by
from harness.verify.coverage.model import DecisionPlace
from harness.verify.coverage.page_script import SCRIPT
from harness.verify.coverage.page_style import STYLE
from harness.verify.coverage.uniting import ItemKey, UnitedBlock, together, united

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
    blocks = united(coverage)
    data: dict[str, object] = {
        "totals": together(blocks)._asdict(),
        "blocks": _blocks(blocks),
        "texts": [_text(block, text) for block in blocks for text in block.texts],
        "catalogue": None,
    }
    catalogue = catalogue_of(coverage)
    if catalogue.total().total:
        groups = [group._asdict() for group in catalogue.groups()]
        data["catalogue"] = {"total": catalogue.total(), "groups": groups}
    # A "<" inside of a script could end it.
    text = json.dumps(data, separators=(",", ":")).replace("<", "\\u003c")
    return _PAGE.format(style=STYLE, data=text, script=SCRIPT)


def _blocks(blocks: Sequence[UnitedBlock]) -> list[dict[str, object]]:
    """The rows of the table; `texts` are the numbers of a block's texts in `data.texts`."""
    found: list[dict[str, object]] = []
    first = 0
    for block in blocks:
        plants = sorted({plant for text in block.texts for plant in text.plants})
        found.append(
            {
                "name": block.name,
                "dialects": ", ".join(block.dialects),
                "plants": plants,
                **block.totals._asdict(),
                "texts": list(range(first, first + len(block.texts))),
            }
        )
        first += len(block.texts)
    return found


def _text(block: UnitedBlock, text: BlockCounts) -> dict[str, object]:
    reached = [
        ItemKey(STATEMENT, item.key) in block.reached
        for item in items_of(text)
        if item.kind == STATEMENT
    ]
    return {
        "name": text.places.name,
        "kind": text.places.kind,
        "dialect": text.file.dialect,
        "file": text.file.name,
        "plants": sorted(text.plants),
        "first": text.places.place.line,
        "text": text.lines,
        "statements": [
            (place.line, place.end_line, hits, is_reached)
            for (place, hits), is_reached in zip(text.statements(), reached, strict=True)
        ],
        "missing": [(one.place.line, one.kind, one.missing) for one in block.missing_in(text)],
        "decisions": [_decision(place, vectors) for place, vectors in text.decisions()],
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
