"""Through all the phases: run after run, the rules checked, the worst times kept.

result = Sweep(load_plant("plant.yaml", catalog), catalog).through(Axes().spread(200))
print(report(result))
"""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from fbgen.blocks.line_times import LineTimes
from fbgen.catalog import Catalog
from fbgen.plant import Plant
from harness.kernel import NS_PER_MS
from harness.sweep.conditions import Conditions
from harness.sweep.emergency import stop_script
from harness.sweep.requests import READ
from harness.sweep.rig import Alteration, Observation, Rig, with_reply_time
from harness.sweep.rules import Expected, Violation, violations
from harness.sweep.script import refused_request, script

Progress = Callable[[int], None]
"""Told after each run how many there were."""


@dataclass(frozen=True, slots=True)
class Worst:
    """The longest that something took under these conditions."""

    took_ns: int
    conditions: Conditions


@dataclass(slots=True)
class SweepResult:
    """What a sweep has found.

    `worst` goes by access way and what took so long; `times` has the bounds by access way and by
    what the catalogue says of the drives' reply time. `broken` counts the rules that did not hold,
    `examples` has the first case of each.
    """

    runs: int = 0
    requests: int = 0
    telegrams: int = 0
    worst: dict[tuple[str, int, str], Worst] = field(default_factory=dict)
    times: dict[tuple[str, int], LineTimes] = field(default_factory=dict)
    broken: Counter[str] = field(default_factory=Counter)
    examples: dict[str, tuple[Conditions, Violation]] = field(default_factory=dict)

    @property
    def passed(self) -> bool:
        """True if every rule held in every run, and there were some."""
        return bool(self.requests) and not self.broken


class Sweep:
    """A plant with one gateway, gone through in many conditions."""

    def __init__(self, plan: Plant, catalog: Catalog, alteration: Alteration | None = None) -> None:
        self._plan = plan
        self._catalog = catalog
        self._catalogs: dict[int, Catalog] = {}
        self._alteration = alteration

    def through(
        self, conditions: Iterable[Conditions], progress: Progress | None = None
    ) -> SweepResult:
        """One run for each of these. Conditions that share a program should follow each other."""
        result = SweepResult()
        rig: Rig | None = None
        for item in conditions:
            if rig is None or not rig.suits(item):
                rig = self._rig(item)
            self._one(rig, item, result)
            if progress is not None:
                progress(result.runs)
        return result

    def _rig(self, conditions: Conditions) -> Rig:
        limit = conditions.reply_max_ms
        if limit not in self._catalogs:
            self._catalogs[limit] = with_reply_time(self._catalog, limit)
        return Rig(self._plan, self._catalogs[limit], conditions, self._alteration)

    def _one(self, rig: Rig, conditions: Conditions, result: SweepResult) -> None:
        steps = script(rig.inv_nos)
        result.times[conditions.access, conditions.reply_max_ms] = rig.times
        expected = Expected(
            round(rig.times.telegram_ms * NS_PER_MS),
            frozenset({refused_request(rig.inv_nos).telegram}),
            rig.spacers,
            rig.inv_nos,
        )
        seen = rig.run(conditions, steps)
        found = violations(seen, expected)
        _keep_worst(seen, result.worst)
        stop = rig.run(conditions, stop_script(rig.inv_nos, conditions))
        stop_ns = stop.stop_latency_ns
        bound_ns = round(rig.times.emergency_stop_ms * NS_PER_MS)
        if stop_ns is None or stop_ns > bound_ns:
            took = "did not go out" if stop_ns is None else f"took {stop_ns / NS_PER_MS:g} ms"
            found.append(Violation("the emergency stop in time", f"its broadcast {took}"))
        if stop_ns is not None:
            _longest(result.worst, conditions, "emergency stop", stop_ns)
        result.runs += 1
        result.requests += len(seen.outcomes)
        result.telegrams += len(seen.frames) + len(stop.frames)
        for violation in found:
            result.broken[violation.rule] += 1
            result.examples.setdefault(violation.rule, (conditions, violation))


def _keep_worst(seen: Observation, worst: dict[tuple[str, int, str], Worst]) -> None:
    together: Mapping[int, int] = Counter(outcome.posted_ns for outcome in seen.outcomes)
    for outcome in seen.outcomes:
        if outcome.ended_ns is None or together[outcome.posted_ns] > 1:
            continue
        if not outcome.done:
            kind = "error"
        elif not outcome.request.reply_expected:
            kind = "done without reply"
        else:
            kind = "read done" if outcome.request.cmd == READ else "write done"
        _longest(worst, seen.conditions, kind, outcome.ended_ns - outcome.posted_ns)


def _longest(
    worst: dict[tuple[str, int, str], Worst], conditions: Conditions, kind: str, took_ns: int
) -> None:
    key = conditions.access, conditions.reply_max_ms, kind
    if conditions.in_time and (key not in worst or worst[key].took_ns < took_ns):
        worst[key] = Worst(took_ns, conditions)
