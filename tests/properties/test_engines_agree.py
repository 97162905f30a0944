"""Both engines run the same random programs, and every variable is compared after every call.

The engines share no arithmetic and no standard library, so a difference is an error in one of them.
"""

from collections.abc import Sequence

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from plc_programs import program_texts

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Program
from fbgen.source import Source
from harness.engine.compiled import ProbeMaker
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits, Value
from harness.engine.loading import engine_named, read_program
from harness.engine.variables import BlockInstance, plain
from harness.kernel import Kernel

LIMITS = Limits(loop_passes=2000)
Scan = tuple[int, dict[str, Value]]
"""Milliseconds to wait, and the inputs to give."""


def scans() -> st.SearchStrategy[list[Scan]]:
    inputs: dict[str, st.SearchStrategy[Value]] = {
        "inBool": st.booleans(),
        "inInt": st.integers(-32768, 32767),
        "inSint": st.integers(-128, 127),
        "inDint": st.integers(-(1 << 31), (1 << 31) - 1),
        "inUint": st.integers(0, 65535),
        "inWord": st.integers(0, 65535),
        "inDword": st.integers(0, (1 << 32) - 1),
        "inReal": st.floats(width=32),
        "inLreal": st.floats(),
        "inTime": st.integers(-100, 5000),
        "inString": st.text("abcxyz", max_size=6),
    }
    wait_ms = st.sampled_from([0, 1, 10, 999, 100_000])
    given_inputs = st.fixed_dictionaries({}, optional=inputs)
    return st.lists(st.tuples(wait_ms, given_inputs), min_size=1, max_size=4)


def history(
    engine_name: str, program: Program, steps: list[Scan], probes: Sequence[ProbeMaker] = ()
) -> list[str]:
    """What can be seen after each call; a fault ends it."""
    kernel = Kernel()
    engine = engine_named(engine_name, probes)(program, StandaloneEnvironment(kernel), LIMITS)
    block = BlockInstance(engine.instance("Outer"), program)
    seen = []
    for wait_ms, inputs in steps:
        kernel.run_for(wait_ms * 1_000_000)
        try:
            block(**inputs)
        except DiagnosticError as fault:
            return [*seen, str(fault)]
        seen.append(repr(plain(block)))
    return seen


def compare(dialect: str, data: st.DataObject, steps: list[Scan]) -> None:
    program = read_program([Source("random.scl", data.draw(program_texts(dialect)))], dialect)
    assert history("compiled", program, steps) == history("reference", program, steps)


QUICK = settings(max_examples=25, suppress_health_check=list(HealthCheck))
SWEEP = settings(QUICK, max_examples=1000)


@pytest.mark.parametrize("dialect", ["tia", "iec"])
@QUICK
@given(data=st.data(), steps=scans())
def test_engines_agree_on_random_programs(
    dialect: str, data: st.DataObject, steps: list[Scan]
) -> None:
    compare(dialect, data, steps)


@pytest.mark.slow
@pytest.mark.parametrize("dialect", ["tia", "iec"])
@SWEEP
@given(data=st.data(), steps=scans())
def test_engines_agree_on_many_random_programs(
    dialect: str, data: st.DataObject, steps: list[Scan]
) -> None:
    compare(dialect, data, steps)
