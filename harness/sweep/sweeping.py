"""Through all the phases: run after run, the rules checked, the worst times kept.

result = Sweep(load_plant("plant.yaml", catalog), catalog).through(Axes().spread(200))
print(report(result))
"""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache

from fbgen.blocks.line_times import LineTimes, line_times
from fbgen.catalog import Catalog
from fbgen.diagnostics import error
from fbgen.plant import Plant
from fbgen.source import Source
from harness.installation import generated_sources
from harness.kernel import NS_PER_MS
from harness.sweep.conditions import Conditions
from harness.sweep.emergency import stop_script
from harness.sweep.requests import READ
from harness.sweep.result import Point, SweepResult
from harness.sweep.rig import Alteration, Observation, Rig, plant_in, with_reply_time
from harness.sweep.rules import Expected, Violation, violations
from harness.sweep.script import refused_request, script

_GATEWAY = "tospbdp001"
_LEAST_DRIVES = 2


class Sweep:
    """A plant with one gateway, gone through in many conditions."""

    def __init__(self, plan: Plant, catalog: Catalog, alteration: Alteration | None = None) -> None:
        """Raises DiagnosticError FB8075 for a plant that cannot be swept."""
        _sweepable(plan)
        self._plan = plan
        self._catalog = lru_cache(lambda limit_ms: with_reply_time(catalog, limit_ms))
        self._times = lru_cache(self._line_times)
        self._alteration = alteration
        self._rig: Rig | None = None

    def through(self, conditions: Sequence[Conditions]) -> SweepResult:
        """One run for each of these. Conditions that share a program should follow each other."""
        points = ((item, self.point(item)) for item in conditions)
        return self.result(points, len(conditions))

    def point(self, conditions: Conditions) -> Point:
        """Run one combination. What it gives depends on nothing that ran before."""
        if self._rig is None or not self._rig.suits(conditions):
            catalog = self._catalog(conditions.reply_max_ms)
            self._rig = Rig(self._plan, catalog, conditions, self._alteration)
        return _point(self._rig, conditions)

    def result(self, points: Iterable[tuple[Conditions, Point]], planned: int) -> SweepResult:
        """What these points are together, of so many that were to be run."""
        result = SweepResult(planned)
        for conditions, point in points:
            result.add(conditions, point, self._times(Conditions(*conditions.program)))
        return result

    def sources(self, conditions: Conditions) -> list[Source]:
        """The PLC text that these conditions run."""
        catalog = self._catalog(conditions.reply_max_ms)
        return generated_sources(plant_in(self._plan, conditions), catalog)

    def _line_times(self, base: Conditions) -> LineTimes:
        plan = plant_in(self._plan, base)
        return line_times(plan, plan.gateways[0], self._catalog(base.reply_max_ms))


def _sweepable(plan: Plant) -> None:
    entry = plan.gateways[0]
    numbered = [item for item in entry.drives if item.inv_no]
    if len(plan.gateways) == 1 and entry.type == _GATEWAY and len(numbered) >= _LEAST_DRIVES:
        return
    raise error(
        "FB8075",
        f"the plant '{plan.name}' cannot be swept",
        (plan.gateways[1] if len(plan.gateways) > 1 else entry).span_of("name"),
        f"a sweep takes one gateway, a {_GATEWAY}, with at least {_LEAST_DRIVES} drives beside "
        "drive 0",
    )


def _point(rig: Rig, conditions: Conditions) -> Point:
    expected = Expected(
        round(rig.times.telegram_ms * NS_PER_MS),
        round(rig.times.first_read_ms * NS_PER_MS),
        frozenset({refused_request(rig.inv_nos).telegram}),
        rig.spacers,
        rig.inv_nos,
    )
    seen = rig.run(conditions, script(rig.inv_nos))
    found = violations(seen, expected)
    longest_ns = _longest(seen)
    stop = rig.run(conditions, stop_script(rig.inv_nos, conditions))
    stop_ns = stop.stop_latency_ns
    bound_ns = round(rig.times.emergency_stop_ms * NS_PER_MS)
    if stop_ns is None or stop_ns > bound_ns:
        took = "did not go out" if stop_ns is None else f"took {stop_ns / NS_PER_MS:g} ms"
        found.append(Violation("the emergency stop in time", f"its broadcast {took}"))
    if stop_ns is not None:
        longest_ns["emergency stop"] = stop_ns
    telegrams = len(seen.frames) + len(stop.frames)
    return Point(len(seen.outcomes), telegrams, longest_ns, tuple(found))


def _longest(seen: Observation) -> dict[str, int]:
    """The longest time of each kind of end, of requests that were asked for alone."""
    together: Mapping[int, int] = Counter(outcome.posted_ns for outcome in seen.outcomes)
    longest_ns: dict[str, int] = {}
    for outcome in seen.outcomes:
        if outcome.ended_ns is None or together[outcome.posted_ns] > 1:
            continue
        if not outcome.done:
            kind = "error"
        elif not outcome.request.reply_expected:
            kind = "done without reply"
        else:
            kind = "read done" if outcome.request.cmd == READ else "write done"
        took_ns = outcome.ended_ns - outcome.posted_ns
        longest_ns[kind] = max(took_ns, longest_ns.get(kind, 0))
    return longest_ns
