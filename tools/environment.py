"""Sets up `.venv` with fbgen and everything its checks need. Every make target runs it first.

Needs nothing but a Python with `venv`, and PyPI. What need not be done is left alone, so that a
second run costs nothing and works offline: a stamp in `.venv` holds the hash of pyproject.toml
and the Python version for which everything was installed. Without make:
`python tools/environment.py` (Windows: `py tools/environment.py`).

It uses nothing that came after Python 3.7, so that an old one says what is wrong.
"""

import hashlib
import os
import subprocess
import sys
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
STAMP = VENV / "fbgen-installed"
OLDEST = (3, 11)
OLDEST_PIP = (22, 3)


def main() -> int:
    """Make `.venv` what pyproject.toml asks for; the exit status."""
    version = _this_version()
    if sys.version_info[:2] < OLDEST:
        return _fail(
            f"fbgen needs Python 3.11 or newer, {sys.executable} is {version}",
            "name a newer one, for example: make demo PYTHON=python3.12",
        )
    if _output(_python(), "-c", "import sys; print('%d.%d' % sys.version_info[:2])") != version:
        _say(f"making .venv with Python {version}")
        try:
            venv.EnvBuilder(with_pip=True, clear=True).create(VENV)
        except (OSError, subprocess.CalledProcessError) as problem:
            return _fail(
                f"python -m venv failed: {problem}",
                "on Debian and Ubuntu: apt-get install python3-venv",
            )
    digest = hashlib.sha256((ROOT / "pyproject.toml").read_bytes()).hexdigest()
    stamp = f"{digest} {version}"
    if STAMP.is_file() and STAMP.read_text(encoding="utf-8") == stamp:
        return 0
    _say("installing fbgen and what its checks need into .venv")
    if not _pip_is_new_enough() and not _install("--upgrade", "pip"):
        return _fail("pip could not be renewed", "is PyPI reachable?")
    if not _install("--editable", f"{ROOT}[dev]"):
        return _fail("pip could not install what pyproject.toml names", "is PyPI reachable?")
    STAMP.write_text(stamp, encoding="utf-8")
    return 0


def _python() -> str:
    folder, name = ("Scripts", "python.exe") if os.name == "nt" else ("bin", "python")
    return str(VENV / folder / name)


def _this_version() -> str:
    major, minor = sys.version_info[:2]
    return f"{major}.{minor}"


def _pip_is_new_enough() -> bool:
    """Whether pip can install an editable project; a venv without pip gets the bundled one."""
    version = _output(_python(), "-m", "pip", "--version")
    if not version:
        subprocess.run([_python(), "-m", "ensurepip", "--upgrade"], check=False)
        version = _output(_python(), "-m", "pip", "--version")
    numbers = version.split(" ")[1].split(".") if version else []
    return tuple(int(number) for number in numbers[:2] if number.isdigit()) >= OLDEST_PIP


def _install(*arguments: str) -> bool:
    """Packages as they are: Python compiles the few modules that are used when they are first."""
    options = ("--quiet", "--disable-pip-version-check", "--no-compile")
    command = [_python(), "-m", "pip", "install", *options]
    return subprocess.run([*command, *arguments], check=False).returncode == 0


def _output(*command: str) -> str:
    """What a command prints; empty if it is not there or fails."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""


def _say(text: str) -> None:
    print(f"== {text}", file=sys.stderr, flush=True)


def _fail(message: str, help_text: str) -> int:
    print(f"error: {message}\n  = help: {help_text}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
