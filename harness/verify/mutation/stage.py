"""Where mutants are run: the plants of the scenarios, loaded once in each process."""

from collections.abc import Callable, Hashable, Sequence
from contextlib import nullcontext
from dataclasses import replace

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.checked import Block, Program, Statement
from harness.engine.compiled.outside.replaceable import CompiledBody, ReplaceableEngine
from harness.engine.compiled.watching.probes import Probe
from harness.engine.environment import Environment
from harness.engine.interface import Limits
from harness.scenario import ScenarioCase
from harness.scenario.runner import ScenarioRun
from harness.scenario.staging import Staging
from harness.verify.mutation.equivalents import fingerprints
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


class Subject:
    """A block of one program. Blocks with the same name and key are the same block."""

    __slots__ = ("_fingerprints", "_mutants", "block", "body", "key")

    def __init__(self, program: Program, block: Block) -> None:
        self.block = block
        self.body = program.bodies[block]
        self.key = fingerprint(block, self.body)
        self._mutants: tuple[Mutant, ...] | None = None
        self._fingerprints: tuple[str, ...] | None = None

    @property
    def mutants(self) -> tuple[Mutant, ...]:
        """All of its mutants, made when they are asked for."""
        if self._mutants is None:
            self._mutants = mutants_of(self.block, self.body)
        return self._mutants

    @property
    def fingerprints(self) -> tuple[str, ...]:
        """What each of them is called in the file of reasons."""
        if self._fingerprints is None:
            self._fingerprints = fingerprints(self.mutants)
        return self._fingerprints


@dataclass(frozen=True, slots=True)
class OtherBody:
    """Statements in the place of those of a block. `key` is another one for others.

    `make` makes them from the block as a program has it.
    """

    block: str
    key: Hashable
    make: Callable[[Subject], tuple[Sequence[Statement], Probe | None]]


_MOST_BODIES = 1_000
"""How many compiled bodies are kept: a mutant is run in several cases."""


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
        self._engines: dict[tuple[int, int, bool], ReplaceableEngine] = {}
        self._subjects: dict[tuple[int, str], Subject] = {}
        self._bodies: dict[Hashable, CompiledBody] = {}
        self._seen: dict[Hashable, bytearray] = {}

    def program(self, case: int) -> Program:
        """The program of a case."""
        return self._planned[case].program

    def place(self, case: int) -> str:
        """What a case plays on, in a word: the plant, or the scenario of a block on its own."""
        plan = self._planned[case].plan
        return plan.name if plan is not None else self.cases[case].path.stem.partition(".")[0]

    def plan_of(self, case: int) -> str:
        """Everything that the plant file says; "" for a block on its own."""
        plan = self._planned[case].plan
        return plan.model_dump_json() if plan is not None else ""

    def subject(self, case: int, name: str) -> Subject | None:
        """The block with a name in the program of a case; None if it has none."""
        program = self.program(case)
        block = program.blocks.get(name.casefold())
        if block is None or block not in program.bodies:
            return None
        key = id(program), block.name
        if key not in self._subjects:
            self._subjects[key] = Subject(program, block)
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
        with nullcontext() if other is None else engine.using(self._compiled(case, engine, other)):
            failures = _failures(run)
        return Ending(failures, run.stage.kernel.now_ns)

    def _engine(
        self, program: Program, environment: Environment, limits: Limits
    ) -> ReplaceableEngine:
        key = id(program), len(environment.inputs), _leaves(environment)
        engine = self._engines.get(key)
        if engine is None:
            limits = replace(limits, loop_passes=min(limits.loop_passes, MOST_PASSES))
            engine = self._engines[key] = ReplaceableEngine(program, environment, limits)
        else:
            engine.move_to(environment)
        return engine

    def _compiled(self, case: int, engine: ReplaceableEngine, other: OtherBody) -> CompiledBody:
        """The other body for an engine; often it has been written for another engine before."""
        subject = self.subject(case, other.block)
        assert subject is not None, "only cases with the block are run"
        text = engine.text_of(subject.block.name)
        shared = (subject.key, text, _leaves(engine.environment), other.key)
        own = (id(engine), *shared)
        found = self._bodies.get(own) or self._bodies.get(shared)
        if found is None:
            if len(self._bodies) >= _MOST_BODIES:
                self._bodies.clear()
            found = engine.compiled_body(subject.block, *other.make(subject))
            self._bodies[shared if found.of_any else own] = found
        return found

    def mutant(self, name: str, number: int) -> OtherBody:
        """A mutant of a block, to be run in a case."""
        return OtherBody(
            name, number, lambda subject: (subject.mutants[number].body(subject.body), None)
        )

    def watch(
        self, case: int, name: str, asked: tuple[int, ...]
    ) -> tuple[tuple[Diagnostic, ...], bytes]:
        """Run a case unchanged, and see what it could notice of some mutants of a block.

        Gives a number for each of them: see `watching`.
        """
        subject = self.subject(case, name)
        assert subject is not None, "only cases with the block are run"
        seen = self._seen.setdefault((subject.key, asked), bytearray(len(asked)))
        seen[:] = bytes(len(seen))

        def make(block: Subject) -> tuple[Sequence[Statement], Probe | None]:
            watch = Watch(block.body, [block.mutants[number] for number in asked], seen)
            return watch.body, watch.probe

        ending = self.run(case, OtherBody(name, asked, make))
        return ending.failures, bytes(seen)


def _leaves(environment: Environment) -> bool:
    """Whether temporaries are left as they are at the start of a call: then code differs."""
    return environment.services.leftovers is not None


def _failures(run: ScenarioRun) -> tuple[Diagnostic, ...]:
    try:
        run.run()
    except DiagnosticError as wrong:
        return wrong.diagnostics
    return ()
