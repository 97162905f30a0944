"""Single keys of a person at the terminal, without waiting for them."""

import sys
from types import TracebackType
from typing import Any, Protocol, Self


class Keyboard(Protocol):
    """Where keys come from; used with `with`, so that the terminal is as it was afterwards."""

    def keys(self) -> str:
        """The keys pressed since this was asked the last time."""
        ...

    def __enter__(self) -> Self: ...

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None: ...


class NoKeyboard:
    """Nobody is there."""

    def keys(self) -> str:
        """As `Keyboard.keys`: none."""
        return ""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        return


class _Terminal(NoKeyboard):
    """Keys at once, by termios; the signals of Ctrl-C and Ctrl-Z stay."""

    def __init__(self) -> None:
        self._before: list[Any] = []

    def keys(self) -> str:
        import select

        ready, _, _ = select.select([sys.stdin], [], [], 0)
        if not ready:
            return ""
        import os

        return os.read(sys.stdin.fileno(), 64).decode("ascii", "ignore")

    def __enter__(self) -> Self:
        import termios
        import tty

        self._before = termios.tcgetattr(sys.stdin)
        tty.setcbreak(sys.stdin.fileno())
        return self

    def __exit__(self, *_: object) -> None:
        import termios

        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, self._before)


class _Console(NoKeyboard):
    """Keys of a Windows console."""

    def keys(self) -> str:
        import msvcrt

        console: Any = msvcrt
        found = ""
        while console.kbhit():
            found += console.getwch()
        return found


def keyboard() -> Keyboard:
    """The keyboard, if a person sits at standard input."""
    if not sys.stdin.isatty():
        return NoKeyboard()
    return _Console() if sys.platform == "win32" else _Terminal()
