"""Work shared out to several processes, with results in the order of the work."""

from collections.abc import Callable, Generator, Sequence
from typing import TypeVar

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


def in_order(
    work: Callable[[_Item], _Result], items: Sequence[_Item], jobs: int
) -> Generator[_Result, None, None]:
    """What `work` makes of each item, in their order, by up to `jobs` processes.

    Ctrl-C is noticed here only. Whoever stops asking for results ends the processes at once, and
    so does the end of this process, however it comes: `work` must leave nothing half done.

    Raises DiagnosticError FB9020 if the system ends one of the processes.
    """
    if jobs == 1 or len(items) < 2:
        yield from map(work, items)
        return
    from fbgen.worker_pool import pooled  # noqa: PLC0415 - one process needs none of it

    yield from pooled(work, items, min(jobs, len(items)))
