"""Work that is shared out: the order of its results, and that no process is left over."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError, error
from fbgen.workers import Workers, in_order

pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals")

PATIENCE_S = 20.0
SLEEPERS = """
import os, sys, time
from pathlib import Path
from fbgen.workers import in_order

def sleeping(folder):
    Path(folder, str(os.getpid())).touch()
    time.sleep(600)

if __name__ == "__main__":
    list(in_order(sleeping, [sys.argv[1]] * 4, 2))
"""


def its_process(number: int) -> int:
    """Who does it."""
    return os.getpid()


def slow_first(number: int) -> int:
    """The first one is done last."""
    time.sleep(0.2 if not number else 0.0)
    return number * number


def ended_by_the_system(number: int) -> int:
    """As if the memory was used up."""
    os.kill(os.getpid(), signal.SIGKILL)
    return number


def large(number: int) -> bytes:
    """Far more than a pipe holds."""
    return bytes([number]) * 20_000_000


def fails(number: int) -> int:
    """The last one fails."""
    if number == 3:
        raise error("FB9020", "number three")
    return number


def until(met: Callable[[], bool]) -> bool:
    """Whether it comes true in some seconds."""
    end = time.monotonic() + PATIENCE_S
    while not met() and time.monotonic() < end:
        time.sleep(0.05)
    return met()


def is_alive(process_id: int) -> bool:
    """Whether a process runs; one that has ended and was not fetched counts as ended."""
    try:
        state = Path(f"/proc/{process_id}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


@pytest.mark.parametrize("jobs", [1, 2, 9])
def test_results_come_in_the_order_of_the_work(jobs: int) -> None:
    assert list(in_order(slow_first, range(5), jobs)) == [0, 1, 4, 9, 16]


def test_who_stops_asking_is_not_kept_waiting() -> None:
    begin = time.monotonic()
    results = in_order(time.sleep, [0.0, 600.0, 600.0], 2)
    next(results)
    results.close()
    assert time.monotonic() - begin < PATIENCE_S


def test_who_stops_asking_does_not_wait_for_results_under_way() -> None:
    begin = time.monotonic()
    results = in_order(large, range(40), 2)
    assert next(results)[0] == 0
    results.close()
    assert time.monotonic() - begin < PATIENCE_S


def test_large_results_pass_work_that_waits() -> None:
    assert [result[-1] for result in in_order(large, range(6), 2)] == list(range(6))


def test_processes_are_kept_for_more_work() -> None:
    with Workers(2) as workers:
        before = set(workers.in_order(its_process, range(8)))
        stopped = workers.in_order(slow_first, range(9))
        next(stopped)
        stopped.close()
        assert list(workers.in_order(slow_first, range(4))) == [0, 1, 4, 9]
    assert len(before) <= 2
    assert os.getpid() not in before


def test_what_the_work_raises_is_raised_with_the_place_in_the_other_process() -> None:
    found: list[int] = []
    with pytest.raises(DiagnosticError, match="number three") as failure:
        found.extend(in_order(fails, range(9), 2))
    assert [item.code for item in failure.value.diagnostics] == ["FB9020"]
    assert "in fails" in "".join(failure.value.__notes__)


def test_a_process_that_the_system_ends_is_fb9020() -> None:
    with pytest.raises(DiagnosticError) as failure:
        list(in_order(ended_by_the_system, range(3), 2))
    assert [item.code for item in failure.value.diagnostics] == ["FB9020"]


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks into /proc")
@pytest.mark.usefixtures("usual_ctrl_c")
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_no_process_outlives_the_one_that_has_started_it(
    tmp_path: Path, how: signal.Signals
) -> None:
    script = tmp_path / "sleepers.py"
    script.write_text(SLEEPERS, "utf-8")
    folder = tmp_path / "started"
    folder.mkdir()
    with subprocess.Popen(
        [sys.executable, str(script), str(folder)],
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[3])},
        stderr=subprocess.DEVNULL,
    ) as process:
        assert until(lambda: len(list(folder.iterdir())) == 2)
        process.send_signal(how)
        process.wait(PATIENCE_S)
    workers = [int(path.name) for path in folder.iterdir()]
    assert until(lambda: not any(map(is_alive, workers)))
