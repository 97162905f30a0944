"""The help for unknown names."""

from fbgen.nearest import did_you_mean, nearest

MANY = [f"Block{number:04}" for number in range(2_000)]


def test_a_near_name_is_asked_for() -> None:
    assert nearest("strat", ["start", "stop"]) == "did you mean 'start'?"


def test_without_a_near_name_the_known_ones_are_listed() -> None:
    assert nearest("xyz", ["start", "stop"]) == "known: start, stop"
    assert did_you_mean("xyz", ["start", "stop"]) == ""


def test_a_near_name_is_found_among_thousands() -> None:
    assert did_you_mean("Pmup", [*MANY, "Pump"]) == "did you mean 'Pump'?"


def test_no_list_of_thousands_is_searched_for_long() -> None:
    assert did_you_mean("Block9999", MANY) == ""
