"""Two faults at once, in whichever order they end: what is asked of every kind of plant."""

from collections.abc import Callable

from harness.faults import Fault
from harness.installation import Installation
from harness.kernel import NS_PER_MS

SETTLING_NS = 25 * NS_PER_MS
Held = Callable[[Installation], dict[str, object]]
"""What faults hold in a plant."""


def end_independently(plant: Installation, faults: tuple[Fault, Fault], held: Held) -> None:
    """Behind the end of one the plant is as with the other alone, behind both as it was."""
    names = ", ".join(type(made).__name__ for made in faults)
    before = held(plant)
    single = [_alone(plant, made, held) for made in faults]
    for which in (0, 1):
        for made in faults:
            made.inject()
        plant.run_for(SETTLING_NS)
        faults[which].clear()
        plant.run_for(SETTLING_NS)
        assert held(plant) == single[1 - which], f"{names}: {which} has ended"
        faults[1 - which].clear()
        plant.run_for(SETTLING_NS)
        assert held(plant) == before, f"{names}: both have ended"


def one_behind_the_other(plant: Installation, faults: tuple[Fault, Fault], rest_ns: int) -> None:
    """They overlap; `rest_ns` is what the plant is given behind both."""
    faults[0].inject()
    plant.run_for(700 * NS_PER_MS)
    faults[1].inject()
    plant.run_for(1300 * NS_PER_MS)
    faults[0].clear()
    plant.run_for(600 * NS_PER_MS)
    faults[1].clear()
    plant.run_for(rest_ns)


def _alone(plant: Installation, made: Fault, held: Held) -> dict[str, object]:
    """The plant with one fault, which then ends."""
    made.inject()
    plant.run_for(2 * SETTLING_NS)
    seen = held(plant)
    made.clear()
    plant.run_for(SETTLING_NS)
    return seen
