"""How far a command is, on a terminal, once it has taken a while."""

import sys
from time import monotonic

_PATIENCE_S = 1.0
"""How long a person waits before progress is shown."""


class Progress:
    """Says on standard error how far it is, once it has taken a while."""

    def __init__(self, total: int, shown: bool) -> None:
        self._total = total
        self._done = 0
        self._shown = shown
        self._begin = monotonic()

    def step(self, what: str) -> None:
        """One more file, or the step behind the last one."""
        self._done += 1
        if self._shown and monotonic() - self._begin > _PATIENCE_S:
            sys.stderr.write(f"\r\x1b[K{self._done} of {self._total}: {what}")
            sys.stderr.flush()

    def end(self) -> None:
        """Clear the line."""
        if self._shown and monotonic() - self._begin > _PATIENCE_S:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
