"""Seeds of a campaign a second, with one and with two workers side by side.

On a machine that others use, too, the time of the processor says more than that of the clock.
"""

from collections.abc import Iterator
from os import times
from pathlib import Path
from tempfile import TemporaryDirectory

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
            begin = times()
            done = Campaign(settings, SEEDS, workers).run(Path(folder) / f"{workers}.jsonl")
            end = times()
            took_s = end.elapsed - begin.elapsed
            used_s = sum(end[:4]) - sum(begin[:4])
            real = done.virtual_ns / NS_PER_S / took_s
            yield (
                f"{workers} workers: {SEEDS / took_s:.1f} seeds a second, {real:.0f} times real "
                f"time, {used_s / SEEDS:.2f} s of the processor a seed, {len(done.failures)} failed"
            )
