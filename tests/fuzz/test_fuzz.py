"""A short run of the fuzzer; `python -m tests.fuzz` goes on for as long as one likes."""

import pytest

from tests.fuzz.campaign import Breakage, fuzz
from tests.fuzz.targets import Target, targets

INPUTS = 60


@pytest.mark.parametrize("name", sorted(targets()))
def test_mutated_inputs_give_results_or_diagnostics(name: str) -> None:
    assert fuzz(targets()[name], 0, lambda count: count < INPUTS) == INPUTS


def test_the_fuzzer_tells_what_breaks() -> None:
    def breaks(data: bytes) -> None:
        if len(data) % 7 == 3:
            raise ValueError("seven")

    with pytest.raises(Breakage, match="ValueError: seven"):
        fuzz(Target(breaks, [b"some input to begin with"]), 0, lambda count: count < 1000)
