"""Whole commands as fresh processes, in a warm environment.

Modules are compiled before and the files are in memory. Processor time is measured, so that other
work on the machine counts little; a process of one thread takes no longer on a quiet machine.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage

from bench.generate import plant_text
from bench.measuring import Figure, measure

_RUNS = 7
_LARGE_RUNS = 3
_SCENARIO = "tests/scenarios/ram_writes_spare_the_eeprom.scenario.yaml"
_ROOT = Path(__file__).parents[1]


def figures() -> Iterator[Figure]:
    """What a user waits for."""
    empty = measure("", lambda: [None for _ in range(1000)], per=1000)
    turn = empty.seconds / max(empty.turns, 1e-9)
    for arguments, limit in (
        (("--help",), "at most 0.3 s"),
        (("demo",), "at most 2 s"),
        (("decode", "tospbdp001.status", "9F00"), ""),
    ):
        best = min(_seconds(arguments, "off") for _ in range(_RUNS))
        yield Figure(f"fbgen {' '.join(arguments)}", best, best / turn, limit)
    with tempfile.TemporaryDirectory() as folder:
        for what, caches, limit in (
            ("nothing kept", ("off",) * _RUNS, ""),
            ("keeping all for the next", [f"{folder}/{run}" for run in range(_RUNS)], ""),
            ("everything kept", [f"{folder}/0"] * _RUNS, "at most 0.7 s"),
        ):
            best = min(_seconds(("test", _SCENARIO), cache) for cache in caches)
            yield Figure(f"fbgen test, one small scenario, {what}", best, best / turn, limit)
        sites = [("docs", "-o", f"{folder}/site_{run}") for run in range(_RUNS)]
        best = min(_seconds(arguments, "off") for arguments in sites)
        size = sum(path.stat().st_size for path in Path(folder, "site_0").iterdir())
        title = f"fbgen docs, whole catalogue, {size / 1_000_000:.1f} MB"
        yield Figure(title, best, best / turn, "at most 3 s, 5 MB")
        for gateways, limit in ((10, ""), (50, ""), (100, "at most 3 s")):
            plant = Path(folder) / f"plant_{gateways}.yaml"
            plant.write_text(plant_text(gateways), encoding="utf-8")
            best = min(
                _seconds(("generate", str(plant), "-o", f"{folder}/{gateways}_{run}"), "off")
                for run in range(_LARGE_RUNS)
            )
            shown = f"fbgen generate, {gateways} gateways with 5 drives each, all files"
            yield Figure(shown, best, best / turn, limit)


def _seconds(arguments: tuple[str, ...], cache: str) -> float:
    """Processor time of a command, with modules that were compiled before and this cache."""
    environment = {**os.environ, "FBGEN_CACHE": cache}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    before = getrusage(RUSAGE_CHILDREN)
    command = [sys.executable, "-m", "fbgen.cli", *arguments]
    quiet = subprocess.DEVNULL
    subprocess.run(command, check=True, stdout=quiet, stderr=quiet, cwd=_ROOT, env=environment)
    after = getrusage(RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
