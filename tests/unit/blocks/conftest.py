"""Blocks of the generated text on every engine."""

import pytest

from harness import LoadedProgram
from harness.engine.loading import ENGINES
from tests.unit.blocks.programs import ALL_SEQUENCES, loaded


@pytest.fixture(params=sorted(ENGINES))
def program(request: pytest.FixtureRequest) -> LoadedProgram:
    """The blocks of the plant with five drives, on each engine in turn."""
    return loaded(ALL_SEQUENCES, str(request.param))
