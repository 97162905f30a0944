"""The help for a name that nobody knows: what is meant, most likely, and what there is."""

from collections.abc import Iterable
from difflib import get_close_matches

_LISTED = 12
_NEAR = 3
_SEARCHED = 300
"""Looking for near names among more than this takes longer than it helps."""
_ALIKE = 0.6
_LONGER = 2
"""Among many names only those are near that begin alike and have about the same length."""


def near_names(name: str, known: Iterable[str], alike: float = _ALIKE) -> list[str]:
    """Up to three known names that are spelled nearly so, the nearest first, or contain it.

    Upper and lower case and the difference between `-` and `_` do not count as distance. `alike`:
    which share of the letters is the same.
    """
    plain = {_plain(candidate): candidate for candidate in sorted(set(known))}
    wanted = _plain(name)
    beginning = 1
    while len(plain) > _SEARCHED:
        if beginning > len(wanted):
            return []
        plain = {
            candidate: spelled
            for candidate, spelled in plain.items()
            if candidate.startswith(wanted[:beginning])
            and abs(len(candidate) - len(wanted)) <= _LONGER
        }
        beginning += 1
    near = get_close_matches(wanted, plain, n=_NEAR, cutoff=alike)
    if not near and len(wanted) > 1:
        near = [candidate for candidate in plain if wanted in candidate][:_NEAR]
    return [plain[match] for match in near]


def nearest(name: str, known: Iterable[str]) -> str:
    """A help text: the nearest known names, or all of them if none is near."""
    names = sorted(set(known))
    if not names:
        return "there is none yet"
    if near := did_you_mean(name, names):
        return near
    listed = ", ".join(names[:_LISTED])
    return f"known: {listed}" + (", ..." if len(names) > _LISTED else "")


def did_you_mean(name: str, known: Iterable[str], alike: float = _ALIKE) -> str:
    """A help text with the nearest known names; empty if none is near."""
    near = near_names(name, known, alike)
    return "did you mean " + " or ".join(f"'{match}'" for match in near) + "?" if near else ""


def _plain(name: str) -> str:
    return name.lower().replace("-", "_")
