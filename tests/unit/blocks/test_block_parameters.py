"""The parameters of drive and line reach what they are for."""

import pytest

from harness import LoadedProgram
from tests.unit.blocks.line_bench import TIMEOUT_MS, LineBench
from tests.unit.blocks.telegram_bench import READ
from tests.unit.blocks.test_block_drive import DriveBench


def set_points(bench: DriveBench) -> list[str]:
    return [word for word in bench.words() if word.startswith("FA01")]


@pytest.mark.parametrize(
    ("asked", "low", "high", "word"),
    [
        (40.0, 0.0, 30.0, "FA01 0BB8"),
        (40.0, 0.0, 45.0, "FA01 0FA0"),
        (5.0, 10.0, 45.0, "FA01 03E8"),
        (5.0, 10.0, 8.0, "FA01 0320"),
    ],
)
def test_a_set_point_stays_between_the_limits_and_the_upper_one_wins(
    asked: float, low: float, high: float, word: str, program: LoadedProgram
) -> None:
    bench = DriveBench(program)
    bench.parameters.update(minFrequency=low, maxFrequency=high)
    bench.control(run=True, frequency=asked)
    bench.cycles(20)
    assert set_points(bench)[-1] == word


@pytest.mark.parametrize(("band", "at_set_point"), [(0.5, False), (2.0, True)])
def test_the_band_says_when_a_drive_is_at_set_point(
    band: float, at_set_point: bool, program: LoadedProgram
) -> None:
    bench = DriveBench(program)
    bench.parameters.update(atSetpoint=band)
    bench.control(run=True, frequency=40.0)
    bench.drive["polled"].update(statusWord=0x0400, frequency=39.0)
    bench.cycles(20)
    assert bench.state["atSetpoint"] is at_set_point


@pytest.mark.parametrize(
    ("asked", "runs_at"), [(60.0, 45.0), (5.0, 10.0), (float("nan"), 0.0), (1e30, 45.0)]
)
def test_at_set_point_means_the_one_that_was_sent(
    asked: float, runs_at: float, program: LoadedProgram
) -> None:
    bench = DriveBench(program)
    bench.parameters.update(minFrequency=10.0, maxFrequency=45.0)
    bench.control(run=True, frequency=asked)
    bench.drive["polled"].update(statusWord=0x0400, frequency=runs_at)
    bench.cycles(20)
    assert bench.state["atSetpoint"]


@pytest.mark.parametrize("retries", [0, 1, 4])
def test_a_telegram_without_reply_is_repeated_as_often_as_the_line_says(
    retries: int, program: LoadedProgram
) -> None:
    bench = LineBench(program, retries=retries)
    bench.answers = lambda inv_no: False
    bench.ask(2, READ, 0xFE03)
    bench.cycles((retries + 2) * TIMEOUT_MS // 10 + 20)
    assert len(bench.sent) == retries + 1
