"""Invisible marks that carry the origin of a piece through a rendered template.

U+E000, a decimal index, U+E001 mean "from here on the text comes from origin number index";
U+E000 U+E001 mean "from here on from nowhere in particular", which is the enclosing template line.
Both characters are in Unicode's private use area, so no text of a person has a use for them.
"""

import re
from collections.abc import Sequence

from fbgen.source import Origin

START, END = "\ue000", "\ue001"
_MARK = re.compile(f"{START}([0-9]*){END}")


def mark(index: int | None) -> str:
    """The mark for an index into the origins, or for no particular origin."""
    return f"{START}{'' if index is None else index}{END}"


def strip_marks(
    text: str, origins: Sequence[Origin | None]
) -> tuple[str, tuple[tuple[int, Origin | None], ...]]:
    """The text without marks, and from which offset on it comes from which origin.

    The result fits `Source(name, text, origins)`. An index beyond `origins` is a ValueError: the
    marks come from our own templates, never from a person.
    """
    pieces: list[str] = []
    places: list[tuple[int, Origin | None]] = []
    offset = position = 0
    for found in _MARK.finditer(text):
        pieces.append(text[position : found.start()])
        offset += found.start() - position
        position = found.end()
        origin = origins[int(found[1])] if found[1] and int(found[1]) < len(origins) else None
        if found[1] and int(found[1]) >= len(origins):
            raise ValueError(f"mark {found[1]} of {len(origins)} origins")
        if places and places[-1][0] == offset:
            places.pop()
        places.append((offset, origin))
    pieces.append(text[position:])
    return "".join(pieces), tuple(places)
