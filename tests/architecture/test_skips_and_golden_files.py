"""What `tests/conftest.py` promises: skips that count, the list at the end, golden files."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.architecture.sources import ROOT

SKIPPING = """\
import pytest

def test_that_passes():
    pass

def test_without_a_browser():
    pytest.skip("there is no browser")

@pytest.mark.skipif(True, reason="there is no browser")
def test_marked():
    pass
"""
SKIPPING_MODULE = """\
import pytest

pytest.importorskip("a_package_that_nobody_has")
"""
EXPECTED_TO_FAIL = """\
import pytest

@pytest.mark.xfail(reason="known")
def test_known():
    assert False
"""


def run(
    folder: Path, text: str, *, require_all: str = "", options: tuple[str, ...] = ()
) -> tuple[int, str]:
    """Run one test file with the hooks of our conftest; exit status and output."""
    path = folder / "test_one.py"
    path.write_text(text, encoding="utf-8")
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT),
        "FBGEN_REQUIRE_ALL": require_all,
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
    }
    fixed = ["-p", "tests.conftest", "-p", "no:cacheprovider", "-c", os.devnull]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *fixed, f"--rootdir={folder}", *options, str(path)],
        check=False,
        capture_output=True,
        text=True,
        cwd=folder,
        env=environment,
    )
    return done.returncode, done.stdout


def test_a_run_ends_with_what_was_skipped_and_why(tmp_path: Path) -> None:
    status, output = run(tmp_path, SKIPPING)
    assert status == 0
    assert "2 x there is no browser" in output.splitlines()[-2]


def test_a_run_without_skips_says_so(tmp_path: Path) -> None:
    assert run(tmp_path, "def test_one(): pass")[1].splitlines()[-2] == "nothing was skipped"


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (SKIPPING, "must not be skipped here: there is no browser"),
        (SKIPPING_MODULE, "must not be skipped here: could not import"),
    ],
)
def test_a_skip_is_a_failure_where_all_is_required(tmp_path: Path, text: str, reason: str) -> None:
    status, output = run(tmp_path, text, require_all="1")
    assert status != 0
    assert reason in output


def test_a_test_that_is_expected_to_fail_is_no_skip(tmp_path: Path) -> None:
    assert run(tmp_path, EXPECTED_TO_FAIL, require_all="1")[0] == 0


GOLDEN = """\
def test_text(golden):
    golden("folder/text.scl", "a := 1;\\n")
"""


def test_a_golden_file_is_written_on_demand_only(tmp_path: Path) -> None:
    path = tmp_path / "tests" / "golden" / "folder" / "text.scl"
    status, output = run(tmp_path, GOLDEN)
    assert status == 1
    assert "there is no tests/golden/folder/text.scl" in output
    assert not path.exists()
    assert run(tmp_path, GOLDEN, options=("--update-golden",))[0] == 0
    assert path.read_bytes() == b"a := 1;\n"
    assert run(tmp_path, GOLDEN)[0] == 0


def test_a_golden_file_is_compared_byte_for_byte(tmp_path: Path) -> None:
    path = tmp_path / "tests" / "golden" / "folder" / "text.scl"
    path.parent.mkdir(parents=True)
    path.write_bytes(b"a := 1;\r\n")
    assert run(tmp_path, GOLDEN)[0] == 1
