"""`tools/environment.py`: does what is needed, once, and says what is wrong."""

import os
import shutil
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
PROJECT = """\
[build-system]
requires = ["a-build-backend-that-nobody-has"]
build-backend = "a_build_backend_that_nobody_has"
"""
INSTALL_NOTHING = """\
import runpy, sys
main = runpy.run_path("tools/environment.py")["main"]
main.__globals__["_install"] = lambda *_: True
sys.exit(main())
"""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project whose environment stands, and which cannot be installed without an index.

    The environment has the pip of the tests: one of its own takes seconds, and a fresh clone gets
    one from `make test`.
    """
    folder = tmp_path_factory.mktemp("project")
    made = folder / ".venv"
    venv.EnvBuilder().create(made)
    site = sysconfig.get_path("purelib", vars={"base": str(made)})
    (Path(site) / "tests.pth").write_text(sysconfig.get_path("purelib"), encoding="utf-8")
    (folder / "tools").mkdir()
    shutil.copy(ROOT / "tools" / "environment.py", folder / "tools")
    (folder / "pyproject.toml").write_text(PROJECT, encoding="utf-8")
    subprocess.run([sys.executable, "-c", INSTALL_NOTHING], check=True, cwd=folder)
    return folder


def set_up(project: Path) -> tuple[int, str]:
    """Run the script without any package index; exit status and what it says."""
    done = subprocess.run(
        [sys.executable, str(project / "tools" / "environment.py")],
        check=False,
        capture_output=True,
        text=True,
        env={**os.environ, "PIP_NO_INDEX": "1"},
    )
    return done.returncode, done.stderr


def test_what_is_installed_is_not_installed_again(project: Path) -> None:
    assert set_up(project) == (0, "")


def test_a_changed_project_is_installed_and_a_missing_index_is_said(project: Path) -> None:
    original = (project / "pyproject.toml").read_bytes()
    (project / "pyproject.toml").write_bytes(original + b"# changed\n")
    try:
        status, said = set_up(project)
    finally:
        (project / "pyproject.toml").write_bytes(original)
    assert status == 1
    assert "error: pip could not install what pyproject.toml names" in said
    assert "is PyPI reachable?" in said
    assert set_up(project) == (0, ""), "the stamp is that of the last success"
