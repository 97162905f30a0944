"""Which blocks are mutated: those of some files, or each block that some program has."""

import hashlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from fbgen.diagnostics import DiagnosticError, error
from fbgen.nearest import nearest
from harness.verify.mutation.homes import Homes
from harness.verify.mutation.stage import Stage, Subject


@dataclass(frozen=True, slots=True)
class Target:
    """A block that is mutated, and the cases whose program has the very same block.

    `name` is the name of the block; with the plant in front of it where plants have different
    blocks of one name. `home` is the case that the mutants are taken from.
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
    targets = []
    for key, subject in subjects.items():
        cases = found[key]
        name = key[0]
        home = next(case for case in cases if _is_home(homes, case, name))
        shown = f"{stage.place(home)}/{name}" if there.count(name) > 1 else name
        targets.append(Target(shown, subject, home, tuple(cases)))
    return targets


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
