"""Python's cycle collector, kept still while trees are made: they have no cycles, and looking for
some in millions of new nodes would take longer than making them."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


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
                gc.freeze()
                gc.unfreeze()
            gc.enable()
