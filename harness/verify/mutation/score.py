"""Figures of a mutation run: of each block and of all."""

from collections.abc import Iterable, Sequence

from fbgen.dataclass import dataclass
from harness.verify.mutation.session import Tried
from harness.verify.mutation.verdict import Fate


@dataclass(frozen=True, slots=True)
class Score:
    """How many mutants there were and what came of them.

    What is equivalent does not count. `noticed` is what the checks noticed, `changed` what the
    stimuli changed in the plant, whether a check noticed or not; both in percent.
    """

    name: str
    total: int
    fates: dict[Fate, int]
    with_effect: int

    @property
    def counted(self) -> int:
        """The mutants that somebody could notice."""
        return self.total - sum(self.fates[fate] for fate in Fate if fate.is_equivalent)

    @property
    def noticed(self) -> float:
        """The score: killed mutants in percent of those that count; 100 if none counts."""
        return _percent(self.fates[Fate.KILLED], self.counted)

    @property
    def changed(self) -> float:
        """Mutants with an effect that can be seen, in percent of those that count."""
        return _percent(self.with_effect, self.counted)


def _percent(part: int, whole: int) -> float:
    return 100.0 * part / whole if whole else 100.0


def score_of(name: str, tried: Sequence[Tried]) -> Score:
    """The figures of some mutants."""
    fates = dict.fromkeys(Fate, 0)
    for one in tried:
        fates[one.verdict.fate] += 1
    return Score(name, len(tried), fates, sum(one.verdict.has_effect for one in tried))


def scores_of(tried: Iterable[Tried]) -> tuple[list[Score], Score]:
    """The figures of each block, in their order, and of all together."""
    by_block: dict[str, list[Tried]] = {}
    for one in tried:
        by_block.setdefault(one.target.name, []).append(one)
    every = [one for block in by_block.values() for one in block]
    return [score_of(name, block) for name, block in by_block.items()], score_of("all", every)
