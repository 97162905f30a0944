"""The virtual clock and its event queue. All times are integer nanoseconds.

Everything that happens in a simulated plant happens here, one event after the other. Two events at
the same instant run in the order of their priority and then in the order in which they were
scheduled, so that the same seed gives the same trace, byte for byte.
"""

from bisect import insort
from collections.abc import Callable
from random import Random
from typing import Any, TypeAlias

NS_PER_US = 1_000
NS_PER_MS = 1_000_000
NS_PER_S = 1_000_000_000
NEVER_NS = 1 << 63
"""Later than everything that happens."""
_ACTION = 3


Event: TypeAlias = list[Any]
"""A call that is due at an instant, as `at` gives it: to be given to `cancel`, no more.

The instant, the priority, the number in the sequence, and the action, which is None if it will not
be called. A plain list, because nothing is cheaper to make and to compare.
"""


class Kernel:
    """One virtual clock with the events that are due on it, and one seeded random source.

    The queue is a sorted list: a plant has some dozens of events at most, and then putting one in
    its place takes fewer comparisons than a heap needs to take one out.
    """

    __slots__ = ("_queue", "_sequence", "now_ns", "random", "seed")

    def __init__(self, seed: int = 0) -> None:
        self.now_ns = 0
        self.seed = seed
        self.random = Random(seed)
        self._queue: list[Event] = []
        self._sequence = 0

    def at(self, time_ns: int, action: Callable[[], None], priority: int = 0) -> Event:
        """Run `action` at an instant; in the past means now. Lower priorities run first."""
        if time_ns < self.now_ns:
            time_ns = self.now_ns
        self._sequence = sequence = self._sequence + 1
        event = [time_ns, priority, sequence, action]
        insort(self._queue, event)
        return event

    def after(self, delay_ns: int, action: Callable[[], None], priority: int = 0) -> Event:
        """Run `action` when `delay_ns` have passed."""
        return self.at(self.now_ns + delay_ns, action, priority)

    def cancel(self, event: Event) -> None:
        """Nothing happens at the instant any more; harmless on an event that has run."""
        event[_ACTION] = None

    def next_event_ns(self) -> int | None:
        """The instant of the next event that was not cancelled, or None."""
        queue = self._queue
        while queue and queue[0][_ACTION] is None:
            del queue[0]
        if not queue:
            return None
        next_ns: int = queue[0][0]
        return next_ns

    def run_until(self, time_ns: int) -> int:
        """Let everything up to and including `time_ns` happen; the clock then shows `time_ns`.

        Gives an instant before which nothing is due, `NEVER_NS` if nothing is. May be called from
        inside an event: that is how a hardware access in the middle of a scan lets the world go on
        up to its own instant. A call for an instant before now does nothing.
        """
        queue = self._queue
        while queue and queue[0][0] <= time_ns:
            # No event lies before now: `at` sees to it, and a run inside of an event leaves none.
            self.now_ns, _, _, action = queue.pop(0)
            if action is not None:
                action()
        if time_ns > self.now_ns:
            self.now_ns = time_ns
        next_ns: int = queue[0][0] if queue else NEVER_NS
        return next_ns

    def quiet_until_ns(self) -> int:
        """An instant before which nothing is due, `NEVER_NS` if nothing is."""
        queue = self._queue
        next_ns: int = queue[0][0] if queue else NEVER_NS
        return next_ns

    def run_for(self, duration_ns: int) -> None:
        """Let `duration_ns` pass."""
        self.run_until(self.now_ns + duration_ns)
