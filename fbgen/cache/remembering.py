"""Objects that this process or an earlier one has made of the same things."""

from collections.abc import Callable, Iterable
from typing import TypeVar

from fbgen.cache.entries import keep, kept
from fbgen.cache.folder import cache_folder
from fbgen.cache.keys import key_of
from fbgen.cache.objects import packed_objects, unpacked_objects

T = TypeVar("T")


def remembered(
    parts: Iterable[str | bytes],
    make: Callable[[], T],
    may_be_kept: Callable[[T], bool] = lambda made: True,
) -> T:
    """What `make` gives for these parts, which must be all that it depends on beside fbgen.

    The parts begin with what it is. Whatever `make` raises is not kept, nor what does depend on
    more.
    """
    if cache_folder() is None:
        return make()
    key = key_of(parts)
    known = kept(key)
    if known is not None:
        found: T = unpacked_objects(known)
        return found
    made = make()
    content = packed_objects(made) if may_be_kept(made) else None
    if content is not None:
        keep(key, content)
    return made
