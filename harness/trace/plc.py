"""What is recorded of the PLC's variables: their values whenever a scan's program is through."""

from collections.abc import Iterable

from harness.engine.interface import Engine
from harness.trace.log import ChangeLog
from harness.trace.model import Channel, TraceValue


class PlcWatch:
    """Compares the variables with what they were after the scan before.

    What a variable holds within a scan, and loses again, is not seen.
    """

    def __init__(
        self, log: ChangeLog, engine: Engine, channels: Iterable[Channel], now_ns: int
    ) -> None:
        self._log = log
        self._numbers = [log.add(channel) for channel in channels]
        paths = [log.channels[number].path.partition(".")[2] for number in self._numbers]
        self._read = engine.reader(paths)
        self._before: tuple[TraceValue, ...] = ()
        self.look(now_ns)

    def look(self, time_ns: int) -> None:
        """Note what has changed since the last look."""
        values = self._read()
        if values != self._before:
            self._before, before = values, self._before
            if not before:
                for number, value in zip(self._numbers, values, strict=True):
                    self._log.note(number, time_ns, value)
            else:
                for place, value in enumerate(values):
                    if value is not before[place]:
                        self._log.note(self._numbers[place], time_ns, value)
