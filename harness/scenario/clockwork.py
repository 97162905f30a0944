"""What goes on beside the steps of a scenario: faults by the clock, and rules of the plant."""

from fbgen.diagnostics import error
from harness.scenario.fault_plans import ClockFault, prepare_faults
from harness.scenario.model import Scenario
from harness.scenario.rule_checks import RuleChecks, prepare_rules
from harness.scenario.stage import Stage


def clockwork(scenario: Scenario, stage: Stage) -> tuple[list[ClockFault], RuleChecks]:
    """The faults by the clock and the rules of a scenario, ready for its stage.

    Raises DiagnosticError with everything that the plant does not allow; FB8018 for a block.
    """
    plant = stage.installation
    if plant is not None:
        return prepare_faults(scenario.faults, plant), prepare_rules(scenario, plant)
    for key in ("faults", "rules"):
        if getattr(scenario, key):
            raise error(
                "FB8018",
                "a block on its own has no devices around it",
                scenario.span_of(key),
                f"leave out {key}:, or leave out block: and test it in its plant",
            )
    return [], RuleChecks(None, (), None)
