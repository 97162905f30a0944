"""A loaded program from Python: calls, variables, clock, and what is said about mistakes."""

from datetime import timedelta
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program
from harness.engine.compiled import Probe

FILE = Path(__file__).with_name("engine_program.scl")


@pytest.fixture
def program() -> LoadedProgram:
    return load_program([FILE], engine="reference")


def test_a_block_is_called_by_keyword_and_its_variables_read_by_name(
    program: LoadedProgram,
) -> None:
    counter = program.instance("counter")
    counter(step=3)
    counter(STEP=4)
    assert (counter.count, counter.COUNT, counter["Count"]) == (7, 7, 7)
    assert counter.total == 10


def test_instances_have_their_own_state(program: LoadedProgram) -> None:
    first, second = program.instance("Counter"), program.instance("Counter")
    first()
    assert (first.count, second.count) == (1, 0)


def test_parts_are_reached_by_attributes_and_indices(program: LoadedProgram) -> None:
    counter = program.instance("Counter")
    counter.point.x = 5
    counter.point.names[2] = "two"
    counter.list[3] = 33
    counter["list[1]"] = 11
    counter['"odd name"'] = 8
    assert counter.point == {"x": 5, "y": 1.5, "names": ["", "two"]}
    assert list(counter.list) == [11, 0, 33]
    assert len(counter.list) == 3
    assert counter.list[3] == counter["list"][3] == counter["list[3]"] == 33
    assert counter['"odd name"'] == 8
    assert repr(counter.point.names) == "ARRAY[1..2] OF STRING[5] ['', 'two']"


def test_whole_structures_and_arrays_are_written_at_once(program: LoadedProgram) -> None:
    one, two = program.instance("Counter"), program.instance("Counter")
    one.list = [1, 2, 3]
    one.point = {"X": 7}
    two.list = one.list
    two.point = one.point
    one.list[1] = 100
    assert two.list == [1, 2, 3]
    assert two.point == {"x": 7, "y": 1.5, "names": ["", ""]}


def test_nested_instances_are_readable(program: LoadedProgram) -> None:
    counter = program.instance("Counter")
    counter()
    program.clock.advance(ms=10)
    counter()
    assert counter.delay == {"IN": True, "PT": 10, "Q": True, "ET": 10}
    assert counter.delay.q is True


def test_a_standard_block_can_be_an_instance_of_its_own(program: LoadedProgram) -> None:
    timer = program.instance("TON")
    timer(IN=True, pt=5)
    program.clock.advance(us=5000)
    timer()
    assert timer.Q is True


def test_a_function_is_called_with_its_inputs(program: LoadedProgram) -> None:
    assert program.call("Scale", hz=50.0) == 100.0
    assert program.call("scale", HZ=50, gain=0.5) == 25.0
    assert program.call("Tick") is None
    assert program.globals.Plant.point.x == 10


def test_organization_blocks_work_on_data_blocks(program: LoadedProgram) -> None:
    program.run("main")
    program.run("Main")
    assert program.globals.Plant.point.x == 11
    assert program.globals.CounterDb.count == 10
    assert program.globals["Plant.table[1, 2]"] == 5
    program.globals.Plant.table[0, 3] = -3
    assert program.globals.Plant.table == [1, 2, -3, 4, 5, 6]


def test_the_clock_is_moved_by_hand(program: LoadedProgram) -> None:
    program.clock.advance(s=1, ms=2, us=3, ns=4)
    program.clock.advance(ms=-5)
    assert program.clock.now_ns == 1_002_003_004
    assert program.now == timedelta(seconds=1, microseconds=2003)


def test_reset_brings_back_the_initial_values(program: LoadedProgram) -> None:
    program.run("Main")
    program.reset(warm=True)
    assert program.globals.CounterDb.total == 5
    assert program.globals.CounterDb.count == 0
    assert program.globals.CounterDb.delay.IN is False
    assert program.globals.Plant.point.x == 9
    program.reset()
    assert program.globals.CounterDb.total == 0
    assert program.globals.CounterDb.step == 5


def test_an_unknown_attribute_names_the_nearest_one(program: LoadedProgram) -> None:
    counter = program.instance("Counter")
    with pytest.raises(DiagnosticError, match=r"no variable of Counter 'cuont'.*\n.*'count'"):
        counter.cuont  # noqa: B018  (reading is what is tested)
    assert not hasattr(counter, "cuont")


MISTAKES = {
    "unknown block": ("FB6020", lambda program: program.instance("Cuonter")),
    "unknown input": ("FB6020", lambda program: program.instance("Counter")(stp=1)),
    "output as input": ("FB6020", lambda program: program.instance("Counter")(count=1)),
    "temporary": ("FB6020", lambda program: program.instance("Counter")["scratch"]),
    "unknown part": ("FB6020", lambda program: program.globals.Plant.point["z"]),
    "unknown part of a mapping": (
        "FB6020",
        lambda program: setattr(program.globals.Plant, "point", {"z": 1}),
    ),
    "unknown global": ("FB6020", lambda program: program.globals["Palnt"]),
    "too large": ("FB6021", lambda program: program.instance("Counter")(step=32768)),
    "bool as number": ("FB6021", lambda program: program.instance("Counter")(step=True)),
    "real as integer": ("FB6021", lambda program: program.instance("Counter")(step=1.0)),
    "number as bool": ("FB6021", lambda program: program.instance("TON")(IN=1)),
    "text as real": ("FB6021", lambda program: program.call("Scale", hz="50")),
    "huge real": ("FB6021", lambda program: program.call("Scale", hz=10**400)),
    "two characters": (
        "FB6021",
        lambda program: setattr(program.instance("Counter"), "letter", "ab"),
    ),
    "wide character": (
        "FB6021",
        lambda program: setattr(program.instance("Counter"), "letter", "Ω"),
    ),
    "long text": (
        "FB6021",
        lambda program: program.instance("Counter").point.names.__setitem__(1, "sixsix"),
    ),
    "short array": ("FB6021", lambda program: setattr(program.globals.Plant, "table", [1])),
    "scalar as array": ("FB6021", lambda program: setattr(program.globals.Plant, "table", 1)),
    "scalar as structure": ("FB6021", lambda program: setattr(program.globals.Plant, "point", 1)),
    "instance of a function": ("FB6022", lambda program: program.instance("Scale")),
    "call of a block": ("FB6022", lambda program: program.call("Counter")),
    "run of a block": ("FB6022", lambda program: program.run("Counter")),
    "call of a structure": ("FB6022", lambda program: program.engine.global_instance("Plant")),
    "run with parameters": ("FB6023", lambda program: program.run("Scale")),
    "part of a scalar": ("FB6024", lambda program: program.instance("Counter")["count.x"]),
    "index of a scalar": ("FB6024", lambda program: program.instance("Counter")["count[1]"]),
    "one index for two": ("FB6024", lambda program: program.globals.Plant.table[1]),
    "open bracket": ("FB6024", lambda program: program.instance("Counter")["list[1"]),
    "point at the end": ("FB6024", lambda program: program.instance("Counter")["point."]),
    "no path": ("FB6024", lambda program: program.instance("Counter")[""]),
    "index behind a point": ("FB6024", lambda program: program.instance("Counter")["list.[1]"]),
    "no name": ("FB6024", lambda program: program.instance("Counter")["[1]"]),
    "two names": ("FB6024", lambda program: program.instance("Counter")["point x"]),
    "index out of range": ("FB6002", lambda program: program.instance("Counter").list[4]),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_from_outside_is_a_diagnostic(program: LoadedProgram, mistake: str) -> None:
    code, action = MISTAKES[mistake]
    with pytest.raises(DiagnosticError) as failure:
        action(program)
    assert [diagnostic.code for diagnostic in failure.value.diagnostics] == [code]


def test_a_rejected_call_changes_nothing(program: LoadedProgram) -> None:
    timer = program.instance("TON")
    with pytest.raises(DiagnosticError):
        timer(IN=True, PT="long")
    assert timer.IN is False


def test_errors_of_all_files_come_together(tmp_path: Path) -> None:
    broken = Source("a.scl", "FUNCTION_BLOCK")
    other = Source("b.scl", "FUNCTION_BLOCK")
    with pytest.raises(DiagnosticError) as failure:
        load_program([broken, other, tmp_path / "missing.scl"], engine="reference")
    places = {
        diagnostic.span.source.name
        for diagnostic in failure.value.diagnostics
        if diagnostic.span is not None
    }
    assert places == {"a.scl", "b.scl"}
    assert "FB3014" in {diagnostic.code for diagnostic in failure.value.diagnostics}


def test_an_unknown_engine_is_reported() -> None:
    with pytest.raises(DiagnosticError, match=r"FB6025.*'fast'"):
        load_program([], engine="fast")


def test_only_the_compiled_engine_takes_probes() -> None:
    with pytest.raises(DiagnosticError, match=r"FB6026.*'reference'"):
        load_program([], engine="reference", probes=[lambda _: Probe(lambda *_: "", {})])
