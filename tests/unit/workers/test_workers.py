"""Work that is shared out: the order of its results, and that no process is left over."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.workers import in_order

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


def slow_first(number: int) -> int:
    """The first one is done last."""
    time.sleep(0.2 if not number else 0.0)
    return number * number


def ended_by_the_system(number: int) -> int:
    """As if the memory was used up."""
    os.kill(os.getpid(), signal.SIGKILL)
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
