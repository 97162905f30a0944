"""Runs commands in this process: what they print, and their exit status."""

import signal
from collections.abc import Iterator

import pytest

from fbgen.cli import main
from tests.unit.cli.running import Fbgen, Run


@pytest.fixture
def fbgen(capsys: pytest.CaptureFixture[str]) -> Fbgen:
    """Run a command with the given arguments."""

    def run(*arguments: str) -> Run:
        status = main(arguments)
        captured = capsys.readouterr()
        return Run(status, captured.out, captured.err)

    return run


@pytest.fixture
def usual_ctrl_c() -> Iterator[None]:
    """Ctrl+C reaches the processes of a test, also where pytest runs in the background itself.

    A shell starts background jobs with SIGINT ignored, and children inherit that.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
