"""The compiled engine with probes that look on."""

from collections.abc import Sequence

from fbgen.lang.checked import Program
from harness.engine.compiled.engine import CompiledEngine
from harness.engine.compiled.watching.probes import ProbeMaker, together
from harness.engine.environment import Environment
from harness.engine.interface import EngineFactory, Limits


def probing(makers: Sequence[ProbeMaker]) -> EngineFactory:
    """Makes engines whose programs all these probes look at."""

    def make(program: Program, environment: Environment, limits: Limits) -> CompiledEngine:
        probe = together([maker(program) for maker in makers])
        return CompiledEngine(program, environment, limits, probe)

    return make
