"""Where mutants are run: the plants of the scenarios, loaded once in each process."""

from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from time import perf_counter
from typing import TypeAlias

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.checked import Block, Program, Statement
from harness.engine.compiled.probes import Probe
from harness.engine.compiled.replaceable import CompiledBody, ReplaceableEngine
from harness.engine.environment import Environment
from harness.engine.interface import Limits
from harness.scenario import ScenarioCase
from harness.scenario.runner import ScenarioRun
from harness.scenario.staging import Staging
from harness.verify.mutation.finding import mutants_of
from harness.verify.mutation.fingerprint import fingerprint
from harness.verify.mutation.mutant import Mutant
from harness.verify.mutation.watching import Watch

MOST_PASSES = 200_000
"""Loop passes of one scan after which a mutant counts as hanging; no shipped block comes near."""


@dataclass(frozen=True, slots=True)
class Ending:
    """How a run ended. `failures` is empty if every check held; `at_ns` is the plant's time."""

    failures: tuple[Diagnostic, ...]
    at_ns: int
    seconds: float


@dataclass(frozen=True, slots=True)
class Subject:
    """A block of one program. Blocks with the same name and key are the same block."""

    block: Block
    body: tuple[Statement, ...]
    key: str
    mutants: tuple[Mutant, ...]


_Made: TypeAlias = tuple[Block, Sequence[Statement], Probe | None]


@dataclass(frozen=True, slots=True)
class OtherBody:
    """Statements in the place of those of a block. `key` is another one for others."""

    key: str
    make: Callable[[], _Made]


_MOST_BODIES = 20
"""How many compiled bodies are kept: a mutant is run in several cases, one after the other."""


class Stage:
    """The cases of a mutation run, each with its plant, and one engine for each program.

    Raises DiagnosticError for what is wrong in the plants.
    """

    def __init__(self, cases: Sequence[ScenarioCase], catalog: Catalog) -> None:
        self.cases = tuple(cases)
        self._staging = [Staging(case.path, case.scenario, catalog) for case in cases]
        self._planned = [
            staging.planned(case.variation, case.dialect)
            for staging, case in zip(self._staging, cases, strict=True)
        ]
        self._engines: dict[tuple[int, int], ReplaceableEngine] = {}
        self._subjects: dict[tuple[int, str], Subject] = {}
        self._watches: dict[tuple[int, str], Watch] = {}
        self._bodies: dict[tuple[int, str], CompiledBody] = {}

    def program(self, case: int) -> Program:
        """The program of a case."""
        return self._planned[case].program

    def place(self, case: int) -> str:
        """What a case plays on, in a word: the plant, or the scenario of a block on its own."""
        plan = self._planned[case].plan
        return plan.name if plan is not None else self.cases[case].path.stem.partition(".")[0]

    def subject(self, case: int, name: str) -> Subject | None:
        """The block with a name in the program of a case; None if it has none."""
        program = self.program(case)
        block = program.blocks.get(name.casefold())
        if block is None or block not in program.bodies:
            return None
        key = id(program), block.name
        if key not in self._subjects:
            self._subjects[key] = subject_of(program, block)
        return self._subjects[key]

    # --- running ------------------------------------------------------------------------------

    def run(
        self,
        case: int,
        other: OtherBody | None = None,
        attach: Callable[[ScenarioRun], None] = lambda run: None,
    ) -> Ending:
        """Run a case, one block of it with other statements if they are given.

        `attach` gets the plant before it starts.
        """
        begin = perf_counter()
        engines: list[ReplaceableEngine] = []

        def load(program: Program, environment: Environment, limits: Limits) -> ReplaceableEngine:
            engines.append(self._engine(program, environment, limits))
            return engines[0]

        one = self.cases[case]
        run = ScenarioRun(
            one.scenario, self._staging[case].build(self._planned[case], one.seed, load)
        )
        engine = engines[0]
        attach(run)
        with nullcontext() if other is None else engine.using(self._compiled(engine, other)):
            failures = _failures(run)
        return Ending(failures, run.stage.kernel.now_ns, perf_counter() - begin)

    def _engine(
        self, program: Program, environment: Environment, limits: Limits
    ) -> ReplaceableEngine:
        key = id(program), len(environment.inputs)
        engine = self._engines.get(key)
        if engine is None:
            limits = replace(limits, loop_passes=min(limits.loop_passes, MOST_PASSES))
            engine = self._engines[key] = ReplaceableEngine(program, environment, limits)
        else:
            engine.move_to(environment)
        return engine

    def _compiled(self, engine: ReplaceableEngine, other: OtherBody) -> CompiledBody:
        key = id(engine), other.key
        if key not in self._bodies:
            if len(self._bodies) >= _MOST_BODIES:
                self._bodies.clear()
            self._bodies[key] = engine.compiled_body(*other.make())
        return self._bodies[key]

    def mutant(self, case: int, name: str, number: int) -> OtherBody:
        """A mutant of a block, to be run in a case."""
        subject = self.subject(case, name)
        assert subject is not None, "only cases with the block are run"
        mutant = subject.mutants[number]
        return OtherBody(mutant.id, lambda: (subject.block, mutant.body(subject.body), None))

    def watch(self, case: int, name: str) -> tuple[Ending, bytes]:
        """Run a case unchanged, and see what it could notice of each mutant of a block."""
        subject = self.subject(case, name)
        assert subject is not None, "only cases with the block are run"
        key = id(self.program(case)), subject.block.name
        if key not in self._watches:
            self._watches[key] = Watch(subject.block, subject.body, subject.mutants)
        watch = self._watches[key]
        watch.seen[:] = bytes(len(watch.seen))
        ending = self.run(
            case, OtherBody(f"{name}:watched", lambda: (watch.block, watch.body, watch.probe))
        )
        return ending, bytes(watch.seen)


def _failures(run: ScenarioRun) -> tuple[Diagnostic, ...]:
    try:
        run.run()
    except DiagnosticError as wrong:
        return wrong.diagnostics
    return ()


def subject_of(program: Program, block: Block) -> Subject:
    """A block of a program with its mutants."""
    body = program.bodies[block]
    return Subject(block, body, fingerprint(block, body), mutants_of(block, body))


def blocks_of(program: Program) -> Mapping[str, Block]:
    """The blocks of a program that have statements, by name."""
    return {block.name: block for block in program.bodies}
