"""The phases that a sweep goes through: every combination, or a sample spread evenly over them.

Nothing keeps the PLC's scan, the PROFIBUS cycle, the gateway's look at the trigger and the inverter
together: each runs on its own clock. Whatever lies between them in a plant is one of these
combinations, and a block must work in all of them.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

from fbgen.dataclass import dataclass
from harness.kernel import NS_PER_MS, NS_PER_US

ACCESS_LAYOUTS = {"per_identifier": "gsd10", "dpxx_dat": "whole10", "process_image": "gsd10"}
"""Each access way with a layout of the TOSPBDP001 whose identifiers allow it."""

_CATALOGUE_REPLY_MS = 20
_SLOW_REPLY_MS = 78
"""The longest reply time of a VF-nC1 (TOSPBDP001 manual v1.1, 9)."""

_GOLDEN = 0.6180339887498949


@dataclass(frozen=True, slots=True)
class Conditions:
    """One combination.

    `scan_offset_ns` is how much later than the bus grid and the gateway's supply the PLC starts.
    `reply_max_ms` is what the catalogue says of the drives, from which the blocks have their time
    limits; `reply_ns` is how long a drive really takes. `torn` is the probability that a bus cycle
    falls into a transfer that promises no consistency.
    """

    access: str = "per_identifier"
    drive_zero: bool = True
    reply_max_ms: int = _CATALOGUE_REPLY_MS
    torn: float = 0.0
    trigger_poll: bool = True
    bus_period_ns: int = 2 * NS_PER_MS
    scan_offset_ns: int = 0
    reply_ns: int = 10 * NS_PER_MS

    @property
    def in_time(self) -> bool:
        """Whether the drives answer as fast as the catalogue says."""
        return self.reply_ns <= self.reply_max_ms * NS_PER_MS

    @property
    def program(self) -> tuple[str, bool, int]:
        """What the PLC text depends on."""
        return self.access, self.drive_zero, self.reply_max_ms

    def __str__(self) -> str:
        drive = "with drive 0" if self.drive_zero else "without drive 0"
        poll = "on" if self.trigger_poll else "off"
        torn = f", torn {self.torn:g}" if self.torn else ""
        return (
            f"{self.access}, {drive}, scan +{self.scan_offset_ns / NS_PER_MS:g} ms, "
            f"PROFIBUS {self.bus_period_ns / NS_PER_MS:g} ms, trigger poll {poll}, "
            f"reply {self.reply_ns / NS_PER_MS:g} of {self.reply_max_ms} ms{torn}"
        )


@dataclass(frozen=True, slots=True)
class Axes:
    """What is combined with each other. Without arguments: everything that a plant can be like."""

    access: tuple[str, ...] = tuple(ACCESS_LAYOUTS)
    drive_zero: tuple[bool, ...] = (True, False)
    replies_ms: tuple[int, ...] = (*range(1, 21), 25, 31, 40, 52, 64, 78)
    trigger_poll: tuple[bool, ...] = (True, False)
    bus_periods_ms: tuple[int, ...] = (1, 2, 3, 4, 5)
    scan_offsets_ms: tuple[int, ...] = tuple(range(10))

    def every(self) -> Iterator[Conditions]:
        """Every combination. Those that share a program follow each other."""
        for base in self._programs():
            for reply, poll, period, offset in product(
                self.replies_ms, self.trigger_poll, self.bus_periods_ms, self.scan_offsets_ms
            ):
                yield replace(
                    base,
                    trigger_poll=poll,
                    bus_period_ns=period * NS_PER_MS,
                    scan_offset_ns=offset * NS_PER_MS,
                    reply_ns=reply * NS_PER_MS,
                )

    def _programs(self) -> Iterator[Conditions]:
        """What needs a program or an installation of its own."""
        for access, drive_zero in product(self.access, self.drive_zero):
            yield Conditions(access, drive_zero, _CATALOGUE_REPLY_MS)
            if access == "process_image":
                yield Conditions(access, drive_zero, _CATALOGUE_REPLY_MS, torn=1.0)
            yield Conditions(access, drive_zero, _SLOW_REPLY_MS)

    def spread(self, count: int) -> list[Conditions]:
        """So many of them, the same ones each time, with every value of every axis among them.

        Each axis is walked through at a pace of its own (multiples of the golden ratio), so that no
        two of them go together.
        """
        axes = (
            self.replies_ms,
            self.trigger_poll,
            self.bus_periods_ms,
            self.scan_offsets_ms,
        )
        programs = list(self._programs())
        found = []
        for number in range(count):
            reply, poll, period, offset = (
                axis[int(_GOLDEN ** (at + 1) * (number + 1) % 1 * len(axis))]
                for at, axis in enumerate(axes)
            )
            base = programs[number * len(programs) // count]
            found.append(
                replace(
                    base,
                    trigger_poll=bool(poll),
                    bus_period_ns=period * NS_PER_MS,
                    scan_offset_ns=offset * NS_PER_MS,
                    reply_ns=reply * NS_PER_MS,
                )
            )
        return found


def between_accesses(access: str, span_us: int = 60) -> Iterator[Conditions]:
    """The bus cycle between any two accesses to the hardware of one scan, microsecond by
    microsecond: a period of one scan, so that it falls there in each; the gateway looks at once."""
    for offset_us in range(1, span_us + 1):
        yield Conditions(
            access,
            trigger_poll=False,
            bus_period_ns=10 * NS_PER_MS,
            scan_offset_ns=10 * NS_PER_MS - offset_us * NS_PER_US,
        )
