"""The checker: what the text means, or everything that is wrong with it.

Start at `program`: it collects the declarations of all files (`library`, `type_names`,
`interfaces`, `initials`), then checks the statements of every block (`statements`, `expressions`,
`calls`). What the dialects allow stands in `rules`; the controller's own functions, blocks and
instructions are the tables `standard_functions`, `standard_blocks` and `system_instructions`.

Nothing is imported before it is asked for: whoever wants one of the tables needs no checker.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fbgen.lang.checker.program import check, check_reporting
    from fbgen.lang.checker.rules import RULES, Rules, rules_for

__all__ = ["RULES", "Rules", "check", "check_reporting", "rules_for"]

_HOMES = {"check": "program", "check_reporting": "program"}


def __getattr__(name: str) -> object:
    if name not in __all__:
        raise AttributeError(f"module 'fbgen.lang.checker' has no attribute '{name}'")
    return getattr(import_module(f"{__name__}.{_HOMES.get(name, 'rules')}"), name)
