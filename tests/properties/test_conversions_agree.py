"""Random programs do the same in every dialect that they are converted to.

One program is run as it was written, and converted; all variables are compared after every call.
What a conversion refuses is no error; a test below shows that it does not refuse everything.
"""

from collections.abc import Sequence

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from portable_programs import portable_texts
from test_engines_agree import LIMITS, Scan, scans

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Program
from fbgen.lang.checker import check
from fbgen.lang.conversion import convert
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_generated
from fbgen.source import Source
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Value
from harness.engine.loading import engine_named
from harness.engine.variables import BlockInstance, plain
from harness.kernel import Kernel

WAYS = [
    ("tia", "step7"),
    ("tia", "iec"),
    ("tia", "twincat"),
    ("iec", "tia"),
    ("iec", "twincat"),
    ("twincat", "tia"),
    ("twincat", "step7"),
]
REFUSALS = {"FB3050", "FB3051", "FB3052", "FB3053"}
QUICK = settings(max_examples=15, suppress_health_check=list(HealthCheck))
SWEEP = settings(QUICK, max_examples=600)


def converted(text: str, source: str, target: str) -> tuple[str, Program, Program]:
    """The text in the other dialect, and both programs."""
    file = parse(Source("random", text), source)
    printed = [print_generated(one).text for one in convert([file], target)]
    again = [parse(Source("converted", one), target) for one in printed]
    return "\n".join(printed), check([file], source), check(again, target)


class Classic(StandaloneEnvironment):
    """An S7-300: in `tia` its timers alone go on in their calls only, as in the other dialects."""

    @property
    def classic(self) -> bool:
        return True


def history(program: Program, steps: Sequence[Scan]) -> list[str]:
    """What can be seen after each call; a fault ends it with its code."""
    kernel = Kernel()
    engine = engine_named("compiled")(program, Classic(kernel), LIMITS)
    block = BlockInstance(engine.instance("Outer"), program)
    seen = []
    for wait_ms, inputs in steps:
        kernel.run_for(wait_ms * 1_000_000)
        try:
            block(**inputs)
        except DiagnosticError as fault:
            return [*seen, fault.diagnostics[0].code]
        seen.append(repr(_without_memory(plain(block))))
    return seen


def _without_memory(values: Value) -> Value:
    """The variables; of F_TRIG, which may have become a block, what it has in every dialect.

    An in-out is left out of an instance: only S7 keeps its value there.
    """
    assert isinstance(values, dict)
    if isinstance(inner := values.get("instInner"), dict):
        inner = {name: value for name, value in inner.items() if name != "place"}
        values = {**values, "instInner": inner}
    edge = values.get("instFall")
    if not isinstance(edge, dict):
        return values
    return {**values, "instFall": {name: edge[name] for name in ("CLK", "Q")}}


def compare(source: str, target: str, data: st.DataObject, steps: Sequence[Scan]) -> None:
    text = data.draw(portable_texts(source, classic="step7" in (source, target)))
    try:
        _, before, after = converted(text, source, target)
    except DiagnosticError as refused:
        if {found.code for found in refused.diagnostics} <= REFUSALS:
            return
        raise
    assert history(before, steps) == history(after, steps)


@pytest.mark.parametrize(("source", "target"), WAYS)
@QUICK
@given(data=st.data(), steps=scans())
def test_converted_programs_do_the_same(
    source: str, target: str, data: st.DataObject, steps: list[Scan]
) -> None:
    compare(source, target, data, steps)


@pytest.mark.slow
@pytest.mark.parametrize(("source", "target"), WAYS)
@SWEEP
@given(data=st.data(), steps=scans())
def test_many_converted_programs_do_the_same(
    source: str, target: str, data: st.DataObject, steps: list[Scan]
) -> None:
    compare(source, target, data, steps)
