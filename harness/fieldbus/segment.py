"""A piece of PROFIBUS cable with slaves on it: bytes of a real master in, bytes of answers out."""

from collections.abc import Callable, Sequence

from fbgen.wire.fdl import Telegram, encode
from fbgen.wire.fdl_stream import TelegramReader
from harness.fieldbus.responder import Responder
from harness.fieldbus.slave import DpSlave
from harness.kernel import Kernel


class Segment:
    """Slaves that hear the same bytes; each answers what is for it.

    Functions in `taps` get every telegram that came, and what it was answered.
    """

    __slots__ = ("_reader", "_responders", "answers", "requests", "taps")

    def __init__(self, kernel: Kernel, slaves: Sequence[DpSlave]) -> None:
        self._reader = TelegramReader()
        self._responders = [Responder(kernel, slave) for slave in slaves]
        self.requests = self.answers = 0
        self.taps: list[Callable[[Telegram, Telegram | None], None]] = []

    @property
    def skipped(self) -> int:
        """Bytes that belonged to no telegram."""
        return self._reader.skipped

    def receive(self, data: bytes) -> bytes:
        """Bytes of the master; gives what the slaves answer at this instant."""
        return self._answer(self._reader.feed(data))

    def silence(self) -> bytes:
        """The line was idle for longer than inside of any telegram."""
        return self._answer(self._reader.silence())

    def _answer(self, telegrams: Sequence[Telegram]) -> bytes:
        sent = b""
        for telegram in telegrams:
            self.requests += 1
            answer = None
            for responder in self._responders:
                answer = responder.answer(telegram) or answer
            for tap in self.taps:
                tap(telegram, answer)
            if answer is not None:
                self.answers += 1
                sent += encode(answer)
        return sent
