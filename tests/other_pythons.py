"""Environments of their own under other Pythons that are on the path."""

import os
import subprocess
import sys
from pathlib import Path


def find_python(version: str) -> Path | None:
    """The first Python of this version on the path that starts; a wrapper may be there for none."""
    name = f"python{version}" + (".exe" if os.name == "nt" else "")
    for folder in os.get_exec_path():
        candidate = Path(folder) / name
        if candidate.is_file() and _starts(candidate):
            return candidate
    return None


def make_environment(python: Path, folder: Path) -> Path:
    """An empty environment without pip; its Python."""
    run(python, "-m", "venv", "--without-pip", str(folder))
    return python_in(folder)


def python_in(folder: Path) -> Path:
    """The Python of an environment."""
    return folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def install(python: Path, *what: str, check: bool = True) -> int:
    """Install with the pip of the tests, so that no environment needs one of its own."""
    pip = [sys.executable, "-m", "pip", "--python", str(python)]
    quiet = ["--quiet", "--disable-pip-version-check", "--no-warn-script-location", "--no-compile"]
    return run(*pip, "install", *quiet, *what, check=check).returncode


def run(
    *command: str | Path, cwd: Path | None = None, check: bool = True
) -> subprocess.CompletedProcess[str]:
    """Run a command without what this process says to Python."""
    done = subprocess.run(
        [str(part) for part in command],
        check=False,
        capture_output=True,
        text=True,
        encoding="utf-8",
        cwd=cwd,
        env=clean_surroundings(),
    )
    assert done.returncode == 0 or not check, done.stdout + done.stderr
    return done


def clean_surroundings() -> dict[str, str]:
    """The environment variables without those for Python."""
    return {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}


def _starts(python: Path) -> bool:
    return subprocess.run([python, "-c", ""], check=False, capture_output=True).returncode == 0
