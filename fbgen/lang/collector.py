"""Python's cycle collector, kept still while trees are made: they have no cycles, and looking for
some in millions of new nodes would take longer than making them."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager

_UNSEEN = 1_000_000
"""So many new objects, some 100 MB, may go by before everything is looked through."""


class _Moved:
    """Objects that are no longer young and that no collection has looked at.

    Python counts only those that its own collections make old. A process that reads program after
    program would keep all that was cyclic in them, engines and plants, for ever.
    """

    def __init__(self) -> None:
        self._unseen = 0
        self._next = _UNSEEN

    def add(self, count: int) -> None:
        """So many more; when they are many, look through everything.

        What is alive is looked at again when as much is new: a large plant costs no more than twice
        its size.
        """
        self._unseen += count
        if self._unseen >= self._next:
            gc.collect()
            self._unseen = 0
            self._next = max(_UNSEEN, len(gc.get_objects()))


_moved = _Moved()


@contextmanager
def collector_at_rest() -> Iterator[None]:
    """No collection inside. Freezing and unfreezing moves the new nodes to the oldest generation,
    so that the next small collection does not look at all of them."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            if not gc.get_freeze_count():
                young, *_ = gc.get_count()
                gc.freeze()
                gc.unfreeze()
                _moved.add(young)
            gc.enable()
