"""Watches over the properties of a scenario while it runs.

A watch looks at the plant at each virtual millisecond, behind each scan of the PLC and behind each
step. So a value of the PLC is missed only if the program itself changes it back within one scan,
and a value of a device only if it lasts for less than a millisecond between two scans.

What a watch sees violated it tells as a `Violation` with the values of that instant; each watch
tells one and is silent from then on.
"""

from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Sequence
from typing import ClassVar

from fbgen.dataclass import dataclass
from harness.durations import show_duration
from harness.scenario.conditions import Check, Conditions, all_hold
from harness.scenario.kinds import Found
from harness.scenario.property_model import (
    AfterProperty,
    AlwaysProperty,
    AtMostProperty,
    EventuallyProperty,
    MutuallyExclusiveProperty,
    NeverProperty,
    Property,
)


@dataclass(frozen=True, slots=True)
class Violation:
    """What was seen: in words, at which instant, and which checks with the values they found."""

    message: str
    time_ns: int
    seen: tuple[tuple[Check, Found], ...]


class Monitor(ABC):
    """The watch over one property. `counted` tells whether it ever had something to decide."""

    never_counted: ClassVar[str] = ""
    """Why it may have decided nothing, for a warning; "" if it always has something to decide."""

    def __init__(self, item: Property, conditions: Conditions) -> None:
        self.property = item
        self.counted = False
        self._before = False
        self._during = conditions.checks(item, "during")

    def look(self, now_ns: int) -> Violation | None:
        """What is violated now."""
        if self._during and not all_hold(self._during):
            self._pause()
            return None
        return self._look(now_ns)

    def end(self, now_ns: int) -> Violation | None:
        """What is violated because the run is over."""
        return None

    @abstractmethod
    def _look(self, now_ns: int) -> Violation | None:
        """What is violated now, while the property counts."""

    def _pause(self) -> None:
        """The property does not count for now; what has begun is forgotten."""
        self._before = False


def monitor_of(item: Property, conditions: Conditions) -> Monitor:
    """The watch over a property."""
    if isinstance(item, NeverProperty):
        return _Never(item, conditions)
    if isinstance(item, AlwaysProperty):
        return _Always(item, conditions)
    if isinstance(item, AfterProperty):
        return _After(item, conditions)
    if isinstance(item, AtMostProperty):
        return _AtMost(item, conditions)
    if isinstance(item, MutuallyExclusiveProperty):
        return _MutuallyExclusive(item, conditions)
    return _Eventually(item, conditions)


def _violation(message: str, now_ns: int, checks: Sequence[Check]) -> Violation:
    return Violation(message, now_ns, tuple((check, check.source.get()) for check in checks))


def _found(checks: Sequence[Check]) -> str:
    return " and ".join(f"{check.path} is {check.show(check.source.get())}" for check in checks)


def _became(checks: Sequence[Check]) -> str:
    return " and ".join(f"{check.path} became {check.demand.describe()}" for check in checks)


class _Never(Monitor):
    never_counted = "'during' never held, so nothing was forbidden"

    def __init__(self, item: NeverProperty, conditions: Conditions) -> None:
        super().__init__(item, conditions)
        self._checks = conditions.checks(item, "never")

    def _look(self, now_ns: int) -> Violation | None:
        self.counted = True
        if not all_hold(self._checks):
            return None
        return _violation(f"{_found(self._checks)}, which must never be", now_ns, self._checks)


class _Always(Monitor):
    never_counted = "'during' never held, so nothing was demanded"

    def __init__(self, item: AlwaysProperty, conditions: Conditions) -> None:
        super().__init__(item, conditions)
        self._checks = conditions.checks(item, "always")

    def _look(self, now_ns: int) -> Violation | None:
        self.counted = True
        unmet = [check for check in self._checks if not check.holds()]
        if not unmet:
            return None
        wanted = " and ".join(check.demand.describe() for check in unmet)
        return _violation(f"{_found(unmet)}, expected always {wanted}", now_ns, unmet)


class _After(Monitor):
    never_counted = "'after' never became true, or too late to see what comes of it"

    def __init__(self, item: AfterProperty, conditions: Conditions) -> None:
        super().__init__(item, conditions)
        self._within_ns = item.within
        self._trigger = conditions.checks(item, "after")
        self._checks = conditions.checks(item, "then")
        self._since_ns: int | None = None

    def _look(self, now_ns: int) -> Violation | None:
        now = all_hold(self._trigger)
        if now and not self._before and self._since_ns is None:
            self._since_ns = now_ns
        self._before = now
        if self._since_ns is None:
            return None
        if all_hold(self._checks):
            self.counted = True
            self._since_ns = None
            return None
        if now_ns < self._since_ns + self._within_ns:
            return None
        self.counted = True
        unmet = [check for check in self._checks if not check.holds()]
        wanted = " and ".join(check.demand.describe() for check in unmet)
        message = (
            f"{_found(unmet)} {show_duration(now_ns - self._since_ns)} after "
            f"{_became(self._trigger)}, expected {wanted} "
            f"within {show_duration(self._within_ns)}"
        )
        return _violation(message, now_ns, [*unmet, *self._trigger])

    def _pause(self) -> None:
        super()._pause()
        self._since_ns = None


class _AtMost(Monitor):
    never_counted = "'of' never became true"

    def __init__(self, item: AtMostProperty, conditions: Conditions) -> None:
        super().__init__(item, conditions)
        self._most = item.at_most
        self._per_ns = item.per
        self._checks = conditions.checks(item, "of")
        self._times: deque[int] = deque()

    def _look(self, now_ns: int) -> Violation | None:
        now = all_hold(self._checks)
        came, self._before = now and not self._before, now
        if not came:
            return None
        self.counted = True
        self._times.append(now_ns)
        while self._times[0] <= now_ns - self._per_ns:
            self._times.popleft()
        if len(self._times) <= self._most:
            return None
        message = (
            f"{_became(self._checks)} {len(self._times)} times within "
            f"{show_duration(now_ns - self._times[0])}, expected at most {self._most} "
            f"per {show_duration(self._per_ns)}"
        )
        return _violation(message, now_ns, self._checks)


class _MutuallyExclusive(Monitor):
    never_counted = "none of it ever held"

    def __init__(self, item: MutuallyExclusiveProperty, conditions: Conditions) -> None:
        super().__init__(item, conditions)
        self._checks = conditions.checks(item, "mutually_exclusive")

    def _look(self, now_ns: int) -> Violation | None:
        holding = [check for check in self._checks if check.holds()]
        self.counted = self.counted or bool(holding)
        if len(holding) < 2:
            return None
        message = f"{_found(holding)} at the same instant, expected at most one of them"
        return _violation(message, now_ns, holding)


class _Eventually(Monitor):
    def __init__(self, item: EventuallyProperty, conditions: Conditions) -> None:
        super().__init__(item, conditions)
        self._checks = conditions.checks(item, "eventually")
        self._came = False

    def _look(self, now_ns: int) -> Violation | None:
        self._came = self._came or all_hold(self._checks)
        return None

    def end(self, now_ns: int) -> Violation | None:
        if self._came:
            return None
        wanted = " and ".join(f"{item.path} {item.demand.describe()}" for item in self._checks)
        message = f"at the end {_found(self._checks)}, expected at some instant {wanted}"
        return _violation(message, now_ns, self._checks)
