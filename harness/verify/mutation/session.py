"""A mutation run: look at the cases, try the mutants, say of the survivors what is known."""

import random
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.workers import in_order
from harness.verify.mutation.finding import ALL
from harness.verify.mutation.log import Log
from harness.verify.mutation.mutant import Mutant, Operator
from harness.verify.mutation.stage import Stage
from harness.verify.mutation.subjects import Target, contents_of
from harness.verify.mutation.verdict import Fate, Verdict
from harness.verify.mutation.watching import CHANGED, REACHED
from harness.verify.mutation.work import (
    Cases,
    Look,
    Looked,
    Trial,
    find_effect,
    in_order_of_time,
    look,
    prove,
    stage_of,
    try_mutant,
)


@dataclass(frozen=True, slots=True)
class Wanted:
    """What a run is asked for.

    `most` limits the mutants, drawn by `seed`; `ids` names single ones. With `prove` a solver looks
    at what no check has noticed. `log` is the file that an
    ended run goes on from.
    """

    operators: Collection[Operator] = ALL
    most: int | None = None
    seed: int = 0
    ids: tuple[str, ...] = ()
    jobs: int = 1
    prove: bool = False
    log: Path | None = None


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


@dataclass(frozen=True, slots=True)
class _Chosen:
    id: str
    target: Target
    number: int


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
    log = Log(wanted.log, contents_of(stage, targets))
    run = MutationRun(len(chosen))
    verdicts = {one.id: log.known[one.id] for one in chosen if one.id in log.known}
    session = _Session(cases, stage, wanted.jobs, log, verdicts, began, finished)
    try:
        session.work_on(chosen)
        if wanted.prove:
            session.prove(chosen)
    except KeyboardInterrupt:
        run.interrupted = True
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


@dataclass(slots=True)
class _Session:
    cases: Cases
    stage: Stage
    jobs: int
    log: Log
    verdicts: dict[str, Verdict]
    began: Callable[[str, int], None]
    finished: Callable[[str], None]

    def work_on(self, chosen: Sequence[_Chosen]) -> None:
        left = [one for one in chosen if one.id not in self.verdicts]
        looked = self._look({one.target.name: one.target for one in left})
        trials: list[tuple[_Chosen, Trial]] = []
        for one in left:
            cases = looked[one.target.name]
            trial = self._trial(one, in_order_of_time(cases, one.number, CHANGED))
            if trial.order:
                trials.append((one, trial))
            else:
                reached = bool(in_order_of_time(cases, one.number, REACHED))
                fate = Fate.UNCHANGED if reached else Fate.UNREACHED
                self._settle(Verdict(one.id, fate))
        self._try(trials)

    def _trial(self, one: _Chosen, order: tuple[int, ...]) -> Trial:
        return Trial(self.cases, one.target.subject.block.name, one.number, one.id, order)

    def _look(self, targets: dict[str, Target]) -> dict[str, list[Looked]]:
        """What each case could notice of each block; fails if one does not pass as it is."""
        work = [
            (name, Look(self.cases, case, target.subject.block.name))
            for name, target in targets.items()
            for case in target.cases
        ]
        found: dict[str, list[Looked]] = {name: [] for name in targets}
        failed: dict[int, Diagnostic] = {}
        self.began("scenarios", len(work))
        for (name, _), looked in zip(
            work, in_order(look, [one for _, one in work], self.jobs), strict=False
        ):
            found[name].append(looked)
            self.finished(self.stage.cases[looked.case].name)
            if looked.failures:
                failed[looked.case] = self._fails_as_it_is(looked)
        if failed:
            raise DiagnosticError(failed.values())
        return found

    def _fails_as_it_is(self, looked: Looked) -> Diagnostic:
        case = self.stage.cases[looked.case]
        return Diagnostic(
            "FB8061",
            f"the scenario '{case.name}' fails without any change: {looked.failures[0]}",
            help=f"mend it first: fbgen test {case.path.as_posix()}",
        )

    def _try(self, trials: Sequence[tuple[_Chosen, Trial]]) -> None:
        self.began("mutants", len(trials))
        work = [trial for _, trial in trials]
        survivors: list[tuple[Trial, Verdict]] = []
        for trial, verdict in zip(work, in_order(try_mutant, work, self.jobs), strict=False):
            self.finished(verdict.id)
            if verdict.fate is Fate.SURVIVED:
                survivors.append((trial, verdict))
                self.verdicts[verdict.id] = verdict
            else:
                self._settle(verdict)
        self.began("survivors", len(survivors))
        work = [trial for trial, _ in survivors]
        for (_, verdict), effect in zip(
            survivors, in_order(find_effect, work, self.jobs), strict=False
        ):
            self.finished(verdict.id)
            self._settle(replace(verdict, effect=effect))

    def prove(self, chosen: Sequence[_Chosen]) -> None:
        """Look for proofs that mutants make no difference to anybody."""
        open_fates = (Fate.SURVIVED, Fate.UNCHANGED, Fate.UNREACHED)
        alive = [one for one in chosen if self.verdicts[one.id].fate in open_fates]
        work = [self._trial(one, (one.target.home,)) for one in alive]
        self.began("proofs", len(work))
        for one, why in zip(alive, in_order(prove, work, self.jobs), strict=False):
            self.finished(one.id)
            if why:
                self._settle(Verdict(one.id, Fate.PROVED, why=why))

    def _settle(self, verdict: Verdict) -> None:
        self.verdicts[verdict.id] = verdict
        self.log.note(verdict)
