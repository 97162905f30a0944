"""Paths to variables as they are given from outside: `"DB".telegram[3].value`, `table[1, 2]`.

`next^.value` follows a reference.
"""

import re
from functools import lru_cache
from typing import TypeAlias

from harness.engine.faults import wrong_path

Step: TypeAlias = str | tuple[int, ...]
"""A name, or the indices of an array element."""

FOLLOW = "^"
"""The step from a reference to what it refers to."""

_STEP = re.compile(
    r"""\s*(?:
        \#?"(?P<quoted>[^"]*)"
      | \#?(?P<name>[^\W\d]\w*)
      | \[(?P<indices>\s*[+-]?\d+\s*(?:,\s*[+-]?\d+\s*)*)\]
    )\s*""",
    re.VERBOSE,
)


@lru_cache(maxsize=4096)
def parse_path(path: str) -> tuple[Step, ...]:
    """The steps of a path; names as written, without quotes and `#`, or `^`. Raises FB6024."""
    steps: list[Step] = []
    position = 0
    while position < len(path):
        if steps and path[position] == ".":
            position += 1
            if path[position : position + 1] == "[":
                raise wrong_path(path, "an index follows its array without a point")
        elif steps and path[position] == FOLLOW:
            steps.append(FOLLOW)
            position += 1
            continue
        elif steps and path[position] != "[":
            raise wrong_path(path, f"found {path[position]!r} where '.' or '[' belongs")
        match = _STEP.match(path, position)
        if match is None:
            raise wrong_path(path, "a name or an index is missing")
        if match["indices"] is not None:
            if not steps:
                raise wrong_path(path, "it starts with an index")
            steps.append(tuple(int(index) for index in match["indices"].split(",")))
        else:
            steps.append(match["name"] if match["quoted"] is None else match["quoted"])
        position = match.end()
    if not steps or path.endswith("."):
        raise wrong_path(path, "a name is missing")
    return tuple(steps)
