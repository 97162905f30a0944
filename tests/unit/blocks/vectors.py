"""The vectors copied from the TOSPBDP001 manual, by their ids."""

from typing import Any

from tests.vectors.reading import entries


def vector(entry_id: str) -> dict[str, Any]:
    """One entry as it stands in the file."""
    return entries("tospbdp001_telegrams")[entry_id]


def telegrams_of_the_example() -> list[dict[str, Any]]:
    """The four rows of section 8 G in their order."""
    return [vector(f"tos.g.row{number}") for number in range(1, 5)]
