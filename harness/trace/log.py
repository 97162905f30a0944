"""Where the watchers of a run note what they see: a change is noted only if the value is another.

Values of channels are kept apart from what happened, so that one comparison decides.
"""

from math import isnan

from harness.trace.model import Change, Channel, TraceValue


class ChangeLog:
    """Channels with their changes, in the order in which they were noted."""

    __slots__ = ("_last", "changes", "channels")

    def __init__(self) -> None:
        self.channels: list[Channel] = []
        self.changes: list[Change] = []
        self._last: list[TraceValue | None] = []

    def add(self, channel: Channel) -> int:
        """A new channel, without a value so far; its number."""
        self.channels.append(channel)
        self._last.append(None)
        return len(self.channels) - 1

    def note(
        self, channel: int, time_ns: int, value: TraceValue, writer: int | None = None
    ) -> None:
        """The value of a channel at an instant."""
        last = self._last[channel]
        if value != last and not (_is_nan(value) and _is_nan(last)):
            self._last[channel] = value
            self.changes.append(Change(time_ns, channel, value, writer))


def _is_nan(value: TraceValue | None) -> bool:
    return isinstance(value, float) and isnan(value)
