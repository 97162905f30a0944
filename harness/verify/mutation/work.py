"""What the processes of a mutation run do, one piece of work after the other.

Each process has a stage of its own. On systems that copy a process to get another one the stage is
made once, before they are started.
"""

from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from fbgen.catalog import load_catalog
from fbgen.dataclass import dataclass
from harness.scenario import scenario_cases
from harness.scenario.runner import ScenarioRun
from harness.trace import Recorder, Trace
from harness.verify.mutation.effects import first_difference
from harness.verify.mutation.log import Noticed
from harness.verify.mutation.stage import OtherBody, Stage
from harness.verify.mutation.watching import CHANGED, REACHED

if TYPE_CHECKING:
    from harness.verify.mutation.proof.invariants import Invariant


@dataclass(frozen=True, slots=True)
class CaseName:
    """One case of a scenario file, by its number in the file."""

    path: Path
    number: int


Cases: TypeAlias = tuple[CaseName, ...]


@cache
def stage_of(cases: Cases) -> Stage:
    """The stage of this process. Raises DiagnosticError for what is wrong in files and plants."""
    files = {name.path: scenario_cases(name.path) for name in cases}
    return Stage([files[name.path][name.number] for name in cases], load_catalog())


@dataclass(frozen=True, slots=True)
class Look:
    """Run a case unchanged and see what it could notice of some mutants of a block."""

    cases: Cases
    case: int
    block: str
    asked: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Looked:
    """How that run ended: `seen` is a number for each mutant that was asked for, see `watching`.

    `failures` are the messages of a case that does not even pass unchanged.
    """

    seen: bytes
    failures: tuple[str, ...] = ()

    def having(self, asked: tuple[int, ...], bit: int) -> set[int]:
        """The mutants with a bit."""
        return {number for number, seen in zip(asked, self.seen, strict=True) if seen & bit}


def look(work: Look) -> Looked:
    """Carry it out. Where watching itself stops a program, all mutants count as noticed."""
    stage = stage_of(work.cases)
    failures, seen = stage.watch(work.case, work.block, work.asked)
    if failures:
        seen = bytes([REACHED | CHANGED]) * len(seen)
        failures = stage.run(work.case).failures
    return Looked(seen, tuple(one.message for one in failures))


@dataclass(frozen=True, slots=True)
class Trial:
    """Run a mutant in a case."""

    cases: Cases
    case: int
    block: str
    number: int


def try_mutant(work: Trial) -> Noticed | None:
    """Carry it out; None if every check held."""
    stage = stage_of(work.cases)
    ending = stage.run(work.case, stage.mutant(work.block, work.number))
    if not ending.failures:
        return None
    first = ending.failures[0]
    return f"{first.code}: {first.message}", ending.at_ns


def carry_out(work: Look | Trial) -> Any:
    """What `look` or `try_mutant` gives."""
    return look(work) if isinstance(work, Look) else try_mutant(work)


@dataclass(frozen=True, slots=True)
class Survivor:
    """A mutant that none of these cases has noticed, though it runs otherwise in them."""

    cases: Cases
    block: str
    number: int
    ran: tuple[int, ...]


MOST_RECORDED = 8


def find_effect(work: Survivor) -> str:
    """What the first case that shows it changes with this mutant, as far as can be seen.

    Only the first cases are looked at: recording takes longer than running.
    """
    stage = stage_of(work.cases)
    for case in work.ran[:MOST_RECORDED]:
        before = _unchanged(work.cases, case)
        after = _traced(stage, case, stage.mutant(work.block, work.number))
        if before is None or after is None:
            continue
        if difference := first_difference(before, after):
            return f"{difference}, in {stage.cases[case].name}"
    return ""


def prove(work: Survivor) -> str:
    """How a mutant is proved to be the same as the block; "" without a proof."""
    from harness.verify.mutation.proof.proving import Answer, compare  # noqa: PLC0415 - an extra

    stage = stage_of(work.cases)
    home = work.ran[0]
    subject = stage.subject(home, work.block)
    assert subject is not None, "the home of a mutant has the block"
    other = subject.mutants[work.number].body(subject.body)
    known = _invariants(work.cases, work.ran, work.block)
    proof = compare(stage.program(home), subject.block, subject.body, other, known)
    if proof.answer is not Answer.EQUIVALENT:
        return ""
    return "no values that its variables can have tell one call of it from one of the block"


@lru_cache(maxsize=1)
def _invariants(cases: Cases, ran: tuple[int, ...], name: str) -> "tuple[Invariant, ...]":
    """What the variables of a block hold between its calls, in the programs of all these cases."""
    from harness.verify.mutation.proof.proving import invariants_of  # noqa: PLC0415 - an extra

    stage = stage_of(cases)
    subject = stage.subject(ran[0], name)
    assert subject is not None, "only cases with the block are asked"
    programs = {id(stage.program(case)): stage.program(case) for case in ran}
    return invariants_of(tuple(programs.values()), subject.block)


@lru_cache(maxsize=2 * MOST_RECORDED)
def _unchanged(cases: Cases, case: int) -> Trace | None:
    return _traced(stage_of(cases), case)


def _traced(stage: Stage, case: int, other: OtherBody | None = None) -> Trace | None:
    """What a run leaves; None for a block on its own, which has no plant around it."""
    recorders: list[Recorder] = []

    def attach(run: ScenarioRun) -> None:
        if run.stage.installation is not None:
            recorders.append(run.stage.installation.record())

    stage.run(case, other, attach)
    return recorders[0].finish() if recorders else None
