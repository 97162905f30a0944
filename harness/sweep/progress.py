"""How far a sweep is, how fast it goes and how long it will take, for whoever waits for it."""

from collections.abc import Callable
from time import monotonic
from typing import TextIO

from harness.sweep.running import Progressed

_TERMINAL_EVERY_S, _FILE_EVERY_S = 0.5, 60.0
_CLEAR = "\r\x1b[K"


class Progress:
    """On a terminal one line that changes, elsewhere a line now and then."""

    def __init__(self, stream: TextIO, clock: Callable[[], float] = monotonic) -> None:
        self._stream = stream
        self._clock = clock
        self._begin: tuple[float, int] | None = None
        self._shown = 0.0

    def show(self, how: Progressed) -> None:
        """Show it, if it was not shown just now."""
        now = self._clock()
        if self._begin is None:
            self._begin = now, how.done
            if how.done:
                self._stream.write(f"{how.done} of {how.planned} are in the journal\n")
        every_s = _TERMINAL_EVERY_S if self._stream.isatty() else _FILE_EVERY_S
        if now - self._shown < every_s and how.done < how.planned:
            return
        self._shown = now
        text = f"{how.done} of {how.planned}{self._speed(now, how)}"
        self._stream.write(f"{_CLEAR}{text}" if self._stream.isatty() else f"{text}\n")
        self._stream.flush()

    def end(self) -> None:
        """Nothing comes any more."""
        if self._stream.isatty():
            self._stream.write(_CLEAR)
            self._stream.flush()

    def _speed(self, now: float, how: Progressed) -> str:
        assert self._begin is not None
        begin, first = self._begin
        if how.done == first or now <= begin:
            return ""
        rate = (how.done - first) / (now - begin)
        left_s = (how.planned - how.done) / rate
        left = f"{left_s / 60:.0f} min" if left_s >= 100 else f"{left_s:.0f} s"
        return f", {rate:.1f} a second, {left} left"
