"""Where blocks use bits, words and ComNos, as far as a site knows it."""

from collections.abc import Mapping
from types import MappingProxyType

from fbgen.dataclass import dataclass
from fbgen.docs.document import Phrase

BitKey = tuple[str, str, str]
"""Device, word and bit."""


@dataclass(frozen=True, slots=True)
class Usage:
    """Phrases that lead to the places. Not `known`: no blocks were looked at."""

    known: bool
    bits: Mapping[BitKey, Phrase]

    def of_bit(self, device: str, word: str, bit: str) -> Phrase:
        """Where a bit is used; empty where nowhere."""
        return self.bits.get((device, word, bit), ())


NO_USAGE = Usage(False, MappingProxyType({}))
