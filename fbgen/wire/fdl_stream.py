"""Telegrams out of a stream of bytes, whatever else is in it.

A real station knows the beginning of a telegram by the 33 bit times of silence in front of it
(EN 50170 volume 2, part 4). A serial port hands bytes over in heaps, so silence is only known where
it is long: the reader takes what can be a telegram, and where something turns out to be none it
looks for the next one from the byte behind its first.
"""

from fbgen.wire.fdl import Telegram, TelegramError, decode, measure


class TelegramReader:
    """Collects bytes and gives whole telegrams. `skipped` counts bytes that belonged to none."""

    __slots__ = ("_buffer", "skipped")

    def __init__(self) -> None:
        self._buffer = bytearray()
        self.skipped = 0

    @property
    def waiting(self) -> bool:
        """True while the beginning of a telegram has come and not its end."""
        return bool(self._buffer)

    def feed(self, data: bytes) -> list[Telegram]:
        """More bytes; gives the telegrams that are complete with them."""
        self._buffer += data
        return self._take()

    def silence(self) -> list[Telegram]:
        """The line was idle: what has begun will not be completed.

        Gives the telegrams that stand behind a wrong beginning.
        """
        found: list[Telegram] = []
        while self._buffer:
            self._skip()
            found += self._take()
        return found

    def _take(self) -> list[Telegram]:
        found: list[Telegram] = []
        buffer = self._buffer
        while buffer:
            try:
                length = measure(buffer)
                if length is None or length > len(buffer):
                    break
                found.append(decode(buffer[:length]))
            except TelegramError:
                self._skip()
            else:
                del buffer[:length]
        return found

    def _skip(self) -> None:
        del self._buffer[0]
        self.skipped += 1
