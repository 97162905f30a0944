"""The yardstick plant: one PLC at 10 ms, PROFIBUS at 2 ms, one gateway, five inverters, all polled.

The figure is the processor time for one second of the plant's own time, whole seconds at a time: so
every window has its telegrams and its two heartbeats. 500 times real time is 2 ms.
"""

from collections.abc import Iterator
from pathlib import Path

from bench.measuring import Figure, measure
from harness.installation import plant
from harness.kernel import NS_PER_S

_PLANT = Path(__file__).parents[1] / "examples" / "five_drives" / "plant.yaml"
_WARM_UP_NS = 3 * NS_PER_S


def figures() -> Iterator[Figure]:
    """How long a second of the plant takes, and what of it is the PLC's program alone."""
    installation = plant(_PLANT)
    installation.start()
    installation.run_for(_WARM_UP_NS)

    second = measure("", lambda: installation.run_for(NS_PER_S), windows=500)
    limit = f"{1 / second.seconds:.0f} times real time, at least 500"
    yield Figure("1 s of the yardstick plant", second.seconds, second.turns, limit)
    engine = installation.cpu.engine
    yield measure("one call of TOS_Main with nothing to do", lambda: engine.run_block("TOS_Main"))
