"""The same seed gives the same trace everywhere, and Ctrl-C at the command leaves a log."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from fbgen.cli import INTERRUPTED

ROOT = Path(__file__).parents[4]
ONE = ROOT / "tests" / "scenarios" / "one_drive.yaml"
TRACE = f"""
from hashlib import sha256
from pathlib import Path

from fbgen.catalog import load_catalog
from harness.scenario import prepare
from harness.trace.writing import trace_text
from harness.verify.campaign.files import campaign_settings
from harness.verify.campaign.trials import case_from, drawn

plant = Path({ONE.as_posix()!r})
entry = drawn(campaign_settings([plant], []), 3)
entry["steps"] = entry["steps"][:12]
case = case_from(entry, plant)
run = prepare(case, load_catalog(), 3)
recorder = run.installation.record()
run.run()
text = trace_text([recorder.finish(case.name)])
print(len(text), sha256(text.encode()).hexdigest())
"""


def begun(arguments: list[str], hash_seed: str) -> "subprocess.Popen[str]":
    environment = os.environ | {"PYTHONHASHSEED": hash_seed, "PYTHONPATH": str(ROOT)}
    return subprocess.Popen(
        [sys.executable, *arguments],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_a_seed_gives_the_same_trace_in_every_process() -> None:
    processes = [begun(["-c", TRACE], hash_seed) for hash_seed in ("1", "2")]
    said = [process.communicate(timeout=120) for process in processes]
    assert [process.returncode for process in processes] == [0, 0], said
    assert said[0][0] == said[1][0]
    assert int(said[0][0].split()[0]) > 10_000


@pytest.mark.skipif(os.name != "posix", reason="Ctrl+C is sent to the process")
@pytest.mark.usefixtures("usual_ctrl_c")
def test_ctrl_c_ends_all_processes_and_the_log_has_what_was_tried(tmp_path: Path) -> None:
    out = tmp_path / "out"
    command = ["-m", "fbgen.cli", "campaign", str(ONE), "--seeds", "32", "--workers", "2"]
    process = begun([*command, "-o", str(out)], "0")
    log = out / "log.jsonl"
    while not log.exists() or log.read_text("utf-8").count("\n") < 2:
        assert process.poll() is None, "it ended before it was stopped"
        time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert process.returncode == INTERRUPTED
    assert f"go on with: --resume {log.as_posix()}" in said
    assert "Traceback" not in said
