"""What temporary variables hold at the start of a call, as scenario files and commands say it."""

from typing import Literal, TypeAlias

Temporaries: TypeAlias = Literal["initial", "undefined"]
"""`undefined`: what other calls have left in their places, see `harness.engine.leftovers`."""


def leftovers_of(temporaries: Temporaries, seed: int) -> int | None:
    """The seed of what is left over; None where temporaries begin with their defaults."""
    return seed if temporaries == "undefined" else None
