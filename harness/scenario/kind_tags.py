"""Which of several kinds an entry of a scenario file is: its key says it."""

from collections.abc import Callable, Mapping
from typing import Any

from fbgen.nearest import near_names


def tag_by_key(kinds: Mapping[str, type], noun: str) -> Callable[[Any], str | None]:
    """What gives the tag of an entry, such as `set step`; None if it is not clear which is meant.

    Tags have blanks, so that none is a key. A misspelt key counts as meant, so that the finding
    names it.
    """

    def tag(entry: Any) -> str | None:
        if isinstance(entry, dict):
            keys = [key for key in kinds if key in entry]
            keys = keys or [near for key in entry for near in near_names(str(key), kinds)][:1]
        else:
            keys = [key for key, kind in kinds.items() if isinstance(entry, kind)]
        return f"{keys[0]} {noun}" if len(keys) == 1 else None

    return tag
