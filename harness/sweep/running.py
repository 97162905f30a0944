"""A sweep that takes long: in several processes, with a journal from which it goes on.

What a point gives depends on nothing but its conditions, so the result is the same with however
many processes, in one go or in several.
"""

from collections.abc import Callable, Container, Iterator, Sequence
from contextlib import closing
from dataclasses import asdict
from functools import cache
from itertools import groupby
from pathlib import Path

from fbgen.catalog import TelegramGateway, load_catalog, with_own_sequences
from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.plant import load_plant
from fbgen.workers import in_order
from harness.journal import Entry, Journal, OtherRunError
from harness.sweep.conditions import Conditions
from harness.sweep.contents import contents
from harness.sweep.result import Point, SweepResult
from harness.sweep.rules import Violation
from harness.sweep.sweeping import Sweep

_FORMAT = 1
_TOGETHER = 20
"""So many points take about a second: not much is lost when a run ends, and a line is worth it."""


@dataclass(frozen=True, slots=True)
class Progressed:
    """How far a sweep is: `done` points, of which a journal had some."""

    done: int
    planned: int


@dataclass(frozen=True, slots=True)
class _Chunk:
    """Combinations that follow each other and share a program, from the place `first` on."""

    plant: Path
    first: int
    conditions: tuple[Conditions, ...]


@dataclass(frozen=True, slots=True)
class SweepRun:
    """A plant file, the combinations to go through, the processes, and where points are noted."""

    plant: Path
    conditions: Sequence[Conditions]
    processes: int = 1
    journal: Path | None = None
    together: int = _TOGETHER
    """So many points are one piece of work, and one line of the journal."""

    def run(
        self, progressed: Callable[[Progressed], None] = lambda how: None
    ) -> tuple[SweepResult, bool]:
        """Run all points that the journal does not have yet; the result, and whether it is whole.

        Ctrl-C ends it: the result and the journal then have what was run up to then.

        Raises DiagnosticError FB8074 for the journal of another sweep, FB8075 for a plant that
        cannot be swept, FB9020 if the system ends one of the processes.
        """
        sweep = _sweep(self.plant)
        journal = None if self.journal is None else self._open(self.journal, sweep)
        found = {} if journal is None else _points(journal.entries)
        whole = True
        try:
            progressed(Progressed(len(found), len(self.conditions)))
            chunks = list(self._chunks(found))
            with closing(in_order(_run_chunk, chunks, self.processes)) as results:
                for chunk, points in zip(chunks, results, strict=True):
                    if journal is not None:
                        journal.add(_entry(chunk.first, points))
                    found |= dict(enumerate(points, chunk.first))
                    progressed(Progressed(len(found), len(self.conditions)))
        except KeyboardInterrupt:
            whole = False
        finally:
            if journal is not None:
                journal.close()
        ran = ((self.conditions[at], found[at]) for at in sorted(found))
        return sweep.result(ran, len(self.conditions)), whole

    def _chunks(self, done: Container[int]) -> Iterator[_Chunk]:
        """What is left, in pieces that are cut at the same places whatever is done already."""
        conditions = self.conditions
        left = [at for at in range(len(conditions)) if at not in done]
        for _, places in groupby(left, lambda at: (at // self.together, conditions[at].program)):
            numbers = list(places)
            yield _Chunk(self.plant, numbers[0], tuple(conditions[at] for at in numbers))

    def _open(self, path: Path, sweep: Sweep) -> Journal:
        plan = self.plant.read_text(encoding="utf-8")
        head = {"sweep": _FORMAT, "contents": contents(sweep, plan, self.conditions)}
        try:
            return Journal(path, head)
        except OtherRunError as other:
            raise error(
                "FB8074",
                f"{path.as_posix()} is not the journal of this sweep",
                other.span,
                "the plant, the blocks, the program or the points have changed since it was "
                "written, or it is another file: remove it, or name a new one",
            ) from None


def _run_chunk(chunk: _Chunk) -> list[Point]:
    sweep = _sweep(chunk.plant)
    return [sweep.point(item) for item in chunk.conditions]


@cache
def _sweep(plant: Path) -> Sweep:
    catalog = with_own_sequences(load_catalog(), plant.parent)
    plan = load_plant(plant, catalog)
    for item in plan.gateways:
        if not isinstance(catalog.gateway(item.type), TelegramGateway):
            raise error(
                "FB1206",
                f"the phase sweep puts cycles against the telegrams of a line, and the gateway "
                f"'{item.name}' ({item.type}) carries none",
                item.span_of("type"),
                "fbgen campaign tries such a plant with other cycles and phases",
            )
    return Sweep(plan, catalog)


def _entry(first: int, points: Sequence[Point]) -> Entry:
    return {"first": first, "points": [asdict(point) for point in points]}


def _points(entries: Sequence[Entry]) -> dict[int, Point]:
    return {
        at: Point(
            item["requests"],
            item["telegrams"],
            item["longest_ns"],
            tuple(Violation(**violation) for violation in item["violations"]),
        )
        for entry in entries
        for at, item in enumerate(entry["points"], entry["first"])
    }
