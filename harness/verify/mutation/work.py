"""What the processes of a mutation run do, one piece of work after the other.

Each process has a stage of its own. On systems that copy a process to get another one the stage is
made once, before they are started.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TypeAlias

from fbgen.catalog import load_catalog
from harness.scenario import scenario_cases
from harness.scenario.runner import ScenarioRun
from harness.trace import Recorder, Trace
from harness.verify.mutation.effects import first_difference
from harness.verify.mutation.stage import OtherBody, Stage
from harness.verify.mutation.verdict import Fate, Verdict
from harness.verify.mutation.watching import CHANGED, REACHED


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
    """Run a case unchanged and see what it could notice of the mutants of a block."""

    cases: Cases
    case: int
    block: str


@dataclass(frozen=True, slots=True)
class Looked:
    """How that run ended: `seen` is a number for each mutant, see `watching`.

    `at_ns` is how long it took in the plant's time, which is the same each time. `failures` are
    the messages of a case that does not even pass unchanged.
    """

    case: int
    block: str
    at_ns: int
    seen: bytes
    failures: tuple[str, ...] = ()


def look(work: Look) -> Looked:
    """Carry it out. Where watching itself stops a program, all mutants count as noticed."""
    stage = stage_of(work.cases)
    ending, seen = stage.watch(work.case, work.block)
    if ending.failures:
        seen = bytes([REACHED | CHANGED]) * len(seen)
        ending = stage.run(work.case)
    failures = tuple(one.message for one in ending.failures)
    return Looked(work.case, work.block, ending.at_ns, seen, failures)


@dataclass(frozen=True, slots=True)
class Trial:
    """Run a mutant in these cases, until one of them fails."""

    cases: Cases
    block: str
    number: int
    id: str
    order: tuple[int, ...]


def try_mutant(work: Trial) -> Verdict:
    """Carry it out."""
    stage = stage_of(work.cases)
    for runs, case in enumerate(work.order, start=1):
        ending = stage.run(case, stage.mutant(case, work.block, work.number))
        if ending.failures:
            name = stage.cases[case].name
            first = ending.failures[0]
            message = f"{first.code}: {first.message}"
            return Verdict(work.id, Fate.KILLED, name, message, ending.at_ns, runs)
    return Verdict(work.id, Fate.SURVIVED, runs=len(work.order))


_MOST_RECORDED = 8


def find_effect(work: Trial) -> str:
    """What the first case that shows it changes with this mutant, as far as can be seen.

    Only the shortest cases are looked at: recording takes longer than running.
    """
    stage = stage_of(work.cases)
    for case in work.order[:_MOST_RECORDED]:
        before = _traced(stage, case)
        after = _traced(stage, case, stage.mutant(case, work.block, work.number))
        if before is None or after is None:
            continue
        if difference := first_difference(before, after):
            return f"{difference}, in {stage.cases[case].name}"
    return ""


def prove(work: Trial) -> str:
    """How a mutant is proved to be the same as the block; "" without a proof."""
    from harness.verify.mutation.proof.proving import Answer, compare  # noqa: PLC0415 - an extra

    stage = stage_of(work.cases)
    subject = stage.subject(work.order[0], work.block)
    assert subject is not None, "the home of a mutant has the block"
    other = subject.mutants[work.number].body(subject.body)
    proof = compare(stage.program(work.order[0]), subject.block, subject.body, other)
    proved = proof.answer is Answer.EQUIVALENT
    return "no values of its variables tell one call of it from one of the block" if proved else ""


def _traced(stage: Stage, case: int, other: OtherBody | None = None) -> Trace | None:
    """What a run leaves; None for a block on its own, which has no plant around it."""
    recorders: list[Recorder] = []

    def attach(run: ScenarioRun) -> None:
        if run.stage.installation is not None:
            recorders.append(run.stage.installation.record())

    stage.run(case, other, attach)
    return recorders[0].finish() if recorders else None


def in_order_of_time(cases: Sequence[Looked], number: int, bit: int) -> tuple[int, ...]:
    """The cases whose run has this bit for a mutant, fastest first."""
    found = [one for one in cases if one.seen[number] & bit]
    return tuple(one.case for one in sorted(found, key=lambda one: (one.at_ns, one.case)))
