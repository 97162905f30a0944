"""The rules of a scenario: looked at behind every scan, told when the step is over."""

from collections.abc import Mapping, Sequence

from fbgen.diagnostics import Diagnostic, DiagnosticError, Note
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.rules import RULES, Watch
from harness.scenario.model import Scenario

_ALL = "all"
_TOLD = 3


class RuleChecks:
    """The rules that are asked for, on one plant."""

    def __init__(
        self, plant: Installation | None, names: Sequence[str], place: Span | None
    ) -> None:
        self._place = place
        self._watches: Mapping[str, Watch] = {}
        self._broken: list[tuple[int, str, str]] = []
        if plant is not None and names:
            self._watches = {name: RULES[name].watch(plant) for name in names}
            self._kernel = plant.kernel
            plant.cpu.after_scan.append(self._look)

    def check(self) -> None:
        """Raises DiagnosticError FB8070 for the first rules that were broken."""
        if not self._watches:
            return
        self._look()
        if self._broken:
            raise DiagnosticError([self._told(*item) for item in self._broken[:_TOLD]])

    def _look(self) -> None:
        for name, watch in self._watches.items():
            for text in watch():
                self._broken.append((self._kernel.now_ns, name, text))

    def _told(self, time_ns: int, name: str, text: str) -> Diagnostic:
        when = Note(f"at {time_ns / NS_PER_MS:.3f} ms of the plant's time")
        return Diagnostic(
            "FB8070", f"the rule '{name}' is broken: {text}", self._place, notes=(when,)
        )


def prepare_rules(scenario: Scenario, plant: Installation) -> RuleChecks:
    """The rules of a scenario. Raises DiagnosticError FB8071 for unknown ones."""
    unknown = [name for name in scenario.rules if name not in RULES and name != _ALL]
    place = scenario.span_of("rules")
    if unknown:
        raise DiagnosticError(
            [
                Diagnostic(
                    "FB8071", f"there is no rule '{name}'", place, nearest(name, [_ALL, *RULES])
                )
                for name in unknown
            ]
        )
    chosen = list(RULES) if _ALL in scenario.rules else list(dict.fromkeys(scenario.rules))
    return RuleChecks(plant, chosen, place)
