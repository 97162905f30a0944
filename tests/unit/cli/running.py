"""The result of a command that was run in this process."""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Run:
    """One command that has ended: exit status and what it printed."""

    status: int
    out: str
    err: str


Fbgen = Callable[..., Run]
"""`fbgen("decode", "tospbdp001.status", "9F00")` runs the command."""
