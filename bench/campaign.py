"""Seeds of a campaign a second, with one and with two workers side by side."""

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from harness.kernel import NS_PER_S
from harness.verify.campaign import Campaign
from harness.verify.campaign.files import campaign_settings

SEEDS = 60
WORKERS = (1, 2)


def figures() -> Iterator[str]:
    """A line for each number of workers."""
    settings = campaign_settings([], [])
    with TemporaryDirectory() as folder:
        for workers in WORKERS:
            begin_s = perf_counter()
            log = Path(folder) / f"{workers}.jsonl"
            done = Campaign(settings, SEEDS, workers).run(log)
            took_s = perf_counter() - begin_s
            times = done.virtual_ns / NS_PER_S / took_s
            yield (
                f"{workers} workers: {SEEDS / took_s:.1f} seeds a second, {times:.0f} times real "
                f"time, {len(done.failures)} failed"
            )
