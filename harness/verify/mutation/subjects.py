"""Which blocks are mutated: those of one plant, or each block that some plant has."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass

from fbgen.diagnostics import DiagnosticError, error
from fbgen.nearest import nearest
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
    stage: Stage, wanted: Sequence[str] = (), homes: Sequence[int] | None = None
) -> list[Target]:
    """The blocks to be mutated, in the order of the programs; all without `wanted`.

    With `homes` only the blocks of these cases' programs. Raises DiagnosticError FB8060 for names
    that no program has.
    """
    found: dict[tuple[str, str], tuple[int, list[int]]] = {}
    for case in range(len(stage.cases)):
        for block in stage.program(case).bodies:
            subject = stage.subject(case, block.name)
            if subject is not None and subject.mutants:
                found.setdefault((block.name, subject.key), (case, []))[1].append(case)
    if homes is not None:
        found = {
            key: (home, cases)
            for key, (_, cases) in found.items()
            if (home := next((case for case in cases if case in homes), None)) is not None
        }
    names = [name for name, _ in found]
    known = {name.casefold() for name in names}
    chosen = {name.casefold() for name in wanted} or known
    if not chosen <= known:
        raise _unknown(next(name for name in wanted if name.casefold() not in known), names)
    targets = []
    for (name, _), (home, cases) in found.items():
        subject = stage.subject(home, name)
        if name.casefold() in chosen and subject is not None:
            several = names.count(name) > 1
            shown = f"{stage.place(home)}/{name}" if several else name
            targets.append(Target(shown, subject, home, tuple(cases)))
    return targets


def _unknown(name: str, known: Sequence[str]) -> DiagnosticError:
    return error(
        "FB8060",
        f"no plant of these scenarios has a block '{name}' with statements",
        help=nearest(name, sorted(set(known))),
    )


def contents_of(stage: Stage, targets: Sequence[Target]) -> str:
    """One text for everything that the verdicts on the mutants of these blocks depend on."""
    digest = hashlib.sha256()
    for target in targets:
        digest.update(f"{target.name} {target.subject.key}\n".encode())
    for case, scenario in enumerate(stage.cases):
        digest.update(f"{scenario.name}\n{scenario.scenario.model_dump_json()}\n".encode())
        for block in stage.program(case).bodies:
            subject = stage.subject(case, block.name)
            digest.update((subject.key if subject else "").encode())
    return digest.hexdigest()[:16]
