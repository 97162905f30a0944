"""Whether two things that templates are told would come out as the same text.

Where a value is from, its origin, is no part of the text: two series may have the same number from
two manuals.
"""

import dataclasses
from collections.abc import Mapping

from fbgen.blocks.literals import SclText
from fbgen.blocks.words import WordView

_ONLY_COMMENTS = ("trip_source",)
"""What stands in comments, that of the first series there is."""


def as_text(value: object) -> object:
    """What can come out of it, comparable."""
    if isinstance(value, SclText):
        return value.text
    if isinstance(value, WordView):
        return sorted((field.name, field.mask) for field in value.entry.bits)
    if isinstance(value, Mapping):
        return {key: as_text(one) for key, one in value.items() if key not in _ONLY_COMMENTS}
    if isinstance(value, tuple | list):
        return [as_text(one) for one in value]
    if dataclasses.is_dataclass(value):
        return [as_text(getattr(value, one.name)) for one in dataclasses.fields(value)]
    return value
