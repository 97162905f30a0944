"""Rules of a plant that hold whatever goes wrong around it, one file each, with their `RULE`."""

from collections.abc import Mapping
from types import MappingProxyType

from harness.rules import (
    cpu_runs,
    inputs_shown,
    jobs_answered,
    lost_is_told,
    no_command_unasked,
    no_run_again,
    one_telegram_at_once,
    repeats_allowed,
    telegrams_asked_for,
    telegrams_spaced,
    values_answered,
)
from harness.rules.rule import Rule, Watch

__all__ = ["RULES", "Rule", "Watch"]

_MODULES = (
    *(cpu_runs, inputs_shown, jobs_answered, lost_is_told, no_command_unasked, no_run_again),
    *(
        one_telegram_at_once,
        repeats_allowed,
        telegrams_asked_for,
        telegrams_spaced,
        values_answered,
    ),
)

RULES: Mapping[str, Rule] = MappingProxyType({item.RULE.name: item.RULE for item in _MODULES})
"""By the name that scenarios use."""
