"""The mutants of one block, tried in one case after the other until a check notices.

In each case only those are run that the case could notice, and only if no case before has. While
they are run, the next case is looked at by another process.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.workers import Workers
from harness.verify.mutation.log import Known, Log
from harness.verify.mutation.order import Order, cheapest_first
from harness.verify.mutation.stage import Stage
from harness.verify.mutation.subjects import Target, contents_of
from harness.verify.mutation.verdict import Fate, Verdict
from harness.verify.mutation.watching import CHANGED, REACHED
from harness.verify.mutation.work import Cases, Look, Looked, Trial, carry_out


@dataclass(slots=True)
class Rounds:
    """What has come of the mutants of a target so far, by their numbers.

    `live` are those that no check has noticed yet. `reached` are those whose statements a case has
    run, `runs` has the cases in which a mutant was run itself. `settled` has the verdicts on those
    that were noticed or proved.
    """

    cases: Cases
    stage: Stage
    workers: Workers
    log: Log
    target: Target
    live: set[int]
    reached: set[int] = field(default_factory=set)
    runs: dict[int, list[int]] = field(default_factory=dict)
    settled: dict[int, Verdict] = field(default_factory=dict)
    _keys: dict[int, str] = field(default_factory=dict)
    _asked: tuple[int, ...] = ()

    def play(
        self,
        began: Callable[[str, int], None],
        finished: Callable[[str], None],
        proofs: Callable[[Sequence[int]], Mapping[int, str]],
    ) -> None:
        """All cases. Raises DiagnosticError FB8061 for one that fails without any change.

        `proofs` are asked for behind the cheaper half: the other one takes longer than a proof.
        """
        self._take_what_is_known(cheapest_first(self.stage.cases, self.target.cases))
        order = Order(self.stage.cases, self.target.cases, self._has_noticed)
        half = len(order) // 2
        self._play(order, len(order) - half, began, finished)
        for number, why in proofs(sorted(self.live)).items():
            self.live.discard(number)
            self.settled[number] = Verdict(self.target.id_of(number), Fate.PROVED, why=why)
        self._play(order, half, began, finished)

    def _play(
        self,
        order: Order,
        count: int,
        began: Callable[[str, int], None],
        finished: Callable[[str], None],
    ) -> None:
        began(f"scenarios for {self.target.name}", count)
        before: int | None = None
        for number in range(count + 1):
            case = order.next() if number < count else None
            self._round(before, case)
            if before is not None:
                finished(self.stage.cases[before].name)
            before = case

    def _has_noticed(self, case: int) -> bool:
        """Whether a case has noticed any mutant, in this run or in one that the log has."""
        return any(one is not None for one in self._known(case).noticed.values())

    def verdict(self, number: int) -> Verdict:
        """What came of a mutant."""
        if number in self.settled:
            return self.settled[number]
        name = self.target.id_of(number)
        if runs := self.runs.get(number):
            return Verdict(name, Fate.SURVIVED, runs=len(runs))
        return Verdict(name, Fate.UNCHANGED if number in self.reached else Fate.UNREACHED)

    def key(self, case: int) -> str:
        """What a case is called in the log: it stands for everything that happens in it."""
        if case not in self._keys:
            self._keys[case] = contents_of(self.stage, case)
        return self._keys[case]

    def _known(self, case: int) -> Known:
        return self.log.known(self.target.subject.key, self.key(case))

    def _take_what_is_known(self, order: Sequence[int]) -> None:
        for case in order:
            for number in sorted(self.live & set(self._known(case).noticed)):
                self._take(case, number)

    def _round(self, case: int | None, following: int | None) -> None:
        """Run in a case what it could notice, and look at the case that follows."""
        block = self.target.subject.block.name
        work: list[Look | Trial] = []
        if following is not None and (asked := self._questions(following)):
            work.append(Look(self.cases, following, block, asked))
        if case is not None:
            known = self._known(case)
            self.reached |= known.reached & self.live
            for number in sorted(known.changed & self.live):
                if number in known.noticed:
                    self._take(case, number)
                else:
                    work.append(Trial(self.cases, case, block, number))
        for one, result in zip(work, self.workers.in_order(carry_out, work), strict=True):
            if isinstance(one, Look):
                self._note(one, result)
            else:
                self.log.note_run(self.target.subject.key, self.key(one.case), one.number, result)
                self._take(one.case, one.number)

    def _questions(self, case: int) -> tuple[int, ...]:
        """What is asked of a case. As each question is compiled, the last ones are asked again."""
        needed = self.live - self._known(case).asked
        if not needed or not needed <= set(self._asked) or 2 * len(needed) < len(self._asked):
            self._asked = tuple(sorted(needed))
        return self._asked

    def _note(self, work: Look, result: Looked) -> None:
        if result.failures:
            raise DiagnosticError([self._fails_as_it_is(work.case, result.failures[0])])
        reached, changed = (result.having(work.asked, bit) for bit in (REACHED, CHANGED))
        key = self.target.subject.key
        self.log.note_look(key, self.key(work.case), set(work.asked), reached, changed)

    def _take(self, case: int, number: int) -> None:
        """Take what a case said of a mutant."""
        self.runs.setdefault(number, []).append(case)
        noticed = self._known(case).noticed[number]
        if noticed is None:
            return
        self.live.discard(number)
        check, at_ns = noticed
        self.settled[number] = Verdict(
            self.target.id_of(number),
            Fate.KILLED,
            self.stage.cases[case].name,
            check,
            at_ns,
            len(self.runs[number]),
        )

    def _fails_as_it_is(self, number: int, failure: str) -> Diagnostic:
        case = self.stage.cases[number]
        return Diagnostic(
            "FB8061",
            f"the scenario '{case.name}' fails without any change: {failure}",
            help=f"mend it first: fbgen test {case.path.as_posix()}",
        )
