"""The yardstick plant: one PLC at 10 ms, PROFIBUS at 2 ms, one gateway, five inverters, all polled.

The figure is the processor time for one second of the plant's own time. 500 times real time is
2 ms, or 91,000 turns of the empty loop where a turn takes 22 ns.
"""

from collections.abc import Iterator
from pathlib import Path

from bench.measuring import Figure, measure
from harness.installation import plant
from harness.kernel import NS_PER_S

_PLANT = Path(__file__).parents[1] / "examples" / "five_drives" / "plant.yaml"
_WARM_UP_NS = 3 * NS_PER_S
_SLICES = 10


def figures() -> Iterator[Figure]:
    """How long a second of the plant takes, and what of it is the PLC's program alone."""
    installation = plant(_PLANT)
    installation.start()
    installation.run_for(_WARM_UP_NS)

    def slice_of_a_second() -> None:
        installation.run_for(NS_PER_S // _SLICES)

    second = measure("0.1 s of the yardstick plant", slice_of_a_second, windows=300)
    times = 1 / (second.seconds * _SLICES)
    yield Figure(
        "1 s of the yardstick plant",
        second.seconds * _SLICES,
        second.turns * _SLICES,
        f"{times:.0f} times real time, at least 500 wanted (91,000 turns)",
    )
    engine = installation.cpu.engine
    yield measure("one call of TOS_Main with nothing to do", lambda: engine.run_block("TOS_Main"))
