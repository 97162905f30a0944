"""A program does the same whether or not somebody looks on: at all moments, at all decisions."""

from collections.abc import Sequence

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plc_programs import program_texts
from test_engines_agree import QUICK, SWEEP, Scan, history, scans

from fbgen.lang.checked import Expression
from fbgen.source import Source
from harness.engine.compiled import Moment, Probe, writers_probe
from harness.engine.compiled.expressions.decisions import Results, decision, result
from harness.engine.compiled.watching.probes import Probed
from harness.engine.loading import read_program
from harness.verify.coverage import Coverage
from harness.verify.coverage.counts import BlockCounts


def looking_on(name: str) -> Probe:
    """Has a line wherever one can be, and notes the vectors of all decisions."""
    counts: dict[tuple[int, str], int] = {}
    results: dict[int, Results] = {}
    kept: list[Probed] = []

    def line(node: Probed, moment: Moment) -> str:
        kept.append(node)
        key = (id(node), moment.name)
        return f"_seen = {name}_counts.get({key}, 0)\n{name}_counts[{key}] = _seen + 1"

    def decisions(node: Expression) -> Sequence[str]:
        found = decision(node)
        if found is None:
            return ()
        results[id(node)] = Results(found.tree)
        return (f"{name}_results[{id(node)}]",)

    return Probe(line, {f"{name}_counts": counts, f"{name}_results": results}, decisions)


def compare(dialect: str, data: st.DataObject, steps: list[Scan]) -> None:
    program = read_program([Source("random.scl", data.draw(program_texts(dialect)))], dialect)
    one, two = (lambda _: looking_on("one")), (lambda _: looking_on("two"))
    coverage = Coverage()
    alone = history("compiled", program, steps)
    for probes in ([writers_probe], [one], [one, two], [coverage, two]):
        assert history("compiled", program, steps, probes) == alone
    for block in coverage.blocks():
        agree_with_each_other(block)


def agree_with_each_other(block: BlockCounts) -> None:
    """What is counted in one way and in another is the same, or there was a fault in between."""
    hits: dict[tuple[int, int], int] = {}
    for place, count in block.statements():
        hits[place[:2]] = max(hits.get(place[:2], 0), count)
    assert min(block.statement_hits) >= 0
    for branching, taken in block.branchings():
        reached = hits[branching.place[:2]]
        if branching.kind in ("IF", "CASE"):
            assert sum(taken) <= reached
            assert sum(taken) >= reached - 1, "a fault ends the run"
    for place, vectors in block.decisions():
        for vector in vectors:
            assert vector >> 2 * len(place.conditions) == 0
            assert vectors[vector] is result(place.tree, vector)


@pytest.mark.parametrize("dialect", ["tia", "iec"])
@settings(QUICK, max_examples=15)
@given(data=st.data(), steps=scans())
def test_probes_change_nothing(dialect: str, data: st.DataObject, steps: list[Scan]) -> None:
    compare(dialect, data, steps)


@pytest.mark.slow
@pytest.mark.parametrize("dialect", ["tia", "iec"])
@SWEEP
@given(data=st.data(), steps=scans())
def test_probes_change_nothing_in_many_programs(
    dialect: str, data: st.DataObject, steps: list[Scan]
) -> None:
    compare(dialect, data, steps)
