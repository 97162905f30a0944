"""Which blocks are mutated: those of some files, or each block that some program has."""

import hashlib
from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.nearest import nearest
from harness.verify.mutation.homes import Homes
from harness.verify.mutation.stage import Stage, Subject


@dataclass(frozen=True, slots=True)
class Target:
    """A block that is mutated, and the cases whose program has the very same block.

    `name` is the name of the block; with the plant in front of it where there are different blocks
    of one name. `home` is the case that the mutants are taken from.
    """

    name: str
    subject: Subject
    home: int
    cases: tuple[int, ...]

    def id_of(self, number: int) -> str:
        """The id of a mutant: with the plant in front where the name of the block has it."""
        plant, slash, _ = self.name.rpartition("/")
        return f"{plant}{slash}{self.subject.mutants[number].id}"


def targets_of(
    stage: Stage, wanted: Sequence[str] = (), homes: Homes | None = None
) -> list[Target]:
    """The blocks to be mutated, in the order of the programs; all without `wanted`.

    With `homes` only those blocks of those cases' programs. Raises DiagnosticError FB8060 for names
    that no program has.
    """
    names = {name.casefold() for name in wanted}
    found: dict[tuple[str, str], list[int]] = {}
    subjects: dict[tuple[str, str], Subject] = {}
    for case in range(len(stage.cases)):
        for block in stage.program(case).bodies:
            if names and block.name.casefold() not in names:
                continue
            subject = stage.subject(case, block.name)
            if subject is not None:
                found.setdefault((block.name, subject.key), []).append(case)
                if _is_home(homes, case, block.name):
                    subjects.setdefault((block.name, subject.key), subject)
    subjects = {key: subject for key, subject in subjects.items() if subject.mutants}
    there = [name for name, _ in subjects]
    for name in wanted:
        if name.casefold() not in {one.casefold() for one in there}:
            raise _unknown(name, _with_statements(stage, homes))
    chosen = {
        key: next(case for case in found[key] if _is_home(homes, case, key[0])) for key in subjects
    }
    shown = _shown(stage, [(name, chosen[name, key]) for name, key in subjects])
    return [
        Target(name, subject, chosen[key], tuple(found[key]))
        for name, (key, subject) in zip(shown, subjects.items(), strict=True)
    ]


def _shown(stage: Stage, blocks: Sequence[tuple[str, int]]) -> list[str]:
    """A name for each block with its home, no two of them the same.

    With the plant in front where one is not enough, then with what the case changes of the plant,
    then with a number.
    """
    ways: tuple[Callable[[str, int], str], ...] = (
        lambda name, home: name,
        lambda name, home: f"{stage.place(home)}/{name}",
        lambda name, home: f"{stage.place(home)}{stage.cases[home].changes}/{name}",
    )
    shown = [ways[0](*block) for block in blocks]
    for way in ways[1:]:
        count = Counter(shown)
        shown = [
            way(*block) if count[before] > 1 else before
            for before, block in zip(shown, blocks, strict=True)
        ]
    count = Counter(shown)
    seen: Counter[str] = Counter()
    for number, name in enumerate(shown):
        seen[name] += 1
        if count[name] > 1:
            plant, _, block = name.rpartition("/")
            shown[number] = f"{plant} {seen[name]}/{block}"
    return shown


def _is_home(homes: Homes | None, case: int, name: str) -> bool:
    """Whether the mutants of a block may be taken from a case."""
    if homes is None:
        return True
    names = homes.get(case, ())
    return names is None or name in names


def _with_statements(stage: Stage, homes: Homes | None) -> list[str]:
    """The names of all blocks that could be named."""
    return [
        block.name
        for case in range(len(stage.cases))
        for block in stage.program(case).bodies
        if _is_home(homes, case, block.name)
    ]


def _unknown(name: str, known: Sequence[str]) -> DiagnosticError:
    return error(
        "FB8060",
        f"no plant of these scenarios has a block '{name}' with statements",
        help=nearest(name, sorted(set(known))),
    )


def contents_of(stage: Stage, case: int) -> str:
    """One text for everything that the verdicts of a case depend on."""
    one = stage.cases[case]
    parts = (one.name, one.seed, one.scenario.model_dump_json(), stage.plan_of(case))
    return _digest((*map(str, parts), program_key(stage, case)))


def program_key(stage: Stage, case: int) -> str:
    """One text for all blocks of the program of a case."""
    blocks = (block.name for block in stage.program(case).bodies)
    found = ((name, stage.subject(case, name)) for name in blocks)
    return _digest(f"{name} {subject.key}" for name, subject in found if subject is not None)


def _digest(parts: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]
