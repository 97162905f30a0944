"""A sequence of the user's own with every kind of step: wait, branch, repeat, and abort."""

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest

from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source
from harness import LoadedProgram, load_program
from harness.engine.loading import ENGINES
from tests.unit.blocks.channel_bench import CYCLE_MS, Answer, ChannelBench, Request, echo
from tests.unit.blocks.programs import MANUAL_EXAMPLE

OWN = (Path(__file__).parent / "own_sequence.yaml").read_text("utf-8")
PULSE = ["FA01", "FA00 C400"]
STOPPED = "FA00 C000"


@cache
def with_own_sequence(engine: str) -> LoadedProgram:
    """The blocks of a plant that has the sequence."""
    with TemporaryDirectory() as folder:
        (Path(folder) / "sequences").mkdir()
        (Path(folder) / "sequences" / "pulse.yaml").write_text(OWN, "utf-8")
        catalog = load_catalog([Path(folder)])
    text = MANUAL_EXAMPLE.replace("[manual_example]", "[pulse]")
    files = generate(read_plant(Source("plant.yaml", text), catalog), catalog).files
    return load_program([Source(file.name, file.text) for file in files], engine=engine)


class Motor:
    """A drive that answers reads: it runs after some reads of its status."""

    def __init__(self) -> None:
        self.trip = 0
        self.status = [0x6000, 0x6400]
        self.frequency = [900, 950]
        self.current = 5050

    def __call__(self, request: Request) -> Answer:
        """What it says to a telegram."""
        match request.comno:
            case 0xFC90:
                return Answer(self.trip)
            case 0xFD01:
                return Answer(self.status.pop(0) if len(self.status) > 1 else self.status[0])
            case 0xFD00:
                return Answer(
                    self.frequency.pop(0) if len(self.frequency) > 1 else self.frequency[0]
                )
            case 0xFE03:
                return Answer(self.current)
        return echo(request)


@pytest.fixture(params=sorted(ENGINES))
def bench(request: pytest.FixtureRequest) -> ChannelBench:
    """A drive and its channel."""
    return ChannelBench(with_own_sequence(str(request.param)), Motor())


def started(bench: ChannelBench, **inputs: bool | float) -> Any:
    """The sequence after a rising edge of execute."""
    given = {"frequency": 10.0, "maxFrequency": 50.0, "often": False} | inputs
    sequence = bench.add("TOS_Seq_pulse", execute=True, invNo=11, **given)
    bench.cycle()
    return sequence


def asked(bench: ChannelBench) -> list[str]:
    """ComNos of all requests, with their data for the command word."""
    return [
        f"{request.comno:04X}" + (f" {request.data:04X}" if request.comno == 0xFA00 else "")
        for request in bench.requests
    ]


def test_every_step_in_its_turn(bench: ChannelBench) -> None:
    sequence = started(bench)
    bench.until(lambda: not sequence.busy)
    assert (sequence.done, sequence.status, sequence.current) == (True, 0, pytest.approx(50.5))
    waits = ["FD01", "FD01", "FD00", "FD00"]
    assert asked(bench) == ["FC90", *PULSE, *waits, STOPPED, "FE03"]


def test_a_branch_that_is_taken_leaves_steps_out(bench: ChannelBench) -> None:
    bench.answer.trip = 3  # type: ignore[attr-defined]
    sequence = started(bench)
    bench.until(lambda: not sequence.busy)
    assert (sequence.done, sequence.trip) == (True, 3)
    assert asked(bench) == ["FC90", STOPPED, "FE03"]


@pytest.mark.parametrize(("current", "last"), [(5050, "FE03"), (5049, "FA00 C800")])
def test_a_branch_compares_in_the_unit_of_the_result(
    bench: ChannelBench, current: int, last: str
) -> None:
    bench.answer.current = current  # type: ignore[attr-defined]
    sequence = started(bench)
    bench.until(lambda: not sequence.busy)
    assert asked(bench)[-1] == last


def test_a_repetition_runs_as_often_as_it_says_each_time(bench: ChannelBench) -> None:
    sequence = started(bench, often=True)
    for _ in range(2):
        bench.until(lambda: not sequence.busy)
        assert asked(bench).count("FA00 C400") == 3
        bench.requests.clear()
        bench.give(sequence, execute=False)
        bench.cycle()
        bench.give(sequence, execute=True)
        bench.cycle()


def test_a_wait_reads_in_its_rhythm_and_fails_after_its_limit(bench: ChannelBench) -> None:
    bench.answer.frequency = [1051]  # type: ignore[attr-defined]
    sequence = started(bench)
    bench.until(lambda: "FD00" in asked(bench))
    cycles = bench.until(lambda: not sequence.busy)
    assert (sequence.error, sequence.status, sequence.failedStep) == (True, 0x8407, 6)
    assert 1000 <= cycles * CYCLE_MS <= 1200
    assert 6 <= asked(bench).count("FD00") <= 9
    bench.answer.frequency = [1000]  # type: ignore[attr-defined]
    bench.give(sequence, execute=False)
    bench.cycle()
    bench.give(sequence, execute=True)
    bench.cycle()
    bench.until(lambda: not sequence.busy)
    assert sequence.done


def test_while_it_waits_others_may_use_the_channel(bench: ChannelBench) -> None:
    bench.answer.status = [0]  # type: ignore[attr-defined]
    sequence = started(bench)
    bench.until(lambda: "FD01" in asked(bench))
    bench.until(lambda: bench.user == 0)
    assert sequence.busy


@pytest.mark.parametrize("step", [1, 3, 4, 5, 6, 7])
def test_abort_ends_it_after_the_telegram_and_it_starts_anew(
    bench: ChannelBench, step: int
) -> None:
    sequence = started(bench)
    bench.until(lambda: sequence.stepNumber == step)
    sent = len(bench.requests)
    bench.give(sequence, abort=True)
    bench.until(lambda: not sequence.busy)
    assert (sequence.error, sequence.status) == (True, 0x8408)
    assert sequence.failedStep in (step, step + 1)
    assert bench.user == 0
    bench.cycles(20)
    assert len(bench.requests) <= sent + 1
    bench.give(sequence, abort=False, execute=False)
    bench.cycle()
    bench.requests.clear()
    bench.give(sequence, execute=True)
    bench.cycle()
    bench.until(lambda: not sequence.busy)
    assert sequence.done
    assert asked(bench)[0] == "FC90"
