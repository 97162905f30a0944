"""Work shared out to several processes, with results in the order of the work."""

import signal
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


def in_order(
    work: Callable[[_Item], _Result], items: Sequence[_Item], jobs: int
) -> Iterator[_Result]:
    """What `work` makes of each item, in their order, by up to `jobs` processes.

    Ctrl-C is noticed here only: the others end what they are at, and nothing else is begun.
    """
    if jobs == 1 or len(items) < 2:
        yield from map(work, items)
        return
    from concurrent.futures import ProcessPoolExecutor

    pool = ProcessPoolExecutor(min(jobs, len(items)), initializer=_without_interrupts)
    try:
        yield from pool.map(work, items)
    finally:
        pool.shutdown(cancel_futures=True)


def _without_interrupts() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
