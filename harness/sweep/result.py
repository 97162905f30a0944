"""What a sweep has found: a point is what one combination gave, a result is all of them."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import field

from fbgen.blocks.line_times import LineTimes
from fbgen.dataclass import dataclass
from harness.sweep.conditions import Conditions
from harness.sweep.rules import Violation


@dataclass(frozen=True, slots=True)
class Point:
    """What came of one combination. `longest_ns` goes by what took so long."""

    requests: int
    telegrams: int
    longest_ns: Mapping[str, int]
    violations: tuple[Violation, ...]


@dataclass(frozen=True, slots=True)
class Worst:
    """The longest that something took under these conditions."""

    took_ns: int
    conditions: Conditions


@dataclass(slots=True)
class SweepResult:
    """What a sweep of `planned` combinations has found in those that it has run.

    `worst` goes by access way and what took so long; `times` has the bounds by access way and by
    what the catalogue says of the drives' reply time. `broken` counts the rules that did not hold,
    `examples` has the first case of each.
    """

    planned: int
    runs: int = 0
    requests: int = 0
    telegrams: int = 0
    worst: dict[tuple[str, int, str], Worst] = field(default_factory=dict)
    times: dict[tuple[str, int], LineTimes] = field(default_factory=dict)
    broken: Counter[str] = field(default_factory=Counter)
    examples: dict[str, tuple[Conditions, Violation]] = field(default_factory=dict)

    @property
    def passed(self) -> bool:
        """True if every rule held in every run, and all have run."""
        return self.runs == self.planned > 0 and bool(self.requests) and not self.broken

    def add(self, conditions: Conditions, point: Point, times: LineTimes) -> None:
        """One more. Which of equal ones is shown depends on the order: the first."""
        access, limit_ms = conditions.access, conditions.reply_max_ms
        self.runs += 1
        self.requests += point.requests
        self.telegrams += point.telegrams
        self.times[access, limit_ms] = times
        for violation in point.violations:
            self.broken[violation.rule] += 1
            self.examples.setdefault(violation.rule, (conditions, violation))
        if not conditions.in_time:
            return
        for kind, took_ns in point.longest_ns.items():
            worst = self.worst.get((access, limit_ms, kind))
            if worst is None or worst.took_ns < took_ns:
                self.worst[access, limit_ms, kind] = Worst(took_ns, conditions)
