"""The vectors copied from the TOSPBDP001 manual, by their ids."""

from functools import cache
from pathlib import Path
from typing import Any

import yaml

_FILE = Path(__file__).parents[2] / "vectors" / "tospbdp001_telegrams.yaml"


@cache
def _entries() -> dict[str, dict[str, Any]]:
    entries = yaml.safe_load(_FILE.read_text("utf-8"))["entries"]
    return {entry["id"]: entry for entry in entries}


def vector(entry_id: str) -> dict[str, Any]:
    """One entry as it stands in the file."""
    return _entries()[entry_id]


def telegrams_of_the_example() -> list[dict[str, Any]]:
    """The four rows of section 8 G in their order."""
    return [vector(f"tos.g.row{number}") for number in range(1, 5)]
