"""Replies on a line, and whether a value that the PLC has was answered to what it had asked."""

from collections.abc import Iterable

from fbgen.dataclass import dataclass
from fbgen.wire.toshiba import BROADCAST, TRIPPED_BIT, is_sealed
from harness.drives.communication import Communication
from harness.line import Transmission

_FRAME_BYTES = 8


@dataclass(frozen=True, slots=True)
class Answer:
    """A reply as it was on the line, to a telegram that the drive had heard at `heard_ns`."""

    start_ns: int
    end_ns: int
    telegram: bytes
    heard_ns: int


def answer_in(transmission: Transmission) -> Answer | None:
    """The reply that a transmission is, as a listener has heard it; None for what is none.

    Bytes that were disturbed and still have the right checksum are a reply, too, and so are those
    that no drive has sent: nobody can tell.
    """
    heard = transmission.heard.data if transmission.heard is not None else transmission.data
    if len(heard) != _FRAME_BYTES or not is_sealed(heard):
        return None
    start_ns, end_ns = transmission.start_ns, transmission.end_ns
    node = transmission.sender.node if transmission.sender is not None else None
    heard_ns = node.heard_ns if isinstance(node, Communication) else start_ns
    return Answer(start_ns, end_ns, heard[1:-1], heard_ns)


def belongs(
    answers: Iterable[Answer], telegram: bytes, data: int, since_ns: int, until_ns: int
) -> bool:
    """Whether one of these says `data` to this telegram, heard by a drive since `since_ns` and over
    at `until_ns`. A broadcast is answered by drive 00, with either number."""
    numbers = (0, BROADCAST) if telegram[0] == BROADCAST else telegram[:1]
    commands = (telegram[1], telegram[1] | TRIPPED_BIT)
    rest = telegram[2:4] + data.to_bytes(2, "big")
    return any(
        answer.heard_ns >= since_ns
        and answer.end_ns <= until_ns
        and answer.telegram[2:] == rest
        and answer.telegram[0] in numbers
        and answer.telegram[1] in commands
        for answer in answers
    )
