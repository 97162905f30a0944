"""Paths with what is demanded of them, resolved for one plant."""

from collections.abc import Iterator

from fbgen.catalog import Located
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.source import Span
from harness.scenario.kinds import Found
from harness.scenario.named_things import Readable
from harness.scenario.places import key_span, value_span
from harness.scenario.stage import Stage
from harness.scenario.values import Demand, demand


@dataclass(frozen=True, slots=True)
class Check:
    """One path with what is demanded of it; `place` is the path in the file."""

    path: str
    place: Span | None
    source: Readable
    demand: Demand

    def holds(self) -> bool:
        """Whether it is now as demanded."""
        return self.demand.holds(self.source.get())

    def show(self, value: Found) -> str:
        """A value of this path for a person."""
        return self.source.kind.show(value)


def all_hold(checks: tuple[Check, ...]) -> bool:
    """Whether all of it is as demanded at this instant."""
    # Asked every millisecond, and a generator takes longer than the checks.
    for check in checks:  # noqa: SIM110
        if not check.demand.holds(check.source.get()):
            return False
    return True


class Conditions:
    """Resolves the conditions of a scenario; `found` has everything that is wrong in them."""

    def __init__(self, stage: Stage, found: list[Diagnostic]) -> None:
        self._stage = stage
        self._found = found

    def checks(self, model: Located, field: str) -> tuple[Check, ...]:
        """The conditions in a field of a model; without those that are wrong."""
        return tuple(self._each(model, field))

    def _each(self, model: Located, field: str) -> Iterator[Check]:
        for path, expected in (getattr(model, field) or {}).items():
            place = key_span(model, field, path)
            there = value_span(model, field, path)
            try:
                source = self._stage.paths.readable(path, place)
                wanted = demand(path, expected, source.kind, there, self._stage.catalog)
                yield Check(path, place, source, wanted)
            except DiagnosticError as wrong:
                self._found += wrong.diagnostics
