"""Texts with the origins of their lines as bytes, and back: JSON, nothing else.

Each origin stands once, behind those that it names as its inputs.
"""

import json
from collections.abc import Sequence

from fbgen.source import Origin, Source


def packed(sources: Sequence[Source]) -> bytes:
    """The texts as bytes."""
    numbers: dict[Origin, int] = {}
    texts = [
        (
            source.name,
            source.text,
            [(offset, origin and _number(origin, numbers)) for offset, origin in source.origins],
        )
        for source in sources
    ]
    origins = [
        (one.what, one.file, one.line, one.source, [numbers[item] for item in one.inputs])
        for one in numbers
    ]
    return json.dumps({"origins": origins, "texts": texts}, separators=(",", ":")).encode("ascii")


def _number(origin: Origin, numbers: dict[Origin, int]) -> int:
    """Where the origin stands; with its inputs it gets a place if it has none."""
    for item in origin.inputs:
        _number(item, numbers)
    return numbers.setdefault(origin, len(numbers))


def unpacked(data: bytes) -> list[Source]:
    """The texts that `packed` made these bytes from."""
    content = json.loads(data)
    origins: list[Origin] = []
    for what, file, line, source, inputs in content["origins"]:
        origins.append(Origin(what, file, line, source, tuple(origins[item] for item in inputs)))
    return [
        Source(
            name,
            text,
            tuple((at, None if number is None else origins[number]) for at, number in places),
        )
        for name, text, places in content["texts"]
    ]
