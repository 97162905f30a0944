"""Builds what a scenario plays on: its plant with the changes of a variation, or its block."""

import os.path
from collections.abc import Sequence
from pathlib import Path

from fbgen.catalog import Catalog, with_own_sequences
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.ast import LiteralKind
from fbgen.lang.checked import Program
from fbgen.lang.literals import BadLiteralError, read_literal
from fbgen.plant import Plant, in_dialect, load_plant
from harness.engine.compiled.watching.probes import ProbeMaker
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import EngineFactory, Limits
from harness.engine.loading import Clock, LoadedProgram, engine_named, read_program
from harness.installation import PlantSetup, build_plant, generated_program
from harness.kernel import Kernel
from harness.plc import CpuSettings
from harness.scenario.alone import program_of
from harness.scenario.block_stage import BlockStage
from harness.scenario.model import Scenario, Variation
from harness.scenario.places import at
from harness.scenario.plant_changes import device_problems, varied_plant
from harness.scenario.plant_stage import PlantStage
from harness.scenario.scalars import Scalar
from harness.scenario.stage import Stage
from harness.scenario.stub_tables import stub_of
from harness.scenario.temporaries import leftovers_of
from harness.trial import subject_named


@dataclass(frozen=True, slots=True)
class Planned:
    """A plant with the changes of a variation, None for a block on its own, and the program."""

    plan: Plant | None
    catalog: Catalog
    program: Program


class Staging:
    """Builds the stage of one scenario file."""

    def __init__(self, path: Path, scenario: Scenario, catalog: Catalog) -> None:
        self._folder = path.parent
        self._scenario = scenario
        self._catalog = catalog

    def stage(
        self, variation: Variation, dialect: str | None, seed: int, probes: Sequence[ProbeMaker]
    ) -> Stage:
        """Plant or block, before anything has happened.

        Raises DiagnosticError with everything that is wrong in it.
        """
        if self._scenario.engine != "compiled":
            probes = ()
        factory = engine_named(self._scenario.engine, probes)
        return self.build(self.planned(variation, dialect), seed, factory)

    def planned(self, variation: Variation, dialect: str | None) -> Planned:
        """The plant as it will be built, and its program. Raises DiagnosticError as `stage`."""
        scenario = self._scenario
        if scenario.plant is None:
            program = read_program(self._sources(), scenario.dialect or "tia", stubbed=self._stubs)
            return Planned(None, self._catalog, program)
        path = self._file("plant", scenario.plant, "plant file")
        catalog = with_own_sequences(self._catalog, path.parent)
        plan = varied_plant(load_plant(path, catalog), variation, catalog)
        if dialect is not None:
            plan = in_dialect(plan, dialect, catalog)
        if scenario.block is None and (found := list(device_problems(scenario, plan, catalog))):
            raise DiagnosticError(found)
        sources = self._sources()
        if sources and scenario.block is None:
            return Planned(plan, catalog, read_program(sources, plan.code_dialect))
        program = generated_program(plan, catalog)
        if scenario.block is not None:
            program = program_of(program, scenario.block)
        return Planned(plan, catalog, program)

    def build(self, planned: Planned, seed: int, factory: EngineFactory) -> Stage:
        """Plant or block with a program loaded by `factory`. Raises DiagnosticError."""
        if planned.plan is None or self._scenario.block is not None:
            return self._block(planned, seed, factory)
        return self._plant(planned.plan, planned, seed, factory)

    def _leftovers(self, seed: int) -> int | None:
        return leftovers_of(self._scenario.temporaries, seed)

    def _plant(
        self, plan: Plant, planned: Planned, seed: int, factory: EngineFactory
    ) -> PlantStage:
        scenario = self._scenario
        setup = PlantSetup(
            seed,
            scenario.engine,
            {name: setup.conditions() for name, setup in scenario.drives.items()},
            {name: setup.memory() for name, setup in scenario.gateways.items()},
            cpu=CpuSettings(execution_ns=scenario.times.execution),
            bus=scenario.times.bus(),
            start_after_ns=scenario.times.start,
            program=planned.program,
            factory=factory,
            leftovers=self._leftovers(seed),
        )
        return PlantStage(build_plant(plan, planned.catalog, setup), planned.catalog)

    def _block(self, planned: Planned, seed: int, factory: EngineFactory) -> BlockStage:
        scenario = self._scenario
        kernel = Kernel()
        environment = StandaloneEnvironment(kernel)
        environment.services.leftovers = self._leftovers(seed)
        engine = factory(planned.program, environment, Limits())
        loaded = LoadedProgram(engine, Clock(kernel))
        for name, outputs in scenario.stubs.items():
            loaded.stub(name, stub_of(outputs, _value, lambda: kernel.now_ns))
        try:
            subject = subject_named(engine, scenario.block or "")
        except DiagnosticError as wrong:
            place = scenario.span_of("block")
            raise DiagnosticError(
                Diagnostic("FB8019", item.message, item.span, item.help)
                for item in at(place, wrong.diagnostics)
            ) from None
        return BlockStage(loaded, subject, scenario.cycle, planned.catalog)

    @property
    def _stubs(self) -> tuple[str, ...]:
        return tuple(self._scenario.stubs)

    def _sources(self) -> Sequence[Path]:
        """The files of the PLC text. Raises DiagnosticError FB8007 for each that is missing."""
        found: list[Diagnostic] = []
        paths: list[Path] = []
        for index, name in enumerate(self._scenario.sources):
            try:
                paths.append(self._file("sources", name, "PLC text", index))
            except DiagnosticError as missing:
                found += missing.diagnostics
        if found:
            raise DiagnosticError(found)
        return paths

    def _file(self, field: str, name: str, what: str, index: int | None = None) -> Path:
        path = Path(os.path.normpath(self._folder / name))
        if path.is_file():
            return path
        scenario = self._scenario
        place = scenario.span_of(field) if index is None else scenario.item_span_of(field, index)
        advice = "name it as seen from the folder of the scenario"
        message = f"there is no {what} {path.as_posix()}"
        raise DiagnosticError([Diagnostic("FB8007", message, place, advice)])


def _value(value: Scalar) -> Scalar:
    """A value of the file; 16#8090 and the like as the number."""
    if not isinstance(value, str) or "#" not in value:
        return value
    try:
        literal = read_literal(value)
    except BadLiteralError:
        return value
    return literal.value if literal.kind in (LiteralKind.INTEGER, LiteralKind.REAL) else value
