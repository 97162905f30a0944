"""Rules of a plant that hold whatever goes wrong around it, one file each, with their `RULE`."""

from fbgen.named_modules import NamedModules
from harness.rules.rule import Rule, Watch

__all__ = ["RULES", "Rule", "Watch"]

_NAMES = (
    "cpu_runs",
    "inputs_shown",
    "jobs_answered",
    "lost_is_told",
    "no_command_unasked",
    "no_run_again",
    "one_telegram_at_once",
    "repeats_allowed",
    "telegrams_asked_for",
    "telegrams_spaced",
    "values_answered",
)

RULES: NamedModules[Rule] = NamedModules("harness.rules", "RULE", _NAMES)
"""By the name that scenarios use, which is that of the module."""
