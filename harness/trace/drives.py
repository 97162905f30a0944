"""What is recorded of an inverter: its commands, its state, and its analogue values.

Frequency and current are noted where something changes, while the frequency moves every 10 ms on a
grid that all drives share, and where its ramp ends. So lines between the changes of the frequency
are its course. They are rounded to what the inverter's own displays could show of them.
"""

from functools import partial

from harness.drives import Inverter
from harness.kernel import NS_PER_MS, Kernel
from harness.trace.log import ChangeLog
from harness.trace.model import Channel, ChannelKind
from harness.trace.words import WORD_BITS

SAMPLES_NS = 10 * NS_PER_MS
"""How often a moving drive is looked at."""
_HZ_DIGITS, _PERCENT_DIGITS = 3, 2
_LAST = 1 << 30
"""Priority of a sample: what else happens at that instant comes before it."""
_COMMAND, _STATUS = "command", "status"
"""Names of the words in the catalogue."""


class DriveWatch:
    """Looks at one inverter whenever something may have changed, and along its ramps."""

    def __init__(self, log: ChangeLog, kernel: Kernel, drive: Inverter) -> None:
        self._log = log
        self._kernel = kernel
        self._drive = drive
        self._sample_ns = -1
        add = self._add
        self._powered = add("powered", "has supply", "bool")
        self._running = add("running", "the output turns the motor", "bool")
        self._direction = add("direction", "direction of rotation", "text")
        self._tripped = add("tripped", "has tripped", "bool")
        self._trip = add("trip", "trip as the panel shows it", "text")
        self._set_point = add("set_point", "commanded frequency", "real", "Hz")
        self._frequency = add("frequency", "output frequency", "real", "Hz")
        self._current = add("current", "output current, of the rated one", "real", "%")
        self._command_number, self._command = self._word(_COMMAND)
        self._status_number, self._status = self._word(_STATUS)
        drive.observers.append(self.look)
        self.look()

    def _add(
        self, item: str, title: str, kind: ChannelKind, unit: str = "", word: str | None = None
    ) -> int:
        name = self._drive.name
        bits = WORD_BITS if kind == "word" else 0
        channel = Channel(f"drive.{name}.{item}", title, kind, "drive", name, unit, bits, word)
        return self._log.add(channel)

    def _word(self, name: str) -> tuple[int, int]:
        """The ComNo of a word and its channel."""
        series = self._drive.series
        comno = next(item for item in series.comnos if item.word == name)
        path, word = f"word.{comno.hex}", f"{series.id}.{name}"
        return comno.number, self._add(path, comno.title, "word", word=word)

    def look(self) -> None:
        """Note everything as it is now; while the frequency moves, look again in a while."""
        note, now_ns, drive = self._log.note, self._kernel.now_ns, self._drive
        note(self._powered, now_ns, drive.powered)
        note(self._running, now_ns, drive.running)
        note(self._direction, now_ns, drive.direction)
        note(self._tripped, now_ns, drive.tripped)
        note(self._trip, now_ns, drive.trip_display)
        note(self._set_point, now_ns, round(drive.set_point_hz, _HZ_DIGITS))
        note(self._frequency, now_ns, round(drive.frequency_hz, _HZ_DIGITS))
        note(self._current, now_ns, round(drive.current_percent, _PERCENT_DIGITS))
        for number, channel in (
            (self._command_number, self._command),
            (self._status_number, self._status),
        ):
            word = drive.monitors.read(number)
            assert word is not None, "every ComNo of the catalogue has a cell"
            note(channel, now_ns, word)
        self._look_again(now_ns)

    def _look_again(self, now_ns: int) -> None:
        end_ns = self._drive.moving_until_ns
        if end_ns <= now_ns:
            return
        next_ns = min(now_ns - now_ns % SAMPLES_NS + SAMPLES_NS, end_ns)
        if next_ns != self._sample_ns:
            self._sample_ns = next_ns
            self._kernel.at(next_ns, partial(self._sample, next_ns), _LAST)

    def _sample(self, due_ns: int) -> None:
        if due_ns == self._sample_ns:
            self._sample_ns = -1
            self.look()
