"""Who wrote a value: the line of the PLC text, the instance, and the step of a scenario."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from fbgen.plant import changed, load_plant
from fbgen.source import Source, Span
from harness.engine.compiled import writers_probe
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc import Restart
from harness.trace import Place, Recorder, Trace, trace_text
from tests.unit.scenario.scenario_files import PLANT
from tests.unit.trace.recorded import CATALOG, START, one_drive, started, traced

ROOT = Path(__file__).parents[3]


def watched(**changes: object) -> Trace:
    plant = one_drive(probes=[writers_probe], **changes)
    recorder = plant.record()
    started(plant, recorder)
    return recorder.finish()


@pytest.fixture(scope="module")
def trace() -> Trace:
    """The drive is started, with who wrote what."""
    return watched()


def writers(trace: Trace, path: str) -> list[Place | None]:
    return [trace.writer_of(change) for change in trace.changes_of(path)]


def test_a_variable_names_the_line_and_the_instance(trace: Trace) -> None:
    first, *others = writers(trace, f"plc.{START}.busy")
    assert first is None
    for place in others:
        assert place is not None
        assert place.text == "busy => #drive.start_forward.busy,"
        assert place.file == "TOS_Sequences.scl"
        assert place.block == "TOS_Sequences"
        assert place.instance == "TOS_Gateway_gw1_DB.seq_pump"


def test_the_place_is_that_of_the_text(trace: Trace) -> None:
    plant = one_drive()
    place = writers(trace, f"plc.{START}.done")[-1]
    assert place is not None
    blocks = plant.cpu.engine.program.blocks
    source = blocks[place.block.casefold()].span.source
    assert source.name == place.file
    line = source.line_text(place.line)
    assert line.strip() == place.text
    assert line[place.column - 1 :].startswith("#")


def test_words_of_the_cyclic_data_name_who_wrote_what_went_there(trace: Trace) -> None:
    texts = {
        item: {place.text for place in writers(trace, f"gateway.gw1.{item}") if place is not None}
        for item in ("control", "trigger")
    }
    assert texts["control"] == {"#frameOut.control := #instHandshake.control;"}
    assert texts["trigger"] == {"#frameOut.trigger := #instTrigger.trigger;"}
    for telegram in trace.telegrams:
        place = trace.writer_of(telegram)
        assert place is not None
        assert place.instance == "TOS_Gateway_gw1_DB.instLine.instTelegram"


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"access": "process_image"}, "#statTrigger := #frameOut.trigger;"),
        ({"access": "dpxx_dat", "layout": "whole10"}, "#statRecordOut[2] := #frameOut.trigger;"),
        ({"layout": "doc9"}, "#frameOut.trigger := #instTrigger.trigger;"),
    ],
    ids=str,
)
def test_the_trigger_is_followed_in_every_way_of_access(
    changes: dict[str, object], text: str
) -> None:
    trace = watched(**changes)
    places = [trace.writer_of(one) for one in trace.changes_of("gateway.gw1.trigger") if one.value]
    assert len(places) > 1
    assert {None if place is None else place.text for place in places} == {text}


def test_the_step_of_a_scenario_is_a_writer(tmp_path: Path) -> None:
    text = f"set:\n  plc.{START}.frequency: 40.0\n"
    source = Source("start.scenario.yaml", text)
    plant = one_drive(probes=[writers_probe])
    recorder = plant.record()
    plant.start()
    plant.run_for(100 * NS_PER_MS)
    plant.cpu.engine.set_global(f"{START}.frequency", 40.0)
    recorder.variables_written({f"plc.{START}.frequency": Span(source, 7, 10)})
    place = writers(recorder.finish(), f"plc.{START}.frequency")[-1]
    assert place is not None
    assert (place.file, place.line, place.column) == ("start.scenario.yaml", 2, 3)


def test_a_restart_is_nobodys_write() -> None:
    plant = one_drive(probes=[writers_probe])
    recorder = plant.record()
    started(plant, recorder)
    plant.cpu.start(Restart.COLD)
    recorder.variables_written()
    assert writers(recorder.finish(), f"plc.{START}.done")[-1] is None


def test_zeros_of_a_master_in_clear_are_nobodys() -> None:
    plant = one_drive(probes=[writers_probe])
    recorder = plant.record()
    started(plant, recorder)
    plant.cpu.stop()
    plant.run_for(NS_PER_S)
    trace = recorder.finish()
    change = trace.changes_of("gateway.gw1.control")[-1]
    assert (change.value, change.writer) == (0, None)


def test_the_reference_engine_knows_no_writers(trace: Trace) -> None:
    other = traced(engine="reference")
    assert not other.writers
    assert {change.writer for change in other.changes} == {None}
    assert trace.writers


def test_looking_on_changes_nothing() -> None:
    def without_writers(trace: Trace) -> list[tuple[object, ...]]:
        return [(one.time_ns, one.channel, one.value) for one in trace.changes]

    def state(plant: Installation, recorder: Recorder) -> None:
        started(plant, recorder)
        plant.run_for(NS_PER_S)

    plain = traced(state)
    plant = one_drive(probes=[writers_probe])
    recorder = plant.record()
    state(plant, recorder)
    assert without_writers(recorder.finish()) == without_writers(plain)


PROGRAM = """
import sys
from tests.unit.trace.test_who_wrote import watched
from harness.trace import trace_text
sys.stdout.write(trace_text([watched()]))
"""


def test_the_trace_is_the_same_with_another_hash_seed(trace: Trace) -> None:
    """In processes of their own, as the seed belongs to the process."""
    texts = [
        subprocess.run(
            [sys.executable, "-c", PROGRAM],
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    ]
    assert texts[0] == texts[1] == trace_text([trace])


@pytest.mark.parametrize(
    ("dialect", "plc"), [("iec", "iec"), ("twincat", "twincat"), ("step7", "s7-400")]
)
def test_the_instance_is_named_in_every_dialect(dialect: str, plc: str) -> None:
    plan = load_plant(PLANT, CATALOG)
    gateway = plan.gateways[0].model_copy(update={"access": "process_image"})
    plan = changed(plan, CATALOG, dialect=dialect, plc=plc, gateways=(gateway,))
    plant = build_plant(plan, CATALOG, PlantSetup(probes=[writers_probe]))
    recorder = plant.record()
    started(plant, recorder)
    _, *places = writers(recorder.finish(), f"plc.{START}.busy")
    assert places
    for place in places:
        assert place is not None
        assert place.block in {"TOS_Sequences", "TOS_Gateway_gw1"}
        assert "gw1" in place.instance.casefold()
