"""A mutation run: look at the cases, try the mutants, say of the survivors what is known."""

import random
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import field, replace
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.nearest import nearest
from fbgen.workers import Workers
from harness.verify.mutation.equivalents import NO_REASONS, Equivalents
from harness.verify.mutation.finding import ALL
from harness.verify.mutation.log import Log
from harness.verify.mutation.mutant import Mutant, Operator
from harness.verify.mutation.rounds import Rounds
from harness.verify.mutation.stage import Stage
from harness.verify.mutation.subjects import Target, program_key
from harness.verify.mutation.verdict import Fate, Verdict
from harness.verify.mutation.work import (
    MOST_RECORDED,
    Cases,
    Survivor,
    find_effect,
    prove,
    stage_of,
)


@dataclass(frozen=True, slots=True)
class Wanted:
    """What a run is asked for.

    `most` limits the mutants, drawn by `seed`; `ids` names single ones. With `prove` a solver looks
    at what no check has noticed. `reasons` are those of the user why a mutant is equivalent. `log`
    is the file that an ended run goes on from.
    """

    operators: Collection[Operator] = ALL
    most: int | None = None
    seed: int = 0
    ids: tuple[str, ...] = ()
    jobs: int = 1
    prove: bool = False
    log: Path | None = None
    reasons: Equivalents = NO_REASONS


@dataclass(frozen=True, slots=True)
class Tried:
    """A mutant with what came of it."""

    id: str
    target: Target
    number: int
    verdict: Verdict

    @property
    def mutant(self) -> Mutant:
        """The mutant itself."""
        return self.target.subject.mutants[self.number]

    @property
    def fingerprint(self) -> str:
        """What it is called in the file of reasons."""
        return self.target.subject.fingerprints[self.number]


@dataclass(frozen=True, slots=True)
class _Chosen:
    id: str
    target: Target
    number: int


@dataclass(frozen=True, slots=True)
class _Asked:
    """Something to be found out of a mutant, by running it in cases; `of` is what it depends on."""

    number: int
    ran: tuple[int, ...]
    of: str


@dataclass(slots=True)
class MutationRun:
    """What has come of a run, filled while it goes on.

    `planned` is how many mutants were to be tried; `interrupted` after Ctrl-C.
    """

    planned: int = 0
    tried: list[Tried] = field(default_factory=list)
    interrupted: bool = False


def run_mutants(
    cases: Cases,
    targets: Sequence[Target],
    wanted: Wanted,
    *,
    began: Callable[[str, int], None] = lambda what, count: None,
    finished: Callable[[str], None] = lambda what: None,
) -> MutationRun:
    """Try the mutants of some blocks.

    `began` is told of each stretch of work and how many pieces it has, `finished` of each piece.

    Raises DiagnosticError FB8061 for scenarios that fail without any change, FB8062 for an id that
    no mutant has, FB8063 for a log that is none.
    """
    stage = stage_of(cases)
    chosen = _chosen(targets, wanted)
    run = MutationRun(len(chosen))
    with Workers(wanted.jobs) as workers:
        session = _Session(cases, stage, workers, Log(wanted.log), began, finished)
        try:
            for target in targets:
                numbers = [one.number for one in chosen if one.target is target]
                if numbers:
                    session.work_on(target, numbers, wanted)
        except KeyboardInterrupt:
            run.interrupted = True
    verdicts = session.verdicts
    run.tried += [
        Tried(one.id, one.target, one.number, verdicts[one.id])
        for one in chosen
        if one.id in verdicts
    ]
    return run


def _chosen(targets: Sequence[Target], wanted: Wanted) -> list[_Chosen]:
    every = [
        _Chosen(target.id_of(number), target, number)
        for target in targets
        for number, mutant in enumerate(target.subject.mutants)
        if mutant.operator in wanted.operators
    ]
    if wanted.ids:
        known = {one.id: one for one in every}
        for name in wanted.ids:
            if name not in known:
                raise error(
                    "FB8062", f"there is no mutant '{name}'", help=nearest(name, tuple(known))
                )
        return [known[name] for name in wanted.ids]
    if wanted.most is not None and wanted.most < len(every):
        drawn = set(random.Random(wanted.seed).sample(range(len(every)), wanted.most))
        return [one for place, one in enumerate(every) if place in drawn]
    return every


def _reason(target: Target, number: int, reasons: Equivalents) -> str:
    """Why a mutant is equivalent, if the user says so."""
    if not reasons.equivalents:
        return ""
    subject = target.subject
    return reasons.reason(subject.block.name, subject.fingerprints[number])


@dataclass(slots=True)
class _Session:
    cases: Cases
    stage: Stage
    workers: Workers
    log: Log
    began: Callable[[str, int], None]
    finished: Callable[[str], None]
    verdicts: dict[str, Verdict] = field(default_factory=dict)

    def work_on(self, target: Target, numbers: Sequence[int], wanted: Wanted) -> None:
        """Run the mutants of a block, and find out what can be said of those that survive."""
        rounds = Rounds(self.cases, self.stage, self.workers, self.log, target, set(numbers))

        def proofs(alive: Sequence[int]) -> dict[int, str]:
            return self._proofs(target, alive) if wanted.prove else {}

        try:
            rounds.play(self.began, self.finished, proofs)
        except KeyboardInterrupt:
            self._settle(rounds.settled.values())
            raise
        alive = sorted(rounds.live)
        self._settle(rounds.verdict(number) for number in numbers)
        effects = self._effects(rounds, [number for number in alive if number in rounds.runs])
        self._settle(
            replace(rounds.verdict(number), effect=effect) for number, effect in effects.items()
        )
        quiet = [number for number in alive if not effects.get(number)]
        self._settle(
            Verdict(target.id_of(number), Fate.EXPLAINED, why=reason)
            for number in quiet
            if (reason := _reason(target, number, wanted.reasons))
        )

    def _settle(self, verdicts: Iterable[Verdict]) -> None:
        self.verdicts |= {verdict.id: verdict for verdict in verdicts}

    def _proofs(self, target: Target, alive: Sequence[int]) -> dict[int, str]:
        """Proofs that mutants make no difference to anybody."""
        keys = sorted({program_key(self.stage, case) for case in target.cases})
        ran = (target.home, *(case for case in target.cases if case != target.home))
        work = [_Asked(number, ran, f"proof {' '.join(keys)}") for number in alive]
        said = self._said(target, "proofs", prove, work)
        return {number: why for number, why in said.items() if why}

    def _effects(self, rounds: Rounds, survivors: Sequence[int]) -> dict[int, str]:
        """What survivors change that can be seen from outside, though no check notices."""
        work = []
        for number in survivors:
            cases = tuple(rounds.runs[number][:MOST_RECORDED])
            keys = " ".join(map(rounds.key, cases))
            work.append(_Asked(number, cases, f"effect {keys}"))
        return self._said(rounds.target, "survivors", find_effect, work)

    def _said(
        self,
        target: Target,
        what: str,
        find: Callable[[Survivor], str],
        wanted: Sequence[_Asked],
    ) -> dict[int, str]:
        """What is said of mutants, in the log or else by `find`."""
        block, key = target.subject.block.name, target.subject.key
        found = {one.number: self.log.said(key, one.number, one.of) for one in wanted}
        unknown = [one for one in wanted if found[one.number] is None]
        work = [Survivor(self.cases, block, one.number, one.ran) for one in unknown]
        self.began(what, len(work))
        for one, said in zip(unknown, self.workers.in_order(find, work), strict=True):
            self.log.note_said(key, one.number, one.of, said)
            found[one.number] = said
            self.finished(target.id_of(one.number))
        return {number: said or "" for number, said in found.items()}
