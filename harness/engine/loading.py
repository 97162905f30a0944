"""From PLC text to a program that can be called: what a user of the harness works with.

    program = load_program(["conveyor.scl"])
    fb = program.instance("TOS_Telegram")
    fb(execute=True, invNo=11)
    program.clock.advance(ms=10)
    assert fb.busy

Errors in the text are raised together as `DiagnosticError`.
"""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from datetime import timedelta
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from fbgen.lang.checked import Program
from fbgen.source import Source
from harness.engine.environment import StandaloneEnvironment
from harness.engine.faults import engine_without_probes, unknown_engine
from harness.engine.interface import (
    Engine,
    EngineFactory,
    FunctionResult,
    Limits,
    Reference,
    Value,
)
from harness.engine.organization import ObSettings
from harness.engine.retentive import restore_retentive, retentive_values
from harness.engine.running import Running
from harness.engine.stubs import Stub
from harness.engine.variables import BlockInstance, Globals
from harness.kernel import NS_PER_MS, NS_PER_S, NS_PER_US, Kernel

if TYPE_CHECKING:
    from fbgen.lang.tags import ConstantValue, Tag
    from harness.engine.compiled import ProbeMaker

ENGINES = {
    "compiled": ("harness.engine.compiled", "CompiledEngine"),
    "reference": ("harness.engine.reference", "ReferenceEngine"),
}
"""What `load_program` takes as `engine`: module and name of the factory."""
PROBED = "compiled"
"""The engine that takes probes."""


def load_program(
    sources: Iterable[str | Path | Source],
    dialect: str = "tia",
    engine: str = "compiled",
    limits: Limits | None = None,
    db_numbers: Mapping[str, int] = MappingProxyType({}),
    *,
    constants: "Mapping[str, ConstantValue]" = MappingProxyType({}),
    tags: "Iterable[str | Path | Source | Tag]" = (),
    stubs: Mapping[str, Stub] = MappingProxyType({}),
    cycle_ms: float = 10,
    obs: ObSettings | None = None,
    probes: "Sequence[ProbeMaker]" = (),
    leftovers: int | None = None,
) -> "LoadedProgram":
    """Read, check and load PLC text on a controller without hardware.

    `sources` are files by their paths, or texts as `Source`, whose name tells XML from plain text.
    `db_numbers` has the numbers of data
    blocks by their names, for absolute addresses; `DB100` has its number in its name. `constants`
    are user constants by their names, `tags` PLC tags, or exported tag tables. `stubs` are Python
    functions for blocks that the program calls and that neither the files nor the harness have; see
    `harness.engine.stubs`. `cycle_ms` is the time from one program cycle to the next, `obs` has the
    numbers and periods of organization blocks; both matter to `start`, `scan` and `run_for` only.
    `probes` look on while the program runs, such as a `Coverage`; only "compiled" takes any.
    With `leftovers`, a seed, temporary variables hold anything before they are written, where the
    controller does not clear them; without they begin with their defaults.

    Raises one `DiagnosticError` with everything that is wrong in them.
    """
    factory = engine_named(engine, probes)
    program = read_program(sources, dialect, db_numbers, constants, tags, stubbed=tuple(stubs))
    kernel = Kernel()
    environment = StandaloneEnvironment(kernel)
    environment.services.leftovers = leftovers
    loaded = LoadedProgram(factory(program, environment, limits or Limits()), Clock(kernel))
    loaded.schedule(cycle_ms, obs)
    for name, stub in stubs.items():
        loaded.stub(name, stub)
    return loaded


def read_program(
    sources: Iterable[str | Path | Source],
    dialect: str = "tia",
    db_numbers: Mapping[str, int] = MappingProxyType({}),
    constants: "Mapping[str, ConstantValue]" = MappingProxyType({}),
    tags: "Iterable[str | Path | Source | Tag]" = (),
    *,
    stubbed: Collection[str] = (),
) -> Program:
    """The checked program that the files or texts make up; raises all errors together.

    `stubbed` are the names of blocks that a stub stands for.
    """
    from harness.engine import reading  # noqa: PLC0415 - a program from the cache needs no parser

    return reading.read_program(sources, dialect, db_numbers, constants, tags, stubbed=stubbed)


def engine_name(engine: Engine) -> str:
    """What an engine is called as `engine_named` takes it."""
    classes = {kind.__name__ for kind in type(engine).__mro__}
    return next(name for name, (_, factory) in ENGINES.items() if factory in classes)


def engine_named(name: str, probes: "Sequence[ProbeMaker]" = ()) -> EngineFactory:
    """The engine of that name; raises FB6025. An engine is only imported when it is used.

    `probes` look on while programs run. Raises FB6026 for an engine that takes none.
    """
    if name not in ENGINES:
        raise unknown_engine(name, tuple(ENGINES))
    if probes:
        if name != PROBED:
            raise engine_without_probes(name, PROBED)
        probing: Callable[[Sequence[ProbeMaker]], EngineFactory]
        probing = import_module("harness.engine.compiled.watching.probing").probing
        return probing(probes)
    module, factory_name = ENGINES[name]
    factory: EngineFactory = getattr(import_module(module), factory_name)
    return factory


class Clock:
    """The virtual clock of a loaded program."""

    __slots__ = ("_kernel",)

    def __init__(self, kernel: Kernel) -> None:
        self._kernel = kernel

    @property
    def kernel(self) -> Kernel:
        """What counts the time."""
        return self._kernel

    @property
    def now_ns(self) -> int:
        """The time since the start in nanoseconds."""
        return self._kernel.now_ns

    @property
    def now(self) -> timedelta:
        """The time since the start, to the microsecond."""
        return timedelta(microseconds=self._kernel.now_ns // NS_PER_US)

    def advance(self, *, s: float = 0, ms: float = 0, us: float = 0, ns: int = 0) -> None:
        """Let time pass; a negative duration lets none pass."""
        self._kernel.run_for(duration_ns(s=s, ms=ms, us=us, ns=ns))


def duration_ns(*, s: float = 0, ms: float = 0, us: float = 0, ns: int = 0) -> int:
    """A duration in nanoseconds; a negative one is none."""
    return max(round(s * NS_PER_S + ms * NS_PER_MS + us * NS_PER_US) + ns, 0)


class LoadedProgram:
    """A program on a controller of its own, with a clock that tests move by hand."""

    __slots__ = ("_cycle_ns", "_engine", "_obs", "_running", "clock", "globals")

    def __init__(self, engine: Engine, clock: Clock) -> None:
        self._engine = engine
        self._running: Running | None = None
        self.clock = clock
        self.schedule()
        self.globals = Globals(engine)

    @property
    def engine(self) -> Engine:
        """What runs it."""
        return self._engine

    @property
    def now(self) -> timedelta:
        """The time since the start, to the microsecond."""
        return self.clock.now

    def instance(self, block_name: str, /, **arguments: Value) -> BlockInstance:
        """A function block with its own state; raises FB6020 for an unknown name, FB6022.

        `arguments` are those of its FB_init; what is not given has its default.
        """
        return BlockInstance(self._engine.instance(block_name, arguments), self._engine.program)

    def call(self, function_name: str, /, **arguments: Value) -> Value | None:
        """The value of a FUNCTION; None if it has none."""
        return self._engine.call_function(function_name, arguments).value

    def call_with_outputs(self, function_name: str, /, **arguments: Value) -> FunctionResult:
        """The value of a FUNCTION together with its outputs and in-outs."""
        return self._engine.call_function(function_name, arguments)

    def variant(self, type_name: str, value: Value | None = None) -> Reference:
        """A variable of its own for a VARIANT, ANY or POINTER: `variant("INT", 5)`.

        The type is written as in VAR, with names of the program; `.value` is what a block has made
        of it. Raises FB6020, FB6021 and FB6024.
        """
        from harness.engine.type_texts import type_written  # noqa: PLC0415 - brings the parser

        return self._engine.new_variable(type_written(self._engine.program, type_name), value)

    def reference(self, path: str) -> Reference:
        """A variable of the program for a VARIANT, ANY or POINTER: `reference("DB.member[3]")`."""
        return self._engine.reference(path)

    def run(self, block_name: str) -> None:
        """One run of an organization block, a PROGRAM, or a FUNCTION without parameters."""
        self._engine.run_block(block_name)

    def stub(self, name: str, stub: Stub) -> None:
        """Let Python carry out the calls of a block that the harness has no model for.

        Later stubs of the same name replace earlier ones. What neither the controller nor the text
        knows has to be named when the program is loaded: `load_program(..., stubs={name: stub})`.
        """
        self._engine.environment.services.stubs.add(name, stub)

    def schedule(self, cycle_ms: float = 10, obs: ObSettings | None = None) -> None:
        """How the program runs by itself from the next `start` on."""
        self._cycle_ns = max(duration_ns(ms=cycle_ms), 1)
        self._obs = obs or ObSettings()
        self._running = None

    def start(self, *, warm: bool = True) -> None:
        """A restart: initial values but for what is remanent, and the start-up block.

        After a cold start (`warm=False`) nothing is kept. Raises DiagnosticError: FB7404 if nothing
        in the text runs by itself, FB7410, FB7411 for settings of organization blocks.
        """
        running = Running(self._engine, self.clock.kernel, self._cycle_ns, self._obs)
        running.start(warm=warm)
        self._running = running

    def scan(self, count: int = 1) -> None:
        """Let the program run by itself until its cycle has run `count` times more.

        Time passes up to the last run. The first call starts the program.
        """
        self._started().scan(count)

    def run_for(self, *, s: float = 0, ms: float = 0) -> None:
        """Let the program run by itself for some time: program cycle, tasks, cyclic interrupts.

        What is due at the very end belongs to the next call. The first call starts the program.
        """
        self._started().run_until(self.clock.now_ns + duration_ns(s=s, ms=ms))

    def _started(self) -> Running:
        if self._running is None:
            self.start()
        assert self._running is not None, "start makes it"
        return self._running

    def retentive(self) -> dict[str, Value]:
        """The values of all remanent variables by their paths: plain data, for JSON too."""
        return retentive_values(self._engine)

    def restore_retentive(self, values: Mapping[str, Value]) -> None:
        """Put back what `retentive` gave, in this program or in a later one.

        Raises DiagnosticError with all that does not fit the program; then nothing is changed.
        """
        restore_retentive(self._engine, values)

    def reset(self, *, warm: bool = False) -> None:
        """Initial values for everything global; after a warm start remanent variables stay."""
        self._engine.reset(warm)
