"""The checker: what the text means, or everything that is wrong with it.

Start at `program`: it collects the declarations of all files (`library`, `type_names`,
`interfaces`, `initials`), then checks the statements of every block (`statements`, `expressions`,
`calls`). What the dialects allow stands in `rules`; the controller's own functions, blocks and
instructions are the tables `standard_functions`, `standard_blocks` and `system_instructions`.

Nothing is imported before it is asked for: whoever wants one of the tables needs no checker.
"""

from typing import TYPE_CHECKING

from fbgen.faces import member

if TYPE_CHECKING:
    from fbgen.lang.checker.program import check, check_reporting
    from fbgen.lang.checker.rules import RULES, Rules, rules_for

__all__ = ["RULES", "Rules", "check", "check_reporting", "rules_for"]

_HOMES = {
    "RULES": "rules",
    "Rules": "rules",
    "check": "program",
    "check_reporting": "program",
    "rules_for": "rules",
}


def __getattr__(name: str) -> object:
    return member(__name__, _HOMES, name)
