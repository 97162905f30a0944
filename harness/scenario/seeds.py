"""With which seeds a scenario runs: one, so many from one on, or a list of them."""

from typing import Annotated

from pydantic import BeforeValidator
from pydantic.json_schema import WithJsonSchema

from fbgen.catalog.located import describe

MOST_SEEDS = 100_000
"""More are a slip of the pen, or work for a campaign."""


def _read(value: object) -> object:
    """A number as it is, a list of different numbers as a tuple. Raises ValueError."""
    items = list(value) if isinstance(value, list | tuple) else [value]
    for item in items:
        if not isinstance(item, int) or isinstance(item, bool) or item < 0:
            raise ValueError(f"found {describe(item)}, expected how many seeds, or a list of them")
    if len(set(items)) < len(items):
        raise ValueError("a seed stands here twice")
    if not items:
        raise ValueError("an empty list: the scenario would never run")
    if isinstance(value, int) and not 0 < value <= MOST_SEEDS:
        raise ValueError(f"found {value}, expected 1 to {MOST_SEEDS} seeds")
    return value


Seeds = Annotated[
    int | tuple[int, ...],
    BeforeValidator(_read),
    WithJsonSchema(
        {
            "oneOf": [
                {"type": "integer", "minimum": 1, "maximum": MOST_SEEDS},
                {
                    "type": "array",
                    "items": {"type": "integer", "minimum": 0},
                    "minItems": 1,
                    "uniqueItems": True,
                },
            ]
        }
    ),
]
"""How many seeds, or which."""


def seeds_of(seed: int, seeds: int | tuple[int, ...]) -> tuple[int, ...]:
    """The seeds that a scenario runs with."""
    if isinstance(seeds, int):
        return tuple(range(seed, seed + seeds))
    return seeds or (seed,)
