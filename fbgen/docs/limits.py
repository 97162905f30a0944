"""What a simulation leaves out, as data that is handed in."""

from fbgen.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class NotModelled:
    """One thing: of which part, what it is, and what the model does instead."""

    part: str
    what: str
    instead: str
