"""Programs whose results the standard fixes, run on every engine.

Each folder has one topic: the PLC text, and beside it the expected values with their source. The
values are written by hand from the standard and the controllers' manuals, never taken from a run.
"""

from collections.abc import Callable
from pathlib import Path

import pytest

from harness import LoadedProgram, load_program
from harness.engine.loading import ENGINES

_DIALECTS = {".scl": "tia", ".st": "iec", ".step7": "step7", ".twincat": "twincat"}


@pytest.fixture(params=sorted(ENGINES))
def engine_name(request: pytest.FixtureRequest) -> str:
    """Each engine in turn."""
    return str(request.param)


@pytest.fixture
def load(request: pytest.FixtureRequest, engine_name: str) -> Callable[[str], LoadedProgram]:
    """`load("name.scl")` runs the file beside the test; .scl is `tia`, .st `iec`."""
    folder = Path(request.path).parent

    def load_file(name: str) -> LoadedProgram:
        path = folder / name
        return load_program([path], dialect=_DIALECTS[path.suffix], engine=engine_name)

    return load_file
