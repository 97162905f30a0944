"""Which scenarios are run first: those that are likely to be over soonest, and to notice something.

What a run costs is guessed from its steps, so that the order does not depend on the machine. The
cases of one scenario do the same with other values: where one of them has noticed nothing, the
others come last. By then most mutants are noticed elsewhere, and need not be run in each of them.
"""

from collections.abc import Callable, Sequence
from pathlib import Path

from harness.kernel import NS_PER_MS
from harness.scenario import ScenarioCase
from harness.scenario.model import CallStep, ExpectStep, Scenario, WaitStep, WaitUntilStep

_PLANT_NS = 100 * NS_PER_MS
"""Setting up a plant takes as long as letting one drive run for this time."""


def cheapest_first(cases: Sequence[ScenarioCase], numbers: Sequence[int]) -> list[int]:
    """The numbers of some cases, in the order in which they are run."""
    return sorted(numbers, key=lambda number: (_cost(cases[number].scenario), number))


class Order:
    """The cases that are still to be run, cheapest first; `noticed` says what one has noticed."""

    def __init__(
        self, cases: Sequence[ScenarioCase], numbers: Sequence[int], noticed: Callable[[int], bool]
    ) -> None:
        self._cases = cases
        self._left = cheapest_first(cases, numbers)
        self._noticed = noticed
        self._tried: dict[Path, list[int]] = {}

    def __len__(self) -> int:
        return len(self._left)

    def next(self) -> int | None:
        """The next one to be run, which is then no longer left; None at the end."""
        if not self._left:
            return None
        hopeful = (case for case in self._left if self._is_hopeful(self._cases[case].path))
        case = next(hopeful, self._left[0])
        self._left.remove(case)
        self._tried.setdefault(self._cases[case].path, []).append(case)
        return case

    def _is_hopeful(self, scenario: Path) -> bool:
        tried = self._tried.get(scenario)
        return tried is None or any(map(self._noticed, tried))


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
