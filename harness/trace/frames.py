"""Frames on the lines: who sent them, what arrived of them, what they say."""

from typing import Protocol

from harness.line import Line, Port, Transmission
from harness.trace.model import Frame, FrameKind


class Meanings(Protocol):
    """What knows the protocol of a line."""

    def of(self, data: bytes, to_drives: bool) -> tuple[FrameKind, str]:
        """What a frame is and says; they come in their order."""
        ...


class FrameWatch:
    """Notes each transmission of one line when it is over, the oldest first."""

    def __init__(
        self, line: Line, name: str, gateway: Port, drives: dict[Port, str], meanings: Meanings
    ) -> None:
        """`drives` are the names of the drives by their ports. `name` is that of the gateway, or of
        the serial line, whose `gateway` is the module of the PLC."""
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
