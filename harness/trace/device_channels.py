"""The channels of a device on the bus: named alike, whatever the device is."""

from collections.abc import Sequence

from harness.trace.log import ChangeLog
from harness.trace.model import Channel, ChannelKind
from harness.trace.words import WORD_BITS


class DeviceChannels:
    """Adds the channels of one device to a log."""

    def __init__(self, log: ChangeLog, name: str) -> None:
        self._log = log
        self._name = name

    def add(self, item: str, title: str, kind: ChannelKind, word: str | None = None) -> int:
        """`gateway.NAME.ITEM`; `word` is the word of the catalogue that decodes it."""
        bits = WORD_BITS if kind == "word" else 0
        path = f"gateway.{self._name}.{item}"
        return self._log.add(
            Channel(path, title, kind, "gateway", self._name, bits=bits, word=word)
        )

    def lamps(self, names: Sequence[str]) -> list[int]:
        """A channel for each lamp."""
        return [self.add(f"led.{lamp}", f"lamp {lamp.replace('_', ' ')}", "text") for lamp in names]


def changed_bytes(before: bytes, now: bytes) -> list[int]:
    """The places at which these outputs differ from those before, zeros if there were none."""
    before = before or bytes(len(now))
    return [at for at, byte in enumerate(now) if byte != before[at]]
