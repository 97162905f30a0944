"""Invisible marks that carry the origin of a piece through a rendered template.

U+E000, a key, U+E001 mean "from here on the text comes from the origin of that key"; U+E000 U+E001
mean "from here on from nowhere in particular", which is the enclosing template line. A key is a
decimal number, with or without a letter in front of it. Both characters are in Unicode's private
use area, so no text of a person has a use for them.
"""

import re
from collections.abc import Mapping

from fbgen.source import Origin

START, END = "\ue000", "\ue001"
MARK = re.compile(f"{START}([a-z]?[0-9]*){END}")


def mark(key: str = "") -> str:
    """The mark for the origin with this key, or for no particular origin."""
    return f"{START}{key}{END}"


def strip_marks(
    text: str, origins: Mapping[str, Origin]
) -> tuple[str, tuple[tuple[int, Origin], ...]]:
    """The text without marks, and from which offset on it comes from which origin.

    The result fits `Source(name, text, origins)`. A mark with a key that nobody knows, which only a
    template can have made up, is one of no particular origin.
    """
    pieces = MARK.split(text)
    texts = pieces[::2]
    places: list[tuple[int, Origin]] = []
    line: Origin | None = None
    offset = 0
    for piece, key in zip(texts, pieces[1::2], strict=False):
        offset += len(piece)
        origin = origins.get(key)
        if origin is None:
            if line is None:
                continue
            origin = line
        elif origin.is_template:
            line = origin
        if places and places[-1][0] == offset:
            places.pop()
        places.append((offset, origin))
    return "".join(texts), tuple(places)
