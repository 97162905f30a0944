"""One channel: finding the drive, exchanging data with it all the time, noticing that it is gone.

PBDP-110 manual #10407-1.100-000, sections 2 (AutoScan), 9 and 10. While the drive is searched for
or gone, the online bit and all other inputs of the channel are 0.

Inferred, because the manual does not say: a word of the master is written once for each change, and
again to a drive that was found again, then without fault reset, which would restart the drive for
ever; a drive that is gone is searched for with its last speed and parity every other time; that a
drive is tripped is seen in its replies, whose command is in lower case then, and is believed until
it says otherwise; the drive is online when everything was read once; a command goes before all
else, and between two other writes or accesses one value is read.
"""

from collections.abc import Callable
from functools import partial

from fbgen.wire.toshiba import Command
from harness.gateways.pbdp110.drive_link import Answer, DriveLink
from harness.gateways.pbdp110.parameter_channel import Access, ParameterChannel
from harness.gateways.pbdp110.settings import DriveFacts, PbdpSettings
from harness.kernel import Kernel
from harness.line import Line


class DriveChannel:
    """The interface's work for one drive. It stands still until `start`.

    `online` as in the status word, `tripped` as in the diagnosis, `values` are the cells read,
    in the order of the settings. `changed` is called when any of it may be other than before.
    `telegrams` counts the requests that were sent.
    """

    __slots__ = (
        "_changed",
        "_cursor",
        "_due_command",
        "_due_frequency",
        "_format",
        "_found",
        "_kernel",
        "_known",
        "_missed",
        "_outputs",
        "_read_next",
        "_running",
        "_scanned",
        "_settings",
        "_unread",
        "access",
        "link",
        "online",
        "telegrams",
        "tripped",
        "values",
    )

    def __init__(
        self,
        kernel: Kernel,
        settings: PbdpSettings,
        line: Line,
        changed: Callable[[], None],
        facts: DriveFacts,
    ) -> None:
        self._kernel = kernel
        self._settings = settings
        self._changed = changed
        self._format = self._scanned = 0
        self._known: int | None = None
        self._running = False
        self.telegrams = 0
        self.tripped = False
        self.link = DriveLink(
            kernel, line, settings.formats[0], settings.processing_ns, settings.reply_timeout_ns
        )
        self.access = ParameterChannel(settings.access, facts, dict(settings.local))
        self._forget()

    def _forget(self) -> None:
        self._outputs: tuple[int, int] | None = None
        self._lose()

    def _lose(self) -> None:
        self.online = self._found = self._read_next = False
        self._due_command: int | None = None
        self._due_frequency: int | None = None
        self._cursor = self._missed = 0
        self.values = [0] * len(self._settings.inputs)
        self._unread = set(range(len(self.values)))

    # --- what the interface does --------------------------------------------------------------

    def start(self) -> None:
        """Supply has come: search for the drive."""
        self._running = True
        self._next()

    def stop(self) -> None:
        """Supply has gone: silence, everything is forgotten."""
        self._running = False
        self.link.stop()
        self.access.reset()
        self.tripped = False
        self.telegrams = self._format = self._scanned = 0
        self._known = None
        self._forget()

    def command(self, command: int, frequency: int) -> None:
        """The master's command and set-point; the first ones since power-on are written, too."""
        before = self._outputs
        self._outputs = (command, frequency)
        if before is None or command != before[0]:
            self._due_command = command
        if before is None or frequency != before[1]:
            self._due_frequency = frequency

    def to_local(self) -> None:
        """Let the drive follow its own terminals and panel, if it was commanded from here."""
        if self._outputs is not None:
            self._outputs = (0, self._outputs[1])
            self._due_command = 0

    def respond(self) -> None:
        """The parameter channel may have something that needs no drive."""
        self._kernel.after(self._settings.processing_ns, self._answer_alone)

    def _answer_alone(self) -> None:
        if self._running and self.access.answer_alone():
            self._changed()

    # --- the cycle ----------------------------------------------------------------------------

    def _next(self) -> None:
        if not self._running:
            return
        settings = self._settings
        if not self._found:
            self.link.port.format = settings.formats[self._format]
            self._ask(Command.R, settings.inputs[0], 0, self._searched)
            return
        if self._due_command is not None:
            command = self._due_command
            self._ask(Command.P, settings.command, command, partial(self._commanded, command))
        elif not self._read_next and self._due_frequency is not None:
            hz = self._due_frequency
            self._ask(Command.P, settings.frequency, hz, partial(self._frequency_set, hz))
        elif not self._read_next and self.online and self.access.wanted is not None:
            self._begin_access(self.access.wanted)
        else:
            self._read_next = False
            self._ask(Command.R, settings.inputs[self._cursor], 0, self._was_read)

    def _begin_access(self, access: Access) -> None:
        codes = self._settings.access
        commands = {
            codes.read: Command.R,
            codes.write_ram: Command.P,
            codes.write_eeprom: Command.W,
        }
        done = partial(self._accessed, access)
        self._ask(commands[access.request], access.number, access.data, done)

    def _ask(
        self, command: Command, number: int, data: int, done: Callable[[Answer], None]
    ) -> None:
        self.telegrams += 1
        self.link.ask(command, number, data, done)

    def _searched(self, answer: Answer) -> None:
        if answer is None:
            self._try_another_format()
        else:
            self._found = True
            self._known = self._format
            self._missed = 0
            if self._outputs is not None:
                command, self._due_frequency = self._outputs
                self._due_command = command & ~self._settings.reset_mask
        self._next()

    def _try_another_format(self) -> None:
        """In turn; of a drive that was there before, its own every other time."""
        if self._known is not None and self._format != self._known:
            self._format = self._known
            return
        self._scanned = (self._scanned + 1) % len(self._settings.formats)
        self._format = self._scanned

    def _commanded(self, command: int, answer: Answer) -> None:
        self._read_next = True
        resets = command & self._settings.reset_mask
        if (answer is not None or resets) and self._due_command == command:
            self._due_command = None
        self._heard(answer)

    def _frequency_set(self, frequency: int, answer: Answer) -> None:
        self._read_next = True
        if answer is not None and self._due_frequency == frequency:
            self._due_frequency = None  # refused or not: the drive keeps what it has
        self._heard(answer)

    def _accessed(self, access: Access, answer: Answer) -> None:
        self._read_next = True
        self.access.answered(access, answer)
        self._heard(answer)

    def _was_read(self, answer: Answer) -> None:
        if answer is not None:
            at = self._cursor
            self._cursor = (at + 1) % len(self.values)
            self._unread.discard(at)
            data = getattr(answer, "data", 0)
            self.values[at] = data
            if not self._unread:
                self.online = True
        self._heard(answer)

    def _heard(self, answer: Answer) -> None:
        if answer is None:
            self._missed += 1
            if self._missed >= self._settings.attempts:
                self._gone()
        else:
            self._missed = 0
            self.tripped = answer.tripped
        self._changed()
        self._next()

    def _gone(self) -> None:
        wanted = self.access.wanted
        self._lose()
        if wanted is not None:
            self.access.answered(wanted, None)
