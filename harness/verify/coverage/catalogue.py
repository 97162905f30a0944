"""Catalogue coverage: what the catalogue says about devices, and what of it tests have exercised.

Items stand in groups, such as the bits of the gateway's words or the trips; each is exercised or
not. What runs know is collected here; status codes and sequence steps follow from the statements
that ran (`derived`).
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from harness.verify.coverage.totals import Count

GATEWAY_WORDS = "bits of the gateway's words"
WRITTEN_WORDS = "bits written to drives"
READ_WORDS = "bits read from drives"
WRITTEN = "ComNos written"
READ = "ComNos read"
TRIPS = "trips"
PARAMETER_ERRORS = "error codes of parameter channels"
DIAGNOSIS = "bits of the slave's diagnosis"
REFUSALS = "error replies and exceptions"
LAMPS = "lamps of DeviceNet options"
GENERAL_STATUS = "general status codes"
TIMEOUT_ACTIONS = "actions when DeviceNet is lost"
READ_RESULTS = "RET_VAL of DPRD_DAT (SFC14)"
WRITE_RESULTS = "RET_VAL of DPWR_DAT (SFC15)"
STEPS = "sequence steps"
CODES = "status codes of blocks"
GROUPS = (
    *(GATEWAY_WORDS, WRITTEN_WORDS, READ_WORDS, WRITTEN, READ, TRIPS),
    *(PARAMETER_ERRORS, DIAGNOSIS, REFUSALS, LAMPS, GENERAL_STATUS, TIMEOUT_ACTIONS),
    *(READ_RESULTS, WRITE_RESULTS, STEPS, CODES),
)
"""The groups in the order in which they are shown."""


class GroupCoverage(NamedTuple):
    """One group: how much of it was exercised, and what was not."""

    name: str
    exercised: Count
    missing: Sequence[str]


class CatalogueCoverage:
    """Items by group; True for those that were exercised."""

    __slots__ = ("items",)

    def __init__(self) -> None:
        self.items: dict[str, dict[str, bool]] = {}

    def know(self, group: str, items: Iterable[str]) -> None:
        """Say what there is to exercise."""
        known = self.items.setdefault(group, {})
        for item in items:
            known.setdefault(item, False)

    def see(self, group: str, item: str) -> None:
        """An item was exercised; what the catalogue does not know is left out."""
        known = self.items.get(group)
        if known is not None and item in known:
            known[item] = True

    def merge(self, others: Iterable[Mapping[str, Mapping[str, bool]]]) -> None:
        """Take over what other runs have exercised."""
        for other in others:
            for group, items in other.items():
                known = self.items.setdefault(group, {})
                for item, seen in items.items():
                    known[item] = known.get(item, False) or seen

    def groups(self) -> Iterator[GroupCoverage]:
        """The groups that have something in them, in their order."""
        for name in GROUPS:
            items = self.items.get(name, {})
            if items:
                missing = [item for item, seen in items.items() if not seen]
                yield GroupCoverage(name, Count(len(items) - len(missing), len(items)), missing)

    def total(self) -> Count:
        """All groups together."""
        total = Count(0, 0)
        for group in self.groups():
            total = total.plus(group.exercised)
        return total
