"""A mutation run as one page that opens offline."""

from html import escape

from harness.verify.mutation.mutant import Operator
from harness.verify.mutation.report import ALIVE, survivors
from harness.verify.mutation.score import Score, scores_of
from harness.verify.mutation.session import MutationRun, Tried
from harness.verify.mutation.texts import difference
from harness.verify.mutation.verdict import Fate

_STYLE = """
:root { color-scheme: light dark; font: 15px/1.45 system-ui, sans-serif; }
body { margin: 2rem auto; max-width: 70rem; padding: 0 1rem; }
table { border-collapse: collapse; } th, td { padding: .2rem .8rem; text-align: right; }
th:first-child, td:first-child { text-align: left; } tr:nth-child(even) { background: #8881; }
pre { overflow-x: auto; padding: .6rem; background: #8881; font: 13px/1.4 ui-monospace, monospace; }
.out { color: #b3261e; } .in { color: #1b7f3b; } .place { opacity: .75; }
@media (prefers-color-scheme: dark) { .out { color: #ff8a80; } .in { color: #7ee2a0; } }
details { margin: .5rem 0; } summary { cursor: pointer; }
"""


def page(run: MutationRun) -> str:
    """The page: figures of each block, then what no check noticed, with the changes."""
    blocks, every = scores_of(run.tried)
    rows = "".join(_row(score) for score in (*blocks, every))
    note = "<p>Stopped by Ctrl-C: not all mutants were tried.</p>" if run.interrupted else ""
    alive = survivors(run.tried)
    equivalent = [one for one in run.tried if one.verdict.fate.is_equivalent]
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f"<title>Mutants</title><style>{_STYLE}</style></head><body><h1>Mutants</h1>{note}"
        f"<p>The checks notice {every.noticed:.1f} % of {every.counted} mutants; the scenarios "
        f"change something in the plant with {every.changed:.1f} %.</p>"
        "<table><thead><tr><th>block</th><th>mutants</th><th>killed</th><th>alive</th>"
        f"<th>equivalent</th><th>noticed</th><th>changed</th></tr></thead><tbody>{rows}</tbody>"
        f"</table>{_section('Not noticed', alive)}{_section('Equivalent', equivalent)}"
        f"<h2>Kinds of changes</h2><dl>{_kinds()}</dl></body></html>\n"
    )


def _row(score: Score) -> str:
    alive = sum(score.fates[fate] for fate in ALIVE)
    cells = (
        *(score.total, score.fates[Fate.KILLED], alive, score.total - score.counted),
        *(f"{score.noticed:.1f} %", f"{score.changed:.1f} %"),
    )
    return f"<tr><td>{escape(score.name)}</td>" + "".join(f"<td>{one}</td>" for one in cells)


def _section(title: str, tried: list[Tried]) -> str:
    if not tried:
        return ""
    return f"<h2>{title}: {len(tried)}</h2>" + "".join(map(_mutant, tried))


def _mutant(one: Tried) -> str:
    place, verdict = one.mutant.place, one.verdict
    told = [verdict.fate.meaning]
    if verdict.fate is Fate.SURVIVED:
        told.append(f"changed: {verdict.effect or 'nothing that can be seen from outside'}")
    if verdict.why:
        told.append(verdict.why)
    return (
        f"<details open><summary>{escape(one.id)} <span class=place>{escape(place.source.name)}:"
        f"{place.line}, {one.mutant.operator.description}</span></summary>"
        f"<p>{escape('; '.join(told))}</p><pre>{_patch(difference(one.mutant))}</pre></details>"
    )


def _patch(text: str) -> str:
    kinds = {"-": "out", "+": "in"}
    return "\n".join(
        f'<span class="{kinds[line[0]]}">{escape(line)}</span>'
        if line[:1] in kinds
        else escape(line)
        for line in text.splitlines()[2:]
    )


def _kinds() -> str:
    return "".join(f"<dt>{one.value}</dt><dd>{one.description}</dd>" for one in Operator)
