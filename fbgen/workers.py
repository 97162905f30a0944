"""Work shared out to several processes, with results in the order of the work."""

from collections.abc import Callable, Generator, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from fbgen.worker_pool import Pool

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


class Workers:
    """Up to `jobs` processes, started when there is work for them, and kept for more work.

    Ctrl-C is noticed in this process only. Whoever stops asking for results ends the processes at
    once, and so does the end of this process, however it comes: work must leave nothing half done.
    """

    def __init__(self, jobs: int) -> None:
        self.jobs = jobs
        self._pool: Pool | None = None

    def __enter__(self) -> "Workers":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._pool is not None:
            self._pool.end()
            self._pool = None

    def in_order(
        self, work: Callable[[_Item], _Result], items: Sequence[_Item]
    ) -> Generator[_Result, None, None]:
        """What `work` makes of each item, in their order.

        Raises DiagnosticError FB9020 if the system ends one of the processes.
        """
        if self.jobs == 1 or (self._pool is None and len(items) < 2):
            yield from map(work, items)
            return
        if self._pool is None:
            from fbgen.worker_pool import Pool  # noqa: PLC0415 - one process needs none of it

            self._pool = Pool(self.jobs)
        yield from self._pool.in_order(work, items)


def in_order(
    work: Callable[[_Item], _Result], items: Sequence[_Item], jobs: int
) -> Generator[_Result, None, None]:
    """What `work` makes of each item, in their order, by up to `jobs` processes: see `Workers`."""
    with Workers(min(jobs, max(len(items), 1))) as workers:
        yield from workers.in_order(work, items)
