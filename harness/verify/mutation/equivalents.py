"""The file of reasons: mutants that nobody can tell from the block, though no solver proves it.

    version: 1
    equivalents:
      - block: TOS_Telegram
        mutant: m3f2a91c0d4
        reason: the timer is not looked at while no telegram is under way

A reason is believed only while no check notices the mutant and it changes nothing in the plant, and
for at most 5 percent of all mutants.
"""

import hashlib
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog import Located, load_yaml, validate
from fbgen.catalog.catalog import read_source
from fbgen.catalog.scalars import Text
from fbgen.diagnostics import Diagnostic
from harness.verify.mutation.mutant import Mutant
from harness.verify.mutation.texts import changed_lines

FILE_NAME = "mutation-equivalents.yaml"
"""How the file is called where nobody names another one: beside the scenarios."""
MOST_PERCENT = 5
"""How many of all mutants may be equivalent by reasons alone."""


class Equivalent(Located):
    """A mutant of a block that is equivalent, and why."""

    block: Text = Field(description="The block as it is called without a prefix of the plant")
    mutant: Annotated[Text, Field(pattern="^m[0-9a-f]{10}$")] = Field(
        description="The fingerprint that the report shows behind the mutant"
    )
    reason: Text = Field(description="Why nobody can tell it from the block")

    @property
    def key(self) -> tuple[str, str]:
        """Block, folded, and fingerprint."""
        return self.block.casefold(), self.mutant

    def stale(self, why: str) -> Diagnostic:
        """FB8068."""
        message = f"the entry for {self.mutant} of {self.block} {why}"
        return Diagnostic("FB8068", message, self.span, "leave it out")


class Equivalents(Located):
    """The file."""

    version: Literal[1] = Field(description="Version of this format")
    equivalents: tuple[Equivalent, ...] = Field(description="One entry for each mutant")

    def problems(self) -> Iterable[Diagnostic]:
        """FB8068 for what is there twice."""
        seen: set[tuple[str, str]] = set()
        for entry in self.equivalents:
            if entry.key in seen:
                yield entry.stale("is there a second time")
            seen.add(entry.key)

    def reason(self, block: str, mutant: str) -> str:
        """Why a mutant is equivalent; "" without an entry."""
        key = block.casefold(), mutant
        return next((entry.reason for entry in self.equivalents if entry.key == key), "")


NO_REASONS = Equivalents(version=1, equivalents=())


def load_equivalents(path: Path) -> Equivalents:
    """A file of reasons. Raises DiagnosticError FB1001 to FB1008 and FB8068."""
    return validate(load_yaml(read_source(path, path.as_posix())), Equivalents)


def fingerprints(mutants: Sequence[Mutant]) -> tuple[str, ...]:
    """What each mutant of a block is called in the file.

    It is made of the lines that change, so that it stays where others come and go around them.
    """
    numbers: Counter[str] = Counter()
    found: list[str] = []
    for mutant in mutants:
        lines = "\n".join(changed_lines(mutant))
        text = f"{mutant.block.name.casefold()}\n{mutant.operator.value}\n{lines}"
        numbers[text] += 1
        digest = hashlib.sha256(f"{text}\n{numbers[text]}".encode()).hexdigest()
        found.append(f"m{digest[:10]}")
    return tuple(found)
