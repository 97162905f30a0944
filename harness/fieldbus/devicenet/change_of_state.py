"""The connection of a slave for change of state or cyclic data, with acknowledgements.

Change of state: data go out when they differ from the last ones, not faster than the production
inhibit time allows, and when the expected packet rate has passed without. Cyclic: once in an
expected packet rate. A message that is not acknowledged is repeated, unless the master suppressed
that (DEV003Z-1 manual E6581737, page 43: Acknowledge Handler, a timer of 16 ms, one retry).
"""

from collections.abc import Callable

from harness.fieldbus.devicenet.connection import Connection
from harness.kernel import NS_PER_MS, Event, Kernel


class Producer:
    """Sends the data of one connection by itself while that is established.

    `timer_ms` and `retries` are those of the Acknowledge Handler.
    """

    __slots__ = (
        "_acknowledged",
        "_cyclic",
        "_data",
        "_kernel",
        "_produce",
        "_retry",
        "_sample_ns",
        "_send",
        "_sent_ns",
        "_suppressed",
        "_tick",
        "_tries",
        "connection",
        "retries",
        "timer_ms",
    )

    def __init__(
        self,
        kernel: Kernel,
        connection: Connection,
        sample_ns: int,
        produce: Callable[[], bytes],
        send: Callable[[bytes], None],
    ) -> None:
        self._kernel = kernel
        self._sample_ns = sample_ns
        self._produce = produce
        self._send = send
        self._cyclic = self._suppressed = False
        self._data: bytes | None = None
        self._sent_ns = 0
        self._acknowledged = True
        self._tries = 0
        self._retry: Event | None = None
        self._tick: Event | None = None
        self.connection = connection
        self.timer_ms = 16
        self.retries = 1

    def begin(self, *, cyclic: bool, suppressed: bool) -> None:
        """The connection was allocated, in one way or the other."""
        self._cyclic, self._suppressed = cyclic, suppressed
        self.connection.watched = not suppressed
        self._data = None
        self._look()

    def end(self) -> None:
        """The connection is gone."""
        for event in (self._retry, self._tick):
            if event is not None:
                self._kernel.cancel(event)
        self._retry = self._tick = None

    def acknowledge(self) -> None:
        """The master acknowledged a message."""
        if not self.connection.established or self._suppressed:
            return
        self.connection.message()
        if self._acknowledged:
            return
        self._acknowledged = True
        if self._retry is not None:
            self._kernel.cancel(self._retry)
            self._retry = None
        self._plan()

    def _look(self) -> None:
        """Look at the data once in a while, and send them if it is time to."""
        self._tick = None
        self._send_what_is_due()
        self._plan()

    def _plan(self) -> None:
        """Look again after the sampling time, or as soon as the expected packet rate is over."""
        if self._tick is not None:
            self._kernel.cancel(self._tick)
        wait_ns = self._sample_ns
        rate_ns = self.connection.rate_ms * NS_PER_MS
        if rate_ns and self._data is not None and self._acknowledged:
            left_ns = rate_ns - (self._kernel.now_ns - self._sent_ns)
            if left_ns > 0:
                wait_ns = min(wait_ns, left_ns)
        self._tick = self._kernel.after(wait_ns, self._look)

    def _send_what_is_due(self) -> None:
        if not self.connection.established or not self._acknowledged:
            return
        passed_ns = self._kernel.now_ns - self._sent_ns
        rate_ms = self.connection.rate_ms
        due = bool(rate_ms) and passed_ns >= rate_ms * NS_PER_MS
        if self._data is None:
            due = True
        elif not self._cyclic and passed_ns >= self.connection.inhibit_ms * NS_PER_MS:
            due = due or self._produce() != self._data
        if due:
            self._data = self._produce()
            self._tries = 0
            self._put()

    def _put(self) -> None:
        assert self._data is not None, "put only with data"
        self._sent_ns = self._kernel.now_ns
        self._tries += 1
        self._send(self._data)
        if not self._suppressed:
            self._acknowledged = False
            self._retry = self._kernel.after(self.timer_ms * NS_PER_MS, self._late)

    def _late(self) -> None:
        self._retry = None
        if self._tries <= self.retries and self.connection.established:
            self._put()
        else:
            self._acknowledged = True
