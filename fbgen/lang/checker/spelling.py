"""The help for a name that nobody knows: what is meant, most likely, or what there is."""

from collections.abc import Iterable
from difflib import get_close_matches

_LISTED = 12
_SEARCHED = 300
"""Looking for near names among more than this takes longer than it helps."""


def nearest(name: str, known: Iterable[str]) -> str:
    """A help text: the nearest known names, or the known ones if there are few.

    Upper and lower case do not count as distance, as in the PLC languages.
    """
    spelled = {candidate.casefold(): candidate for candidate in known}
    near: list[str] = []
    if len(spelled) <= _SEARCHED:
        near = get_close_matches(name.casefold(), spelled, n=3, cutoff=0.6)
    if near:
        return "did you mean " + " or ".join(f"'{spelled[match]}'" for match in near) + "?"
    if not spelled:
        return "there is none to choose from"
    if len(spelled) <= _LISTED:
        return "known: " + ", ".join(sorted(spelled.values()))
    return "check the spelling, or declare it"
