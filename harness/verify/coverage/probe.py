"""The probe that counts: what generated code does at statements, branches and decisions."""

from collections.abc import Sequence

from fbgen.lang.checked import Expression, For, Repeat, While
from harness.engine.compiled import Moment, Probe
from harness.engine.compiled.watching.probes import Probed
from harness.verify.coverage.counts import FileCounts
from harness.verify.coverage.places import BlockNodes


class _Lines:
    """What runs at which moment of which node, and which mappings decisions are taken from.

    Nodes are known by their identity: `kept` keeps them from being replaced by others.
    """

    __slots__ = ("at", "decided", "kept", "names")

    def __init__(self) -> None:
        self.at: dict[tuple[int, Moment], str] = {}
        self.decided: dict[int, str] = {}
        self.names: dict[str, object] = {}
        self.kept: list[object] = []

    def put(self, node: Probed, moment: Moment, line: str) -> None:
        before = self.at.get((id(node), moment))
        self.at[id(node), moment] = line if before is None else f"{before}\n{line}"

    def line(self, node: Probed, moment: Moment) -> str:
        return self.at.get((id(node), moment), "")

    def decisions(self, node: Expression) -> Sequence[str]:
        name = self.decided.get(id(node))
        return () if name is None else (name,)


def counting(files: Sequence[tuple[FileCounts, Sequence[BlockNodes]]], prefix: str) -> Probe:
    """Counts into `files`; names in the generated code begin with `prefix`."""
    lines = _Lines()
    for number, (counts, blocks) in enumerate(files):
        hits = f"{prefix}_{number}"
        lines.names[hits] = counts.hits
        at = decided = 0
        for block in blocks:
            for statement in block.statements:
                lines.put(statement[0], Moment.BEFORE, f"{hits}[{at}] += 1")
                at += 1
            for owners in block.outcomes:
                at = _outcomes(lines, hits, at, owners)
            for node in block.decisions:
                name = f"{hits}_decision_{decided}"
                lines.names[name] = counts.vectors[decided]
                lines.decided[id(node)] = name
                decided += 1
        lines.kept.append(blocks)
    return Probe(lines.line, lines.names, lines.decisions)


def _outcomes(lines: _Lines, hits: str, at: int, owners: Sequence[Probed]) -> int:
    first = owners[0]
    if isinstance(first, Repeat):
        # Each pass but the first one is a repetition.
        lines.put(first, Moment.BEFORE, f"{hits}[{at}] -= 1")
        lines.put(first, Moment.INSIDE, f"{hits}[{at}] += 1")
        lines.put(first, Moment.ENDED, f"{hits}[{at + 1}] += 1")
    elif isinstance(first, For | While):
        passes = f"{hits}_passes_{at}"
        lines.put(first, Moment.BEFORE, f"{passes} = {hits}[{at}]")
        lines.put(first, Moment.INSIDE, f"{hits}[{at}] += 1")
        lines.put(first, Moment.AFTER, f"if {hits}[{at}] == {passes}: {hits}[{at + 1}] += 1")
    else:
        for number, owner in enumerate(owners):
            lines.put(owner, Moment.INSIDE, f"{hits}[{at + number}] += 1")
    return at + len(owners)
