"""Runs commands in this process: what they print, and their exit status."""

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
