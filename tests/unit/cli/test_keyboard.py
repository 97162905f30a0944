"""Single keys of a terminal, which is as it was afterwards."""

import io
import os
import sys
from contextlib import closing

import pytest

from fbgen.cli.ports.keyboard import NoKeyboard, keyboard


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")
def test_keys_come_at_once_and_the_terminal_is_as_it_was(monkeypatch: pytest.MonkeyPatch) -> None:
    import termios  # noqa: PLC0415 - there is none on Windows

    person, program = os.openpty()
    with closing(os.fdopen(program)) as stdin:
        monkeypatch.setattr(sys, "stdin", stdin)
        before = termios.tcgetattr(program)
        with keyboard() as keys:
            assert keys.keys() == ""
            os.write(person, b"d2q")
            assert keys.keys() == "d2q"
            assert keys.keys() == ""
            assert termios.tcgetattr(program) != before
        assert termios.tcgetattr(program) == before
    os.close(person)


def test_without_a_person_there_are_no_keys(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO("q"))
    with keyboard() as keys:
        assert isinstance(keys, NoKeyboard)
        assert keys.keys() == ""
