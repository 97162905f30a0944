"""A campaign: seeds in chunks, on the processes of this machine or on those of a cluster.

What a seed does depends on nothing but the seed, the files and the faults, so the result is the
same with however many workers, in whichever order, and in one go or in several.
"""

from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.source import Source, Span
from fbgen.workers import in_order
from harness.verify.campaign.log import add_chunk, open_log
from harness.verify.campaign.trials import CampaignSettings, Chunk, Failure, try_seeds

LARGEST_CHUNK = 20
"""A seed takes some tenths of a second, so a chunk some seconds: that pays for its way."""
_CHUNKS_PER_WORKER = 8
_WAITING_PER_WORKER = 2


@dataclass(frozen=True, slots=True)
class Progressed:
    """How far a campaign is."""

    done: int
    seeds: int
    configurations: int
    failures: int


@dataclass(frozen=True, slots=True)
class CampaignReport:
    """What came of it. `seeds` were tried, in `virtual_ns` of the plants' time."""

    seeds: int
    virtual_ns: int
    configurations: tuple[str, ...]
    failures: tuple[Failure, ...]
    interrupted: bool = False

    def kinds(self) -> dict[str, list[Failure]]:
        """The failures by what broke; the smallest seed of each first."""
        found: dict[str, list[Failure]] = {}
        for failure in sorted(self.failures, key=lambda item: item.seed):
            found.setdefault(failure.kind, []).append(failure)
        return found


@dataclass(frozen=True, slots=True)
class Campaign:
    """So many `seeds` from 0 on, with `workers` processes or on the cluster at an address."""

    settings: CampaignSettings
    seeds: int
    workers: int = 1
    cluster: str | None = None

    def run(
        self, log: Path, progressed: Callable[[Progressed], None] = lambda how: None
    ) -> CampaignReport:
        """Try all seeds that `log` does not have yet. Ctrl-C ends it; the log then has what was
        tried up to then.

        Raises DiagnosticError FB8072 for a log of another campaign, FB8073 without a cluster.
        """
        writing, chunks = open_log(log, self.settings)
        interrupted = False
        try:
            for chunk in self._tried(self._left(chunks)):
                add_chunk(writing, chunk)
                chunks.append(chunk)
                failures = sum(len(item.failures) for item in chunks)
                tried = len(_configurations(chunks))
                progressed(Progressed(_count(chunks), self.seeds, tried, failures))
        except KeyboardInterrupt:
            interrupted = True
        finally:
            writing.close()
        failed = [failure for chunk in chunks for failure in chunk.failures]
        virtual_ns = sum(chunk.virtual_ns for chunk in chunks)
        configurations = _configurations(chunks)
        return CampaignReport(
            _count(chunks), virtual_ns, configurations, tuple(failed), interrupted
        )

    def _left(self, done: list[Chunk]) -> list[range]:
        """The seeds that were not tried yet, in chunks."""
        tried = {seed for chunk in done for seed in range(chunk.first, chunk.behind)}
        size = -(-self.seeds // (self.workers * _CHUNKS_PER_WORKER))
        size = max(1, min(LARGEST_CHUNK, size))
        left: list[range] = []
        for seed in range(self.seeds):
            if seed in tried:
                continue
            if left and left[-1].stop == seed and len(left[-1]) < size:
                left[-1] = range(left[-1].start, seed + 1)
            else:
                left.append(range(seed, seed + 1))
        return left

    def _tried(self, left: list[range]) -> Iterator[Chunk]:
        if self.cluster is None:
            yield from in_order(partial(_try, self.settings), left, self.workers)
            return
        with _on_cluster(self.cluster) as (executor, workers):
            waiting: set[Future[Chunk]] = set()
            for seeds in left:
                if len(waiting) >= _WAITING_PER_WORKER * workers:
                    done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                    yield from (item.result() for item in done)
                waiting.add(executor.submit(_try, self.settings, seeds))
            while waiting:
                done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                yield from (item.result() for item in done)


def _try(settings: CampaignSettings, seeds: range) -> Chunk:
    return try_seeds(settings, seeds.start, seeds.stop)


@contextmanager
def _on_cluster(address: str) -> Iterator[tuple[Executor, int]]:
    """The workers of a dask.distributed cluster, and how many at once. Raises DiagnosticError
    FB8073."""
    try:
        distributed: Any = import_module("distributed")
    except ImportError:
        raise error(
            "FB8073",
            "a campaign on a cluster needs dask.distributed",
            None,
            "pip install fbgen[cluster]",
        ) from None
    try:
        client = distributed.Client(address, timeout=10)
    except (OSError, ValueError) as wrong:
        asked = Source("--cluster", address)
        raise error(
            "FB8073",
            f"there is no cluster at {address}: {wrong}",
            Span(asked, 0, len(address)),
            "start one with dask scheduler and dask worker, and name the scheduler's address",
        ) from None
    with client:
        yield client.get_executor(pure=False), max(sum(client.nthreads().values()), 1)


def _configurations(chunks: list[Chunk]) -> tuple[str, ...]:
    return tuple(sorted({name for chunk in chunks for name in chunk.configurations}))


def _count(chunks: list[Chunk]) -> int:
    return sum(chunk.behind - chunk.first for chunk in chunks)
