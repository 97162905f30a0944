"""The words of the catalogue, as a trace carries them."""

from fbgen.catalog import Word
from harness.trace.model import TraceWord, WordField

WORD_BITS = 16
"""Of every word of the catalogue."""


def trace_word(name: str, word: Word) -> TraceWord:
    """A word with the names of its bits; `name` says of which device, `tospbdp001.status`."""
    fields = sorted(word.bits, key=lambda item: -item.low)
    return TraceWord(
        name,
        word.title,
        tuple(
            WordField(item.name, item.title, item.low, item.high, dict(item.values))
            for item in fields
        ),
    )
