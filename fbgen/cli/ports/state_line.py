"""One line on a terminal that says what served devices do."""

import sys
from time import monotonic
from typing import Protocol

from fbgen.cli.output import on_error_terminal

_SHOWN_EVERY_S = 0.5


class Served(Protocol):
    """What is served."""

    @property
    def state(self) -> str:
        """One line for a person."""


class StateLine:
    """Shows the state of what is served, a few times a second, and nothing but on a terminal."""

    def __init__(self, served: Served) -> None:
        self._served = served
        self._shown_s = 0.0
        self._is_shown = on_error_terminal()

    def look(self) -> bool:
        """Show the line anew if it is time to; serving always goes on."""
        now_s = monotonic()
        if self._is_shown and now_s - self._shown_s > _SHOWN_EVERY_S:
            self._shown_s = now_s
            sys.stderr.write(f"\r\x1b[K{self._served.state}")
            sys.stderr.flush()
        return True

    def end(self) -> None:
        """Clear the line."""
        if self._is_shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
