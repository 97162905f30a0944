"""What a run has left, as data: channels with their changes, frames, telegrams, marks.

Nothing here refers to the plant that ran: a trace can be written, sent and read where no plant is.
Times are nanoseconds of the plant's own clock, which begins at 0.
"""

from collections.abc import Mapping
from dataclasses import field
from typing import Literal, TypeAlias

from fbgen.dataclass import dataclass

ChannelKind: TypeAlias = Literal["bool", "word", "integer", "real", "text", "bytes"]
"""What values a channel has: bool, int, int, float, str, bytes. A `word` is a row of bits."""
Group: TypeAlias = Literal["cpu", "plc", "bus", "gateway", "line", "devicenet", "drive"]
"""What a channel belongs to, in the order in which people look at a plant."""
MarkKind: TypeAlias = Literal["step", "check", "fault"]
Verdict: TypeAlias = Literal["passed", "failed"]
FrameKind: TypeAlias = Literal[
    "request", "reply", "refusal", "heartbeat", "answer",
    "output", "input", "acknowledge", "fragment", "check", "unknown",
]  # fmt: skip
"""`answer` is what drives say to the gateway's heartbeat; `unknown` is no frame of the protocol. On
DeviceNet `output` and `input` are I/O messages as the PLC sees them, `check` is about MAC IDs."""
TraceValue: TypeAlias = bool | int | float | str | bytes


@dataclass(frozen=True, slots=True)
class Place:
    """A place in a source: PLC text, or the scenario file.

    Lines and columns count from 1; `text` is the line without blanks around it. In PLC text
    `block` is the block that the line stands in and `instance` which instance of it ran, such as
    `TOS_Gateway_gw1_DB.line`; empty for a block without one.
    """

    file: str
    line: int
    column: int
    text: str
    block: str = ""
    instance: str = ""


@dataclass(frozen=True, slots=True)
class WordField:
    """One bit or a row of bits of a word, by its name; `meanings` of values where it has some."""

    name: str
    title: str
    low: int
    high: int
    meanings: Mapping[int, str] = field(default_factory=dict)

    def extract(self, word: int) -> int:
        """The field's value in a word."""
        return word >> self.low & (1 << self.high - self.low + 1) - 1


@dataclass(frozen=True, slots=True)
class TraceWord:
    """How the bits of a word are called; `name` as the catalogue says, `tospbdp001.status`."""

    name: str
    title: str
    fields: tuple[WordField, ...]

    def decode(self, word: int) -> tuple[tuple[WordField, int], ...]:
        """Every field with its value, highest bit first."""
        return tuple((item, item.extract(word)) for item in self.fields)

    def describe(self, word: int) -> str:
        """The fields that are not 0, by name, with their values or what these mean."""
        shown = [_described(item, value) for item, value in self.decode(word) if value]
        return ", ".join(shown) or "no bit is set"


def _described(item: WordField, value: int) -> str:
    if meaning := item.meanings.get(value):
        return f"{item.name} ({meaning})"
    return item.name if item.low == item.high else f"{item.name}={value}"


@dataclass(frozen=True, slots=True)
class Channel:
    """Something that has one value at any time. `path` is how scenario files name it.

    A word has `bits`, and `word` names the `TraceWord` that decodes it; `owner` is the gateway, the
    line or the drive, for variables of the PLC the data block.
    """

    path: str
    title: str
    kind: ChannelKind
    group: Group
    owner: str = ""
    unit: str = ""
    bits: int = 0
    word: str | None = None


@dataclass(frozen=True, slots=True)
class Change:
    """A channel has another value from `time_ns` on. Every channel has one when recording begins.

    `channel` counts in `Trace.channels`. `writer` counts in `Trace.places`: the statement of the
    PLC or the step of the scenario that wrote the value; None where nobody knows.
    """

    time_ns: int
    channel: int
    value: TraceValue
    writer: int | None = None


@dataclass(frozen=True, slots=True)
class Frame:
    """Bytes on a line, from `start_ns` to `end_ns`.

    `line` is the name of the gateway, the serial line or the DeviceNet network. `sender` is the
    same for the gateway, the module of the PLC or the scanner, else a drive; None for bytes that
    come from outside. `data` is what was sent, `heard` what an undisturbed receiver got of it, None
    if that is the same. `meaning` is what the frame says, in words. `identifier` is that of CAN.
    """

    start_ns: int
    end_ns: int
    line: str
    sender: str | None
    to_drives: bool
    kind: FrameKind
    data: bytes
    heard: bytes | None = None
    damaged: bool = False
    collided: bool = False
    meaning: str = ""
    identifier: int | None = None


@dataclass(frozen=True, slots=True)
class Telegram:
    """One telegram of a gateway's cyclic data, without padding, with the reply to it.

    `sent_ns` is when the gateway got the trigger, `received_ns` when the master had the reply;
    `output` and `input` are the bytes. `writer` is what wrote the trigger byte.
    """

    sent_ns: int
    gateway: str
    output: bytes
    received_ns: int | None = None
    input: bytes | None = None
    meaning: str = ""
    writer: int | None = None


@dataclass(frozen=True, slots=True)
class Mark:
    """A step, a check or a fault of a scenario, from `start_ns` to `end_ns`.

    `end_ns` is None for what was still there when the run ended. `target` is what it happens to: a
    gateway, a drive, a path; empty for the whole plant. `place` counts in `Trace.places`.
    """

    start_ns: int
    kind: MarkKind
    title: str
    end_ns: int | None = None
    target: str = ""
    place: int | None = None
    verdict: Verdict | None = None


@dataclass(frozen=True, slots=True)
class Trace:
    """All that was recorded of one run.

    `scenario` is the scenario file as it was named, empty for a plant that a program ran. `writers`
    tells whether the run knew who writes what: only the compiled engine can tell. `start_ns` is
    when recording began, `end_ns` when it ended. What happened stands in the order of its time.
    """

    title: str
    scenario: str
    seed: int
    engine: str
    dialect: str
    writers: bool
    start_ns: int
    end_ns: int
    words: tuple[TraceWord, ...] = ()
    places: tuple[Place, ...] = ()
    channels: tuple[Channel, ...] = ()
    changes: tuple[Change, ...] = ()
    frames: tuple[Frame, ...] = ()
    telegrams: tuple[Telegram, ...] = ()
    marks: tuple[Mark, ...] = ()

    def channel(self, path: str) -> int:
        """The number of this channel, whatever the case; KeyError if there is none."""
        wanted = path.casefold()
        for number, channel in enumerate(self.channels):
            if channel.path.casefold() == wanted:
                return number
        raise KeyError(path)

    def changes_of(self, path: str) -> tuple[Change, ...]:
        """All changes of one channel, the first when recording began; KeyError if there is none."""
        number = self.channel(path)
        return tuple(change for change in self.changes if change.channel == number)

    def word(self, name: str) -> TraceWord:
        """The word of this name; KeyError if no channel has it."""
        for word in self.words:
            if word.name == name:
                return word
        raise KeyError(name)

    def writer_of(self, change: Change | Telegram) -> Place | None:
        """The place that wrote the value, if it is known."""
        return None if change.writer is None else self.places[change.writer]
