"""Frames on the lines: who sent them, what arrived of them, what they say."""

from harness.line import Line, Port, Transmission
from harness.trace.frame_meanings import FrameMeanings
from harness.trace.model import Frame


class FrameWatch:
    """Notes each transmission of one line when it is over, the oldest first."""

    def __init__(
        self, line: Line, name: str, gateway: Port, drives: dict[Port, str], meanings: FrameMeanings
    ) -> None:
        """`drives` are the names of the drives by their ports, `name` is the gateway's."""
        self.frames: list[Frame] = []
        self._line = line
        self._name = name
        self._gateway = gateway
        self._drives = drives
        self._meanings = meanings
        line.taps.append(self._heard)

    def _heard(self, transmission: Transmission) -> None:
        sender, sent = transmission.sender, transmission.data
        heard = transmission.heard
        to_drives = transmission.pair is self._line.master_pair and sender not in self._drives
        who = None
        if sender is not None:
            who = self._name if sender is self._gateway else self._drives.get(sender)
        kind, meaning = self._meanings.of(sent, to_drives)
        self.frames.append(
            Frame(
                transmission.start_ns,
                transmission.end_ns,
                self._name,
                who,
                to_drives,
                kind,
                sent,
                None if heard is None or heard.data == sent else heard.data,
                heard is not None and heard.marks is not None,
                transmission.collided,
                meaning,
            )
        )
