"""`tools/checks.py`: the tests and mypy at the same time, and either one can fail."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

TOOL = Path(__file__).parents[3] / "tools" / "checks.py"
MYPY = "import sys; print('types looked at'); sys.exit({})"
PYTEST = "import sys; print('tested', *sys.argv[1:], flush=True); sys.exit({})"


@pytest.mark.parametrize(
    ("types", "tests", "status"), [(0, 0, 0), (1, 0, 1), (0, 2, 2)], ids=["both", "mypy", "pytest"]
)
def test_what_mypy_says_comes_last_and_both_must_pass(
    tmp_path: Path, types: int, tests: int, status: int
) -> None:
    (tmp_path / "mypy.py").write_text(MYPY.format(types), encoding="utf-8")
    (tmp_path / "pytest.py").write_text(PYTEST.format(tests), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, str(TOOL), "-n", "3"],
        check=False,
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert done.stdout.splitlines() == ["tested -n 3", "== mypy", "types looked at"]
    assert done.returncode == status
