"""What goes over the line: one object for a run of characters, and what a receiver made of it."""

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from fbgen.dataclass import dataclass
from harness.line.serial_format import SerialFormat, marks_of_mismatch

if TYPE_CHECKING:
    from harness.kernel import Event
    from harness.line.medium import Pair, Port


class Transmission:
    """Characters that one sender puts on a pair without a gap.

    `data` is what was sent, from `start_ns` to `end_ns`. `sender` is None for bytes from outside,
    such as those that noise makes on an idle line. `heard` is what an undisturbed listener with
    the sender's setting received; it is there when the transmission is over.
    """

    __slots__ = (
        "data",
        "end_ns",
        "event",
        "format",
        "heard",
        "overlapping",
        "pair",
        "sender",
        "start_ns",
    )

    def __init__(
        self,
        pair: "Pair",
        sender: "Port | None",
        data: bytes,
        start_ns: int,
        format: SerialFormat,  # noqa: A002 - the field's term
    ) -> None:
        self.pair = pair
        self.sender = sender
        self.data = data
        self.start_ns = start_ns
        self.end_ns = start_ns + format.duration_ns(len(data))
        self.format = format
        self.overlapping: list[Transmission] = []
        self.heard: Reception | None = None
        self.event: Event | None = None

    @property
    def collided(self) -> bool:
        """True if somebody else sent on the same pair at the same time."""
        return bool(self.overlapping)

    def byte_start_ns(self, index: int) -> int:
        """Instant at which the start bit of the byte with this index begins."""
        return self.start_ns + self.format.duration_ns(index)

    def byte_end_ns(self, index: int) -> int:
        """Instant at which the last stop bit of the byte with this index is over."""
        return self.start_ns + self.format.duration_ns(index + 1)

    def bytes_within(self, start_ns: int, end_ns: int) -> range:
        """Indexes of the bytes that are on the line at any time from `start_ns` up to `end_ns`."""
        touched = [
            index
            for index in range(len(self.data))
            if self.byte_start_ns(index) < end_ns and self.byte_end_ns(index) > start_ns
        ]
        return range(touched[0], touched[-1] + 1) if touched else range(0)


@dataclass(slots=True)
class Reception:
    """A transmission as one receiver heard it, from `start_ns` to `end_ns`, which is now.

    All receivers get the same object and change nothing; it is not frozen as that takes time.

    `marks` has one byte per byte of `data`: 0, or `PARITY_ERROR` and `FRAMING_ERROR`; None says
    that all are clean. `positions` gives the index that each byte had in the transmission; None
    says that none was lost. `late_ns` is how much later it came than it was sent.
    """

    transmission: Transmission
    data: bytes
    start_ns: int
    end_ns: int
    marks: bytes | None = None
    positions: tuple[int, ...] | None = None
    late_ns: int = 0

    @property
    def byte_ns(self) -> int:
        """Time of one character as it was sent, rounded down to nanoseconds."""
        return self.transmission.format.duration_ns(1)

    def byte_end_ns(self, index: int) -> int:
        """Instant at which the byte with this index of `data` was complete."""
        sent = index if self.positions is None else self.positions[index]
        return self.transmission.byte_end_ns(sent) + self.late_ns

    def with_format(self, own: SerialFormat) -> "Reception":
        """The same for a receiver with another baud rate or parity."""
        mismatch = marks_of_mismatch(self.data, self.transmission.format, own)
        marks = mismatch
        if self.marks is not None:
            marks = bytes(a | b for a, b in zip(self.marks, mismatch, strict=True))
        return replace(self, marks=marks if any(marks) else None)

    def without(self, lost: frozenset[int]) -> "Reception":
        """The same for a receiver that missed the bytes with these indexes of the transmission."""
        positions = self.positions or tuple(range(len(self.data)))
        return self._chosen(at for at, position in enumerate(positions) if position not in lost)

    def with_doubled(self, doubled: frozenset[int]) -> "Reception":
        """The same for receivers that hear the bytes with these indexes twice."""
        times = [2 if at in doubled else 1 for at in range(len(self.data))]
        return self._chosen([at for at, count in enumerate(times) for _ in range(count)])

    def parted(self, first: int, late_ns: int) -> "tuple[Reception, Reception]":
        """The bytes before `first` as they came, and those from there on so much later."""
        indexes = range(len(self.data))
        early, late = self._chosen(indexes[:first]), self._chosen(indexes[first:])
        begin_ns = self.byte_end_ns(first) - self.byte_ns + late_ns
        return early, replace(
            late, start_ns=begin_ns, end_ns=self.end_ns + late_ns, late_ns=late_ns
        )

    def _chosen(self, indexes: Iterable[int]) -> "Reception":
        """Only the bytes with these indexes of `data`, in this order."""
        kept = tuple(indexes)
        positions = self.positions or tuple(range(len(self.data)))
        marks = None if self.marks is None else bytes(self.marks[at] for at in kept)
        return replace(
            self,
            data=bytes(self.data[at] for at in kept),
            marks=marks if marks and any(marks) else None,
            positions=tuple(positions[at] for at in kept),
        )
