"""What a controller has beside memory and hardware: a calendar clock, and the stubs of the user.

Both engines use it; it holds state and calculates nothing of the PLC language.
"""

from harness.engine.stubs import Stubs

CALENDAR_START_NS = 1_325_376_000 * 1_000_000_000
"""2012-01-01 00:00:00, in nanoseconds since 1970: what the calendar shows at instant 0."""


class Services:
    """One per controller. `calendar_ns` is what the calendar clock shows at instant 0.

    `leftovers` is the seed of what temporary variables hold before they are written, see
    `harness.engine.leftovers`; None where they begin with their defaults. It is set before a
    program is loaded.
    """

    __slots__ = ("calendar_ns", "leftovers", "stubs")

    def __init__(self) -> None:
        self.calendar_ns = CALENDAR_START_NS
        self.leftovers: int | None = None
        self.stubs = Stubs()
