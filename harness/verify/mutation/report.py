"""What a mutation run has found, as text and as plain data."""

from collections.abc import Iterator, Sequence

from fbgen.diagnostics import Diagnostic
from harness.verify.mutation.score import Score, scores_of
from harness.verify.mutation.session import MutationRun, Tried
from harness.verify.mutation.texts import difference
from harness.verify.mutation.verdict import Fate

_HEAD = ("block", "mutants", "killed", "alive", "equivalent", "score", "changed")
ALIVE = (Fate.SURVIVED, Fate.UNCHANGED, Fate.UNREACHED)


def survivors(tried: Sequence[Tried]) -> list[Tried]:
    """What no check has noticed and nobody has explained."""
    return [one for one in tried if one.verdict.fate in ALIVE]


def table(run: MutationRun) -> str:
    """A line for each block, and one for all."""
    blocks, every = scores_of(run.tried)
    rows = [_HEAD, *(_row(score) for score in (*blocks, every))]
    widths = [max(len(row[column]) for row in rows) for column in range(len(_HEAD))]
    return "\n".join(
        "  ".join(
            text.ljust(width) if column == 0 else text.rjust(width)
            for column, (text, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    )


def _row(score: Score) -> tuple[str, ...]:
    alive = sum(score.fates[fate] for fate in ALIVE)
    equivalent = score.total - score.counted
    counts = (score.total, score.fates[Fate.KILLED], alive, equivalent)
    return (
        score.name,
        *map(str, counts),
        f"{score.noticed:.1f} %",
        f"{score.changed:.1f} %",
    )


def described(one: Tried) -> Iterator[str]:
    """A mutant with its place, what came of it, and the change as a patch."""
    place, verdict = one.mutant.place, one.verdict
    yield f"{place.source.name}:{place.line}: {one.id}: {one.mutant.operator.description}"
    yield f"  {verdict.fate.meaning} [{one.fingerprint}]"
    if (origin := place.origin) and not origin.is_template:
        yield f"  from {origin.what}, {origin.file}:{origin.line}"
    if verdict.fate is Fate.SURVIVED:
        seen = verdict.effect or "nothing that can be seen from outside"
        yield f"  {verdict.runs} scenarios ran; changed: {seen}"
    if verdict.fate is Fate.KILLED:
        yield f"  by {verdict.scenario} at {verdict.at_ns / 1e6:g} ms: {verdict.message}"
    if verdict.why:
        yield f"  {verdict.why}"
    yield from (f"    {line}" for line in difference(one.mutant).splitlines()[2:])


def as_json(run: MutationRun) -> dict[str, object]:
    """Everything as plain data, the same for the same run."""
    blocks, every = scores_of(run.tried)
    return {
        "format": "fbgen mutation 1",
        "planned": run.planned,
        "interrupted": run.interrupted,
        "score": _score_json(every),
        "blocks": [_score_json(score) for score in blocks],
        "mutants": [_mutant_json(one) for one in run.tried],
    }


def _score_json(score: Score) -> dict[str, object]:
    fates = {fate.value: score.fates[fate] for fate in Fate}
    percent = {"noticed": round(score.noticed, 2), "changed": round(score.changed, 2)}
    return {"name": score.name, "mutants": score.total, **fates, **percent}


def _mutant_json(one: Tried) -> dict[str, object]:
    place = one.mutant.place
    origin = place.origin
    return {
        **one.verdict.as_json(),
        "block": one.target.name,
        "fingerprint": one.fingerprint,
        "operator": one.mutant.operator.value,
        "file": place.source.name,
        "line": place.line,
        "origin": origin.what if origin is not None and not origin.is_template else "",
        "diff": difference(one.mutant),
    }


def too_low(run: MutationRun, least: float) -> list[Diagnostic]:
    """FB8064 if the score is below what is asked for."""
    _, every = scores_of(run.tried)
    if every.noticed >= least:
        return []
    message = f"the checks notice {every.noticed:.1f} % of the mutants, less than {least:g} %"
    advice = "each survivor above shows a line that no scenario checks"
    return [Diagnostic("FB8064", message, help=advice)]
