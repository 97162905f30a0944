"""The wheel works without the checkout, under each Python that fbgen promises to run on.

The wheel is installed into an environment of its own. Under the Python of the tests it finds its
dependencies where the tests find theirs; under another Python they come from PyPI, once, and are
kept in pytest's cache.
"""

import hashlib
import json
import sys
import sysconfig
import zipfile
from pathlib import Path

import pytest

from tests.other_pythons import find_python, install, make_environment, python_in, run

ROOT = Path(__file__).parents[3]
OTHER_PYTHONS = ("3.12", "3.13")
COMMANDS = [
    ["--version"],
    ["catalog", "list"],
    ["explain", "FB9003"],
    ["init", "."],
    ["generate", "plant.yaml", "-o", "out"],
    ["check", "out"],
]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    run(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder), cwd=ROOT)
    (built,) = folder.glob("fbgen-*.whl")
    return built


def test_the_wheel_carries_all_that_is_shipped(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    for source, target in (
        ("catalog", "catalog"),
        ("templates", "templates"),
        ("examples", "examples"),
        ("schemas", "schemas"),
        ("docs/reference/diagnostics", "diagnostics"),
    ):
        files = [path for path in (ROOT / source).rglob("*") if path.is_file()]
        assert files, source
        shipped = {
            f"fbgen/data/{target}/{path.relative_to(ROOT / source).as_posix()}" for path in files
        }
        assert shipped <= names
    assert {"fbgen/py.typed", "harness/py.typed"} <= names
    page = (ROOT / "harness" / "report" / "page").iterdir()
    assert {f"harness/report/page/{path.name}" for path in page} <= names
    assert not [name for name in names if name.startswith("tests/")]


def test_the_installed_wheel_works_outside_the_checkout(wheel: Path, tmp_path: Path) -> None:
    python = make_environment(Path(sys.executable), tmp_path / "env")
    site = _output(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))")
    (Path(site) / "tests.pth").write_text(sysconfig.get_path("purelib"), encoding="utf-8")
    install(python, str(wheel), "--no-deps")
    _try_all(python, tmp_path)


@pytest.mark.parametrize("version", OTHER_PYTHONS)
def test_the_installed_wheel_works_under_other_pythons(
    wheel: Path, tmp_path: Path, version: str, pytestconfig: pytest.Config
) -> None:
    interpreter = find_python(version)
    if interpreter is None:
        pytest.skip(f"there is no Python {version} on the path")
    assert pytestconfig.cache is not None
    needs = hashlib.sha256((ROOT / "pyproject.toml").read_bytes()).hexdigest()[:12]
    kept = pytestconfig.cache.mkdir(f"python{version}-{needs}")
    python = python_in(kept)
    if not python.exists():
        make_environment(interpreter, kept)
    if install(python, str(wheel), check=False) != 0:
        pytest.skip(f"PyPI cannot be reached for the dependencies under Python {version}")
    install(python, str(wheel), "--no-deps", "--force-reinstall")
    _try_all(python, tmp_path)


def _try_all(python: Path, folder: Path) -> None:
    """Run commands in a folder that has nothing to do with the checkout."""
    work = folder / "work"
    work.mkdir()
    shown = _output(python, "-c", "import fbgen, harness; print(fbgen.__file__)", cwd=work)
    assert not Path(shown).is_relative_to(ROOT / "fbgen")
    outputs = {
        " ".join(command): _output(python, "-m", "fbgen.cli", *command, cwd=work)
        for command in COMMANDS
    }
    assert outputs["--version"].startswith("fbgen ")
    assert "vf-s11" in outputs["catalog list"]
    assert (work / "out" / "fbgen-files.json").is_file()
    demo = json.loads(_output(python, "-m", "fbgen.cli", "demo", "--json", cwd=work))
    assert demo


def _output(*command: str | Path, cwd: Path | None = None) -> str:
    return run(*command, cwd=cwd).stdout.strip()
