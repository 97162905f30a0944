"""A connection of the predefined set: its state, expected packet rate, and inactivity watchdog.

The watchdog waits four times the expected packet rate from the last message; before the first one
ten seconds at least (CIP; the DEV003Z-1 manual E6581737, pages 34 to 36, has rate and action).
"""

from collections.abc import Callable
from enum import IntEnum

from harness.kernel import NS_PER_MS, Event, Kernel

_PERIODS = 4
EXPLICIT, POLLED, COS = 1, 2, 4
"""Instances of the Connection object."""
CONNECTIONS = {"explicit": EXPLICIT, "polled": POLLED, "change_of_state": COS}
"""The same by their names; change of state is cyclic, too."""
_AFTER_MESSAGES = 1
"""A message that ends at the very instant of the time-out is in time."""


class ConnectionState(IntEnum):
    """The attribute `state`."""

    NON_EXISTENT = 0
    CONFIGURING = 1
    ESTABLISHED = 3
    TIMED_OUT = 4
    DEFERRED_DELETE = 5


class WatchdogAction(IntEnum):
    """What the watchdog does with the connection."""

    TIMED_OUT = 0
    AUTO_DELETE = 1
    DEFERRED_DELETE = 3


class Connection:
    """One instance of the Connection object. `expire` is called when its watchdog has waited.

    `produced_size` and `consumed_size` are fixed when it is made. `watched` is False for one that
    takes nothing, so that there is nothing to wait for. `idle`: no data have come, or the last
    message had none, as a master sends it that does not run.
    """

    __slots__ = (
        "_deadline_ns",
        "_expire",
        "_kernel",
        "_rate_ms",
        "_timer",
        "_unused_ns",
        "action",
        "consumed_size",
        "idle",
        "inhibit_ms",
        "instance",
        "produced_size",
        "state",
        "watched",
    )

    def __init__(
        self,
        kernel: Kernel,
        instance: int,
        sizes: tuple[int, int],
        unused_ns: int,
        expire: Callable[["Connection"], None],
    ) -> None:
        self._kernel = kernel
        self._expire = expire
        self._unused_ns = unused_ns
        self._rate_ms = 0
        self._deadline_ns: int | None = None
        self._timer: Event | None = None
        self.instance = instance
        self.produced_size, self.consumed_size = sizes
        self.inhibit_ms = 0
        self.watched = True
        self.idle = bool(self.consumed_size)
        explicit = instance == EXPLICIT
        self.action = WatchdogAction.AUTO_DELETE if explicit else WatchdogAction.TIMED_OUT
        self.state = ConnectionState.ESTABLISHED if explicit else ConnectionState.CONFIGURING

    @property
    def established(self) -> bool:
        """Whether data go over it."""
        return self.state is ConnectionState.ESTABLISHED

    @property
    def rate_ms(self) -> int:
        """The expected packet rate; 0 waits for ever."""
        return self._rate_ms

    def set_rate(self, rate_ms: int) -> None:
        """Set the expected packet rate. An I/O connection that is configured goes on by it."""
        self._rate_ms = rate_ms
        if self.state is ConnectionState.CONFIGURING:
            self.state = ConnectionState.ESTABLISHED
            self._wait(max(self._unused_ns, self._patience_ns()))
        elif self.established:
            self._wait(self._patience_ns())

    def message(self) -> None:
        """A message was taken: the watchdog begins anew, and nothing is deleted later."""
        if self.state is ConnectionState.DEFERRED_DELETE:
            self.state = ConnectionState.ESTABLISHED
        self._wait(self._patience_ns())

    def reset(self) -> bool:
        """The service Reset: a timed out connection is established again. False if it cannot be."""
        if self.state not in (ConnectionState.TIMED_OUT, ConnectionState.ESTABLISHED):
            return False
        self.state = ConnectionState.ESTABLISHED
        self._wait(self._patience_ns())
        return True

    def end(self) -> None:
        """It exists no more."""
        self.state = ConnectionState.NON_EXISTENT
        self._stop()

    def _patience_ns(self) -> int:
        return _PERIODS * self._rate_ms * NS_PER_MS

    def _wait(self, patience_ns: int) -> None:
        if not self._rate_ms or not self.watched:
            self._stop()
            return
        self._deadline_ns = self._kernel.now_ns + patience_ns
        if self._timer is not None and self._timer[0] > self._deadline_ns:
            self._stop_timer()
        if self._timer is None:
            self._timer = self._kernel.at(self._deadline_ns, self._look, _AFTER_MESSAGES)

    def _look(self) -> None:
        """One event runs behind the deadline instead of one for each message."""
        self._timer = None
        if self._deadline_ns is None:
            return
        if self._deadline_ns > self._kernel.now_ns:
            self._timer = self._kernel.at(self._deadline_ns, self._look, _AFTER_MESSAGES)
            return
        self._deadline_ns = None
        self.state = ConnectionState.TIMED_OUT
        self._expire(self)

    def _stop(self) -> None:
        self._deadline_ns = None
        self._stop_timer()

    def _stop_timer(self) -> None:
        if self._timer is not None:
            self._kernel.cancel(self._timer)
            self._timer = None
