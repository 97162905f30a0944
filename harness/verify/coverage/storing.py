"""Coverage as JSON: the format of `coverage.json`, which is kept, merged and read by other tools.

`docs/reference/coverage.md` describes it. Everything that was counted is in it, with the text, so
that reports can be made of it later and elsewhere.
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from fbgen.diagnostics import DiagnosticError, error
from harness.engine.compiled.expressions.decisions import Condition, Fixed, Join, Not, Tree
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.counts import FileCounts
from harness.verify.coverage.derived import catalogue_of
from harness.verify.coverage.model import (
    BlockPlaces,
    Branching,
    ConditionPlace,
    DecisionPlace,
    FileKey,
    Outcome,
    Place,
    TemplateKeys,
)
from harness.verify.coverage.totals import Count, Totals
from harness.verify.coverage.uniting import together, totals_of, united

FORMAT = "fbgen-coverage"
VERSION = 2


def as_json(coverage: Coverage) -> dict[str, object]:
    """All of it as plain data."""
    return {
        "format": FORMAT,
        "version": VERSION,
        **summary(coverage),
        "catalogue": coverage.catalogue.items,
        "files": [_file(coverage.files[key]) for key in sorted(coverage.files)],
    }


def summary(coverage: Coverage) -> dict[str, object]:
    """How much was reached, in all and of each block, as plain data."""
    blocks = united(coverage)
    return {
        "totals": _totals(together(blocks)),
        "blocks": [
            {
                "name": block.name,
                **_totals(block.totals),
                "texts": [
                    {
                        "dialect": text.file.dialect,
                        "file": text.file.name,
                        "line": text.places.place.line,
                        "plants": sorted(text.plants),
                        **_totals(totals_of(text)),
                    }
                    for text in block.texts
                ],
            }
            for block in blocks
        ],
        "exercised": {
            group.name: {**_count(group.exercised), "missing": group.missing}
            for group in catalogue_of(coverage).groups()
        },
    }


def _totals(totals: Totals) -> dict[str, object]:
    return {kind: _count(count) for kind, count in totals._asdict().items()}


def _count(count: Count) -> dict[str, object]:
    return {
        "reached": count.reached,
        "total": count.total,
        "percent": round(count.percent, 2),
    }


def _file(counts: FileCounts) -> dict[str, object]:
    return {
        "name": counts.key.name,
        "dialect": counts.key.dialect,
        "plants": sorted(counts.plants),
        "text": counts.key.text,
        "blocks": [
            {
                "name": block.places.name,
                "kind": block.places.kind,
                "place": block.places.place,
                "made_from": block.places.made_from._asdict(),
                "statements": [[*place, hits] for place, hits in block.statements()],
                "branchings": [
                    {
                        "kind": branching.kind,
                        "place": branching.place,
                        "outcomes": [
                            {
                                "name": outcome.name,
                                "place": outcome.place,
                                "excluded": outcome.excluded,
                                "hits": hits,
                            }
                            for outcome, hits in zip(branching.outcomes, taken, strict=True)
                        ],
                    }
                    for branching, taken in block.branchings()
                ],
                "decisions": [
                    {
                        "text": decision.text,
                        "place": decision.place,
                        "tree": _plain(decision.tree),
                        "conditions": [one._asdict() for one in decision.conditions],
                        "vectors": sorted(vectors),
                    }
                    for decision, vectors in block.decisions()
                ],
            }
            for block in counts.of_blocks()
        ],
    }


def _plain(tree: Tree) -> object:
    """Conditions by number, constants as they are, operators first in a list."""
    match tree:
        case Condition(number):
            return number
        case Fixed(value):
            return value
        case Not(operand):
            return ["NOT", _plain(operand)]
        case Join(operator, left, right):
            return [operator, _plain(left), _plain(right)]


def as_text(coverage: Coverage) -> str:
    """All of it as the text of a file."""
    return json.dumps(as_json(coverage), separators=(",", ":")) + "\n"


def from_text(text: str) -> Coverage:
    """What `as_text` gave. Raises ValueError and the like for anything else."""
    data = json.loads(text)
    if data["format"] != FORMAT or data["version"] != VERSION:
        raise ValueError("it is of another format or version")
    coverage = Coverage()
    for file in data["files"]:
        counts = _counts(file)
        coverage.files[counts.key] = counts
    coverage.catalogue.merge([data["catalogue"]])
    return coverage


def load(path: Path) -> Coverage:
    """Read a file. Raises DiagnosticError FB8050 if it holds no coverage."""
    try:
        return from_text(path.read_text(encoding="utf-8"))
    except OSError as wrong:
        raise _no_coverage(path, wrong.strerror or "it cannot be read") from None
    except (ValueError, KeyError, TypeError, IndexError, AttributeError) as wrong:
        raise _no_coverage(path, f"{type(wrong).__name__}: {wrong}") from None


def _no_coverage(path: Path, reason: str) -> DiagnosticError:
    return error(
        "FB8050",
        f"no coverage can be read from {path.as_posix()}: {reason}",
        None,
        "give a file that `fbgen test --coverage FILE.json` has written",
    )


def _counts(file: Mapping[str, Any]) -> FileCounts:
    blocks = tuple(_block(block) for block in file["blocks"])
    counts = FileCounts(FileKey(file["name"], file["dialect"], file["text"]), blocks)
    counts.plants.update(file["plants"])
    hits: list[int] = []
    decided = 0
    for block in file["blocks"]:
        hits += [int(statement[4]) for statement in block["statements"]]
        hits += [int(one["hits"]) for each in block["branchings"] for one in each["outcomes"]]
        for decision in block["decisions"]:
            for vector in decision["vectors"]:
                _ = counts.vectors[decided][int(vector)]
            decided += 1
    counts.hits[:] = hits
    return counts


def _block(block: Mapping[str, Any]) -> BlockPlaces:
    return BlockPlaces(
        str(block["name"]),
        str(block["kind"]),
        _place(block["place"]),
        tuple(_place(one[:4]) for one in block["statements"]),
        tuple(
            Branching(
                str(one["kind"]),
                _place(one["place"]),
                tuple(
                    Outcome(str(way["name"]), _place(way["place"]), str(way["excluded"]))
                    for way in one["outcomes"]
                ),
            )
            for one in block["branchings"]
        ),
        tuple(
            DecisionPlace(
                str(one["text"]),
                _place(one["place"]),
                _tree(one["tree"]),
                tuple(
                    ConditionPlace(str(part["text"]), _place(part["place"]), str(part["excluded"]))
                    for part in one["conditions"]
                ),
            )
            for one in block["decisions"]
        ),
        _made_from(block["made_from"]),
    )


def _made_from(data: Mapping[str, Any]) -> TemplateKeys:
    lists = (tuple(map(str, data[name])) for name in TemplateKeys._fields[1:])
    return TemplateKeys(str(data["template"]), *lists)


def _place(numbers: Sequence[int]) -> Place:
    line, column, end_line, end_column = map(int, numbers)
    return Place(line, column, end_line, end_column)


def _tree(data: object) -> Tree:
    match data:
        case bool():
            return Fixed(data)
        case int():
            return Condition(data)
        case ["NOT", operand]:
            return Not(_tree(operand))
        case [str(operator), left, right]:
            return Join(operator, _tree(left), _tree(right))
        case _:
            raise ValueError(f"{data!r} is no decision")
