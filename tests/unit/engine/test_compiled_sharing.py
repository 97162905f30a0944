"""One program on several controllers: its Python is written once, and nothing else is shared."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Program
from fbgen.source import Source
from harness.engine.compiled import CompiledEngine, Moment, Probe, translating
from harness.engine.compiled.watching.probes import Probed
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.loading import read_program
from harness.kernel import NS_PER_MS, Kernel

TEXT = """
TYPE "Pair" STRUCT one : INT; two : INT; END_STRUCT; END_TYPE
DATA_BLOCK "Plain" VAR count : INT; pair : "Pair"; timer : TON; END_VAR BEGIN END_DATA_BLOCK
DATA_BLOCK "Laid" { S7_Optimized_Access := 'FALSE' }
VAR count : INT; pair : "Pair"; END_VAR BEGIN END_DATA_BLOCK
FUNCTION_BLOCK "Count"
VAR_INPUT step : INT; END_VAR
VAR state : INT; word : WORD; bytes AT word : ARRAY[0..1] OF BYTE; END_VAR
BEGIN
    #state := #state + #step;
    #bytes[1] := #bytes[1] OR 1;
    "Plain".count := "Plain".count + #step;
    "Plain".pair.two := #state;
    "Laid".count := "Laid".count + #step;
    "Laid".pair.one := #state;
    "Plain".timer(IN := TRUE, PT := T#10ms);
    %MW0 := INT_TO_WORD("Plain".count);
END_FUNCTION_BLOCK
FUNCTION "Far" : VOID
BEGIN
    %QB100 := 1;
END_FUNCTION
"""


@pytest.fixture(scope="module")
def program() -> Program:
    return read_program([Source("source.scl", TEXT)])


def test_engines_of_one_program_have_variables_markers_and_clocks_of_their_own(
    program: Program,
) -> None:
    first, second = StandaloneEnvironment(Kernel()), StandaloneEnvironment(Kernel())
    one, other = CompiledEngine(program, first), CompiledEngine(program, second)
    counting, waiting = one.instance("Count"), other.instance("Count")
    counting.call({"step": 3})
    waiting.call({"step": 10})
    second.kernel.run_for(20 * NS_PER_MS)
    counting.call({"step": 3})
    waiting.call({"step": 0})
    places = ("Plain.count", "Plain.pair.two", "Laid.count", "Laid.pair.one", "Plain.timer.Q")
    assert [one.global_value(path) for path in places] == [6, 6, 6, 6, False]
    assert [other.global_value(path) for path in places] == [10, 10, 10, 10, True]
    assert (bytes(first.markers[:2]), bytes(second.markers[:2])) == (b"\0\6", b"\0\12")


def test_the_python_of_a_program_is_written_once(
    program: Program, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = CompiledEngine(program, StandaloneEnvironment())
    monkeypatch.delattr(translating, "write_block")
    second = CompiledEngine(program, StandaloneEnvironment())
    assert second.python_source("Count") == first.python_source("Count")


def test_a_controller_with_another_image_has_a_translation_of_its_own(program: Program) -> None:
    large, small = StandaloneEnvironment(), StandaloneEnvironment(image_bytes=16)
    CompiledEngine(program, large).call_function("Far", {})
    assert large.outputs[100] == 1
    with pytest.raises(DiagnosticError) as caught:
        CompiledEngine(program, small).call_function("Far", {})
    assert caught.value.diagnostics[0].code == "FB6010"


def test_a_probe_looks_at_its_own_engine_only(program: Program) -> None:
    seen: list[int] = []

    def line(node: Probed, moment: Moment) -> str:
        return "_seen.append(1)" if moment is Moment.BEFORE else ""

    plain = CompiledEngine(program, StandaloneEnvironment())
    probed = CompiledEngine(
        program, StandaloneEnvironment(), Limits(), Probe(line, {"_seen": seen})
    )
    after = CompiledEngine(program, StandaloneEnvironment())
    plain.instance("Count").call({"step": 1})
    after.instance("Count").call({"step": 1})
    assert seen == []
    probed.instance("Count").call({"step": 1})
    assert len(seen) == 8
