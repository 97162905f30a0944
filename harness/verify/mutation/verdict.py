"""What came of a mutant, as plain data that goes to other processes and into files."""

from dataclasses import asdict
from enum import Enum

from fbgen.dataclass import dataclass


class Fate(Enum):
    """What came of a mutant."""

    KILLED = "killed"
    SURVIVED = "survived"
    UNCHANGED = "unchanged"
    UNREACHED = "unreached"
    PROVED = "proved"
    EXPLAINED = "explained"

    @property
    def is_equivalent(self) -> bool:
        """True for what nobody can tell from the block."""
        return self in (Fate.PROVED, Fate.EXPLAINED)

    @property
    def meaning(self) -> str:
        """In words."""
        return _MEANINGS[self]


_MEANINGS = {
    Fate.KILLED: "a check failed",
    Fate.SURVIVED: "scenarios ran into it, and no check noticed",
    Fate.UNCHANGED: "reached, but never with values for which it makes a difference",
    Fate.UNREACHED: "no scenario reaches its statement",
    Fate.PROVED: "equivalent: an SMT solver has proved it",
    Fate.EXPLAINED: "equivalent: somebody has given a reason",
}


@dataclass(frozen=True, slots=True)
class Verdict:
    """What came of one mutant.

    `scenario` is the one that killed it, `message` the first check that failed, `at_ns` when, in
    the plant's time. `runs` counts the scenarios that were run. For a survivor `effect` says what
    a scenario changes that could be seen from outside, "" if nothing; `why` is the reason of an
    equivalent one.
    """

    id: str
    fate: Fate
    scenario: str = ""
    message: str = ""
    at_ns: int = 0
    runs: int = 0
    effect: str = ""
    why: str = ""

    @property
    def has_effect(self) -> bool:
        """True if the stimuli of some scenario change what can be seen from outside."""
        return self.fate is Fate.KILLED or bool(self.effect)

    def as_json(self) -> dict[str, object]:
        """As plain data; what says nothing is left out."""
        found = {name: value for name, value in asdict(self).items() if value}
        return {**found, "fate": self.fate.value}

    @classmethod
    def from_json(cls, data: dict[str, object]) -> "Verdict":
        """What `as_json` has given."""
        return cls(**{**data, "fate": Fate(data["fate"])})  # type: ignore[arg-type]
