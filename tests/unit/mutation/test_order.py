"""In which order the cases of a mutation run are run."""

from pathlib import Path

from harness.scenario.cases import ScenarioCase
from harness.scenario.model import Scenario, Variation
from harness.verify.mutation.order import Order


def case(file: str, wait: str) -> ScenarioCase:
    scenario = Scenario.model_validate(
        {
            "version": 1,
            "title": file,
            "sources": ["a.scl"],
            "block": "A",
            "steps": [{"wait": wait}, {"expect": {"block.q": True}}],
        }
    )
    return ScenarioCase(Path(file), scenario, Variation())


CASES = [
    case("long", "50ms"),
    case("quiet", "10ms"),
    case("quiet", "10ms"),
    case("sharp", "20ms"),
    case("sharp", "20ms"),
]


def order(noticing: set[int]) -> list[int]:
    """The cases one after the other, where these notice something when they are run."""
    left = Order(CASES, range(len(CASES)), lambda number: number in noticing)
    found = []
    while (following := left.next()) is not None:
        found.append(following)
    return found


def test_the_cheapest_comes_first() -> None:
    assert order({1, 3}) == [1, 2, 3, 4, 0]


def test_cases_of_a_scenario_that_notices_nothing_come_last() -> None:
    assert order({3}) == [1, 3, 4, 0, 2]


def test_every_case_has_its_turn_where_nothing_is_noticed() -> None:
    assert order(set()) == [1, 3, 0, 2, 4]
