"""What the seeds of a campaign depend on beside their number: the files, by their contents.

A log can only be gone on with while they are the same, or its seeds would do something else.
"""

from collections.abc import Iterable, Sequence
from hashlib import sha256
from pathlib import Path

from fbgen.catalog import OWN_SEQUENCES
from harness.scenario import SUFFIX, scenario_cases


def contents(files: Sequence[str]) -> dict[str, str]:
    """Each file with a digest of it: plant files, scenario files, and what they name."""
    every = dict.fromkeys(item for file in files for item in _with_named(Path(file)))
    return {path.as_posix(): sha256(path.read_bytes()).hexdigest()[:16] for path in every}


def _with_named(path: Path) -> Iterable[Path]:
    yield path
    if not path.name.endswith(SUFFIX):
        yield from _own_sequences(path)
        return
    case = scenario_cases(path)[0]
    yield from (path.parent / name for name in case.scenario.sources)
    if case.plant is not None:
        yield case.plant
        yield from _own_sequences(case.plant)


def _own_sequences(plant: Path) -> Iterable[Path]:
    return sorted((plant.parent / OWN_SEQUENCES).glob("*.y*ml"))
