"""What is recorded of the PLC's variables: their values whenever a scan's program is through."""

from collections.abc import Iterable, Mapping
from itertools import compress, count
from operator import is_not
from types import MappingProxyType

from harness.engine.interface import Engine
from harness.trace.log import ChangeLog
from harness.trace.model import Channel, TraceValue
from harness.trace.who_wrote import WhoWrote

NOBODY: Mapping[str, int | None] = MappingProxyType({})


class PlcWatch:
    """Compares the variables with what they were after the scan before.

    What a variable holds within a scan, and loses again, is not seen.
    """

    def __init__(
        self,
        log: ChangeLog,
        engine: Engine,
        channels: Iterable[Channel],
        now_ns: int,
        who: WhoWrote | None,
    ) -> None:
        self._log = log
        self._numbers = [log.add(channel) for channel in channels]
        paths = [log.channels[number].path.partition(".")[2] for number in self._numbers]
        self._read = engine.reader(paths)
        self._writers = None if who is None else [who.variable(path) for path in paths]
        self._before: tuple[TraceValue, ...] = ()
        self.look(now_ns)

    def look(self, time_ns: int, by: Mapping[str, int | None] = NOBODY) -> None:
        """Note what has changed since the last look.

        `by` are the places of those beside the program that wrote variables, by folded paths.
        """
        values = self._read()
        if values != self._before:
            self._before, before = values, self._before
            if not before:
                for number, value in zip(self._numbers, values, strict=True):
                    self._log.note(number, time_ns, value)
            else:
                for place in compress(count(), map(is_not, values, before)):
                    writer = self._writer(place, by)
                    self._log.note(self._numbers[place], time_ns, values[place], writer)

    def _writer(self, place: int, by: Mapping[str, int | None]) -> int | None:
        if by:
            path = self._log.channels[self._numbers[place]].path.casefold()
            if path in by:
                return by[path]
        writer = None if self._writers is None else self._writers[place]
        return None if writer is None else writer.of_change()
