"""A scenario of a campaign as plain data, as it stands in its file."""

from typing import Any, TypeAlias

from harness.kernel import NS_PER_US

Entry: TypeAlias = dict[str, Any]
"""A mapping of a scenario file."""


def written_time(time_ns: int) -> str:
    """A time as scenario files have it."""
    return f"{time_ns / NS_PER_US:.3f}".rstrip("0").rstrip(".") + " us"
