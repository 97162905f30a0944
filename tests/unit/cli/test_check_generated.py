"""`fbgen check` finds nothing to say about what fbgen generates, in no dialect."""

from pathlib import Path

import pytest

from fbgen.emit.writing import write_set
from tests.unit.artefacts.reading import TWO_GATEWAYS, generated
from tests.unit.cli.running import Fbgen

WITH_SEQUENCES = TWO_GATEWAYS.replace(
    "[start_forward, read_current]",
    "[start_forward, stop, set_frequency, read_current, fault_reset, check_parameters]",
)


@pytest.mark.parametrize("dialect", ["tia", "step7", "iec", "twincat", "plcopen"])
def test_what_is_generated_gives_no_warning(dialect: str, fbgen: Fbgen, tmp_path: Path) -> None:
    write_set(generated(WITH_SEQUENCES, dialect), tmp_path)
    run = fbgen("check", str(tmp_path))
    assert (run.status, run.out) == (0, "")
    assert "errors: 0, warnings: 0" in run.err
