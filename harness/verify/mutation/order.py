"""Which scenarios are run first: those that are likely to be over soonest.

What a run costs is guessed from its steps, so that the order does not depend on the machine.
"""

from collections.abc import Sequence

from harness.kernel import NS_PER_MS
from harness.scenario import ScenarioCase
from harness.scenario.model import CallStep, ExpectStep, Scenario, WaitStep, WaitUntilStep

_PLANT_NS = 100 * NS_PER_MS
"""Setting up a plant takes as long as letting one drive run for this time."""


def cheapest_first(cases: Sequence[ScenarioCase], numbers: Sequence[int]) -> list[int]:
    """The numbers of some cases, in the order in which they are run."""
    return sorted(numbers, key=lambda number: (_cost(cases[number].scenario), number))


def _cost(scenario: Scenario) -> int:
    time_ns = sum(_time_ns(step, scenario.cycle) for step in scenario.steps)
    return time_ns if scenario.is_of_block else time_ns + _PLANT_NS


def _time_ns(step: object, cycle_ns: int) -> int:
    match step:
        case WaitStep():
            return step.wait
        case WaitUntilStep():
            return step.within
        case ExpectStep():
            return step.within + step.stays_for
        case CallStep():
            return step.call * cycle_ns
        case _:
            return 0
